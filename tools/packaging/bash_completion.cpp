#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/packaging/completions.h"
#include "tools/packaging/option_table.h"

namespace wander::packaging {

namespace {

// Words are taken from the line itself, for bash splits them at : and = too.
constexpr const char* beginning =
    R"(# Completion of wander for bash.  The build makes it from the program's own options.
_wander() {
  local line=${COMP_LINE:0:COMP_POINT} verb='' previous='' word
  local current=${line##*[[:space:]]}
  local -a words
  read -ra words <<<"${line%"$current"}"
  for word in "${words[@]:1}"; do
    [[ -z $verb && $word != -* ]] && verb=$word
    previous=$word
  done
  if [[ $current == --*=* ]]; then
    previous=${current%%=*}
    current=${current#*=}
  fi
)";

constexpr const char* end = R"(  if [[ -z $is_value && $current == -* ]]; then
    list=$options
  fi
  local kept=''
  if [[ -n $is_list && $current == *,* ]]; then
    kept=${current%,*},
  fi
  COMPREPLY=($(compgen -P "$kept" -W "$list" -- "${current#"$kept"}"))
  if [[ -n $or_file && $current != -* ]]; then
    COMPREPLY+=($(compgen -f -- "$current"))
  fi
  if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
    COMPREPLY=("${COMPREPLY[@]#"${current%:*}:"}")
  fi
}
complete -o default -F _wander wander
)";

std::string names_of(const std::vector<OptionEntry>& options) {
  std::vector<std::string> names;
  for (const OptionEntry& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

// One case of `$verb $previous` for each option that takes a value.
std::string value_cases(const std::string& verb, const std::vector<OptionEntry>& options) {
  std::string text;
  for (const OptionEntry& option : options) {
    if (option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names)
      patterns.push_back(fmt::format("'{} {}'", verb, name));
    text += fmt::format("    {}) is_value=1 or_file= list='{}'{} ;;\n", fmt::join(patterns, " | "),
                        fmt::join(option.words, " "),
                        option.values == Values::list_of_methods ? " is_list=1" : "");
  }
  return text;
}

}  // namespace

std::string bash_completion(CLI::App& app) {
  std::string names, verbs, values;
  for (const VerbEntry& verb : verb_table(app)) {
    names += verb.name + " ";
    const OptionEntry& what = verb.positionals.front();
    verbs +=
        fmt::format("    {}) options='{}' list='{}'{} ;;\n", verb.name, names_of(verb.options),
                    fmt::join(what.words, " "), what.values == Values::scenes ? " or_file=1" : "");
    values += value_cases(verb.name, verb.options);
  }
  names += "help";
  return beginning +
         fmt::format(
             "  local options='' list='' is_value='' is_list='' or_file=''\n"
             "  case $verb in\n"
             "    '') options='{}' list='{}' ;;\n"
             "    help) list='{}' ;;\n"
             "{}"
             "  esac\n"
             "  case \"$verb $previous\" in\n"
             "{}"
             "  esac\n",
             names_of(common_options(app)), names, names, verbs, values) +
         end;
}

}  // namespace wander::packaging
