// What CLI11 knows of the command line, as the manual page and the completions of shells need it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wander::packaging {

// What can be completed in the place of a value.
enum class Values { files, methods, list_of_methods, scenes, gallery_names };

struct OptionEntry {
  std::vector<std::string> names;  // "-m", "--method"
  std::string value;               // what stands for it in the help; empty: a flag
  std::string help;
  std::vector<std::string> words;  // all values that there are, where they can be listed
  Values values = Values::files;
  bool is_common = false;  // of every verb
};

struct VerbEntry {
  std::string name, summary, footer;
  std::vector<OptionEntry> options, positionals;
};

std::vector<VerbEntry> verb_table(CLI::App& app);
std::vector<OptionEntry> common_options(CLI::App& app);
std::vector<std::string> gallery_names();

}  // namespace wander::packaging
