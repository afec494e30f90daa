#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "tools/packaging/completions.h"
#include "tools/packaging/option_table.h"

namespace wander::packaging {

namespace {

// Within single quotes, in a place where the characters of `special` mean something.
std::string quoted(std::string_view text, std::string_view special) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\'') {
      result += "'\\''";
      continue;
    }
    if (letter == '\\' || special.find(letter) != std::string_view::npos) result += '\\';
    result += letter;
  }
  return result;
}

std::string action_of(const OptionEntry& option) {
  if (option.values == Values::scenes) return "_wander_scene";
  if (option.words.empty()) return "_files";
  if (option.values == Values::list_of_methods)
    return fmt::format("_values -s , method {}", fmt::join(option.words, " "));
  return fmt::format("({})", fmt::join(option.words, " "));
}

std::string specification_of(const OptionEntry& option) {
  const std::string help = fmt::format("'[{}]", quoted(option.help, "[]:"));
  const std::string value = option.value.empty() ? "'"
                                                 : fmt::format(":{}:{}'", quoted(option.value, ":"),
                                                               quoted(action_of(option), ""));
  if (option.names.size() == 1) return fmt::format("{}{}{}", option.names.front(), help, value);
  return fmt::format("'({0})'{{{1}}}{2}{3}", fmt::join(option.names, " "),
                     fmt::join(option.names, ","), help, value);
}

std::string case_of(const VerbEntry& verb) {
  std::string text = fmt::format("    {})\n      _arguments \\\n", verb.name);
  for (const OptionEntry& option : verb.options)
    text += "        " + specification_of(option) + " \\\n";
  const OptionEntry& what = verb.positionals.front();
  return text + fmt::format("        '*:{}:{}' ;;\n", what.value, quoted(action_of(what), ""));
}

}  // namespace

std::string zsh_completion(CLI::App& app) {
  std::string verbs, cases;
  for (const VerbEntry& verb : verb_table(app)) {
    verbs += fmt::format("    '{}:{}'\n", verb.name, quoted(verb.summary, ""));
    cases += case_of(verb);
  }
  std::string scenes;
  for (const std::string& name : gallery_names()) scenes += " gallery:" + name;
  return fmt::format(
      "#compdef wander\n"
      "# Completion of wander for zsh.  The build makes it from the program's own options.\n"
      "_wander_scene() {{\n"
      "  local -a scenes=({})\n"
      "  compadd -a scenes\n"
      "  _files\n"
      "}}\n"
      "_wander() {{\n"
      "  local -a verbs=(\n{}"
      "    'help:explain a verb'\n"
      "  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe verb verbs\n"
      "    return\n"
      "  fi\n"
      "  local verb=$words[2]\n"
      "  (( CURRENT-- ))\n"
      "  shift words\n"
      "  case $verb in\n"
      "    help) _describe verb verbs ;;\n"
      "{}"
      "  esac\n"
      "}}\n"
      "_wander \"$@\"\n",
      scenes, verbs, cases);
}

}  // namespace wander::packaging
