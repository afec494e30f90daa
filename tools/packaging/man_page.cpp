#include "tools/packaging/man_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>

#include "records/version.h"
#include "tools/application.h"
#include "tools/packaging/option_table.h"

namespace wander::packaging {

namespace {

// Text that roff sets as it is.
std::string escaped(std::string_view text) {
  std::string result;
  bool at_start = true;
  for (const char letter : text) {
    if (at_start && (letter == '.' || letter == '\'')) result += "\\&";
    at_start = letter == '\n';
    if (letter == '\\')
      result += "\\e";
    else if (letter == '-')
      result += "\\-";
    else if (letter == '\'')
      result += "\\(aq";
    else if (letter == '`')
      result += "\\(ga";
    else if (letter == '^')
      result += "\\(ha";
    else if (letter == '~')
      result += "\\(ti";
    else
      result += letter;
  }
  return result;
}

// Line for line, as on a terminal.
std::string verbatim(std::string_view text) {
  while (text.starts_with('\n')) text.remove_prefix(1);
  while (text.ends_with('\n')) text.remove_suffix(1);
  return fmt::format(".nf\n{}\n.fi\n", escaped(text));
}

std::string text_of(const OptionEntry& option) {
  std::string heading;
  for (const std::string& name : option.names)
    heading += fmt::format("{}\\fB{}\\fR", heading.empty() ? "" : ", ", escaped(name));
  if (!option.value.empty())
    heading += fmt::format("{}\\fI{}\\fR", heading.empty() ? "" : " ", escaped(option.value));
  return fmt::format(".TP\n{}\n{}\n", heading, escaped(option.help));
}

std::string section_of(const VerbEntry& verb) {
  std::string text = fmt::format(".SS \"wander {}\"\n{}\n", verb.name, escaped(verb.summary));
  for (const OptionEntry& option : verb.positionals) text += text_of(option);
  for (const OptionEntry& option : verb.options)
    if (!option.is_common) text += text_of(option);
  return text + ".PP\n" + verbatim(verb.footer);
}

}  // namespace

std::string man_page(CLI::App& app) {
  std::string text = fmt::format(
      ".TH WANDER 1 \"\" \"Wanderlight {}\" \"User Commands\"\n"
      ".SH NAME\nwander \\- a Metropolis light transport testbed\n"
      ".SH SYNOPSIS\n\\fBwander\\fR \\fIVERB\\fR [\\fIOPTIONS\\fR] ...\n"
      ".SH DESCRIPTION\n{}",
      program_version(), verbatim(app.get_description()));
  text += ".SH VERBS\n";
  for (const VerbEntry& verb : verb_table(app)) text += section_of(verb);
  text += ".SH OPTIONS OF EVERY VERB\n";
  for (const OptionEntry& option : common_options(app)) text += text_of(option);
  return text + ".SH EXIT STATUS\n" + verbatim(exit_code_table());
}

}  // namespace wander::packaging
