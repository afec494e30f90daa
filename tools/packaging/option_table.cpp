#include "tools/packaging/option_table.h"

#include <CLI/CLI.hpp>
#include <span>
#include <string_view>

#include "lab/method.h"
#include "lab/parsing.h"
#include "scenes/gallery_scenes.h"
#include "tools/plot_options.h"
#include "tools/verb.h"

namespace wander::packaging {

namespace {

Values values_of(std::string_view value) {
  if (value == "METHOD") return Values::methods;
  if (value == "METHOD,...") return Values::list_of_methods;
  if (value == "SCENE" || value == "FILE") return Values::scenes;
  if (value == "NAME") return Values::gallery_names;
  return Values::files;
}

// Of options that take one of a few words.
std::vector<std::string> choices_of(const std::string& option) {
  const auto all = [](const auto& words) {
    return std::vector<std::string>(words.begin(), words.end());
  };
  if (option == "--figure") return all(figure_words);
  if (option == "--layout") return all(layout_words);
  if (option == "--normalization") return all(normalization_words);
  if (option == "--estimator") return all(estimator_words);
  if (option == "--progress") return all(progress_words);
  if (option != "--precision") return {};
  std::vector<std::string> names;
  for (const Precision precision : precisions) names.emplace_back(name_of(precision));
  return names;
}

std::vector<std::string> words_of(Values values, std::string_view verb) {
  std::vector<std::string> words;
  if (values == Values::methods || values == Values::list_of_methods)
    for (const Method& method : methods())
      if (verb != "trace" || method.is_traced()) words.emplace_back(method.name);
  if (values == Values::gallery_names) words = gallery_names();
  if (values == Values::scenes)
    for (const std::string& name : gallery_names()) words.push_back("gallery:" + name);
  return words;
}

OptionEntry entry_of(const CLI::Option& option, const std::string& verb) {
  OptionEntry entry;
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_positional())
    entry.value = option.get_name();
  else if (option.get_items_expected_max() > 0)
    entry.value = option.get_type_name();
  entry.help = option.get_description();
  entry.is_common = option.get_group() == "Options of every verb";
  // Only the place of a whole argument names a scene: --mutation NAME is no name of a scene.
  const Values values = values_of(entry.value);
  const bool names_a_scene = values == Values::scenes || values == Values::gallery_names;
  if (!names_a_scene || option.get_positional()) entry.values = values;
  entry.words = words_of(entry.values, verb);
  if (!option.get_lnames().empty() && entry.words.empty())
    entry.words = choices_of("--" + option.get_lnames().front());
  return entry;
}

std::vector<OptionEntry> entries_of(CLI::App& app) {
  std::vector<OptionEntry> entries;
  for (const CLI::Option* option : app.get_options())
    entries.push_back(entry_of(*option, app.get_name()));
  return entries;
}

}  // namespace

std::vector<VerbEntry> verb_table(CLI::App& app) {
  std::vector<VerbEntry> verbs;
  for (CLI::App* verb : app.get_subcommands({})) {
    VerbEntry entry{verb->get_name(), verb->get_description(), verb->get_footer(), {}, {}};
    for (OptionEntry& option : entries_of(*verb))
      (option.names.empty() ? entry.positionals : entry.options).push_back(std::move(option));
    verbs.push_back(std::move(entry));
  }
  return verbs;
}

std::vector<OptionEntry> common_options(CLI::App& app) { return entries_of(app); }

std::vector<std::string> gallery_names() {
  std::vector<std::string> names;
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count))
    names.emplace_back(scene.name);
  return names;
}

}  // namespace wander::packaging
