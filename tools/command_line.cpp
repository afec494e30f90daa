#include "tools/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>

#include "lab/failure.h"
#include "lab/nearest.h"
#include "scenes/format/scene_file_nearest.h"

namespace wander {

namespace {

bool is_option(std::string_view word) { return word.size() > 1 && word.starts_with("-"); }

// `help` is a word for --help, and stands among the verbs in suggestions.
std::vector<std::string_view> names_of_verbs(CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  names.push_back("help");
  return names;
}

void require_verb(CLI::App& app, std::string_view word) {
  const std::vector<std::string_view> names = names_of_verbs(app);
  if (std::ranges::find(names, word) == names.end())
    throw UsageError(unknown_word("verb", word, names));
}

std::vector<std::string> without_help_word(CLI::App& app, std::vector<std::string> words) {
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  if (!words.empty() && !is_option(words.front())) require_verb(app, words.front());
  words.push_back("--help");
  return words;
}

UsageError usage_error(const CLI::App& verb, std::string_view what) {
  const char* end = what.ends_with('?') ? "" : ";";
  return UsageError(fmt::format("{}{} see `wander {} --help`", what, end, verb.get_name()));
}

std::vector<std::string> long_options(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

// Of the same verb if that looks like a slip of the finger; else of another verb that has it.
std::string remedy_for(CLI::App& app, const CLI::App& verb, const std::string& option) {
  if (!option.starts_with("--")) return "";
  if (const std::string likely = likely_word(option.substr(2), long_options(verb)); !likely.empty())
    return fmt::format("; did you mean --{}?", likely);
  std::vector<std::string> others;
  for (const CLI::App* other : app.get_subcommands({}))
    if (other->get_option_no_throw(option) != nullptr) others.push_back(other->get_name());
  return others.empty() ? "" : fmt::format("; it is an option of {}", fmt::join(others, ", "));
}

// Words that are left over.  The one after an unknown option is taken for its value.
void look_at_rest(CLI::App& app, const CLI::App& verb, Examination& examination) {
  bool after_unknown_option = false;
  for (const std::string& word : app.remaining(true)) {
    if (is_option(word)) {
      const std::string option = word.substr(0, word.find('='));
      examination.part([&] {
        throw usage_error(verb, fmt::format("{} has no option {}{}", verb.get_name(), option,
                                            remedy_for(app, verb, option)));
      });
    } else if (!after_unknown_option) {
      examination.part(
          [&] { throw usage_error(verb, fmt::format("'{}' is one argument too many", word)); });
    }
    after_unknown_option = is_option(word) && word.find('=') == std::string::npos;
  }
}

std::string miscounted(const CLI::Option& option, const CLI::ParseError& problem) {
  if (option.get_items_expected_max() > 1 || option.count() < 2) return problem.what();
  return fmt::format("{} is given {} times; it takes one {}", option.get_name(), option.count(),
                     option.get_type_name());
}

// Of the options that were read, those whose value the verb has not yet seen.  True if one of them
// was given in a number that CLI11 does not take.
bool look_at_values(CLI::App& verb, Examination& examination) {
  bool is_miscounted = false;
  for (CLI::Option* option : verb.get_options()) {
    if (option->count() == 0 || option->get_callback_run()) continue;
    examination.part([&] {
      try {
        option->run_callback();
      } catch (const CLI::ParseError& problem) {
        is_miscounted = true;
        throw usage_error(verb, miscounted(*option, problem));
      }
    });
  }
  return is_miscounted;
}

void look_for_missing(const CLI::App& verb, Examination& examination) {
  for (const CLI::Option* option : verb.get_options())
    if (option->get_required() && option->count() == 0)
      examination.part(
          [&] { throw usage_error(verb, fmt::format("{} is required", option->get_name())); });
}

[[noreturn]] void refuse_without_verb(CLI::App& app) {
  const std::vector<std::string> left = app.remaining();
  const auto word = std::ranges::find_if_not(left, is_option);
  if (word != left.end()) require_verb(app, *word);
  throw UsageError("a verb is missing; see `wander --help`");
}

bool help_is_wanted(const CLI::App& verb) {
  return verb.get_help_ptr() != nullptr && verb.get_help_ptr()->count() > 0;
}

}  // namespace

bool read_command_line(CLI::App& app, std::vector<std::string> words, Examination& examination) {
  words = without_help_word(app, std::move(words));
  std::ranges::reverse(words);  // as CLI11 takes them
  std::optional<UsageError> unread;
  try {
    app.parse(words);
    return true;
  } catch (const CommandFailure&) {
    examination.part([] { throw; });
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ArgumentMismatch& problem) {
    unread = UsageError(problem.what());
  } catch (const CLI::ParseError&) {
    // What it is about is found below.
  }
  if (app.get_subcommands().empty()) refuse_without_verb(app);
  CLI::App& verb = *app.get_subcommands().front();
  if (help_is_wanted(verb)) throw CLI::CallForHelp();
  const bool is_read = look_at_values(verb, examination) || !unread;
  look_at_rest(app, verb, examination);
  if (!is_read) {
    examination.part([&] { throw usage_error(verb, unread->what()); });
    return false;
  }
  look_for_missing(verb, examination);
  return true;
}

}  // namespace wander
