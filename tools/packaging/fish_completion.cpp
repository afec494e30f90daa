#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "tools/packaging/completions.h"
#include "tools/packaging/option_table.h"

namespace wander::packaging {

namespace {

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "'";
}

std::string words_of(const OptionEntry& option) {
  const std::string words = fmt::format("{}", fmt::join(option.words, " "));
  return quoted(option.values == Values::list_of_methods ? "(__fish_append , " + words + ")"
                                                         : words);
}

std::string line_of(const std::string& condition, const OptionEntry& option) {
  std::string line = fmt::format("complete -c wander -n {}", quoted(condition));
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.value.empty())
    line += " -f";
  else if (option.words.empty())
    line += " -r";
  else
    line += " -x -a " + words_of(option);
  return line + " -d " + quoted(option.help) + "\n";
}

std::string lines_of(const VerbEntry& verb) {
  const std::string condition = "__fish_seen_subcommand_from " + verb.name;
  std::string text;
  for (const OptionEntry& option : verb.options) text += line_of(condition, option);
  const OptionEntry& what = verb.positionals.front();
  return text + fmt::format("complete -c wander -n {} {}-a {} -d 'scene of the gallery'\n",
                            quoted(condition), what.values == Values::scenes ? "" : "-f ",
                            words_of(what));
}

}  // namespace

std::string fish_completion(CLI::App& app) {
  std::string text =
      "# Completion of wander for fish.  The build makes it from the program's own options.\n";
  std::string names;
  for (const VerbEntry& verb : verb_table(app)) {
    names += verb.name + " ";
    text += fmt::format("complete -c wander -n __fish_use_subcommand -f -a {} -d {}\n", verb.name,
                        quoted(verb.summary));
    text += lines_of(verb);
  }
  for (const OptionEntry& option : common_options(app))
    text += line_of("__fish_use_subcommand", option);
  return text + fmt::format(
                    "complete -c wander -n __fish_use_subcommand -f -a help -d 'explain a verb'\n"
                    "complete -c wander -n '__fish_seen_subcommand_from help' -f -a {}\n",
                    quoted(names));
}

}  // namespace wander::packaging
