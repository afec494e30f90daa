#include "tools/packaging/man_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <utility>

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

std::string entry_of(std::string_view name, std::string_view text) {
  return fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(name), escaped(text));
}

// Text that is laid out for a terminal, laid out anew for any page: paragraphs, lists of
// "  name  what it is", and other indented lines, such as commands, each on a line of its own.
class Layout {
 public:
  void add(std::string_view line) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string_view::npos) return end();
    const std::string_view words = line.substr(indent);
    if (!name_.empty() && indent > indent_) {
      what_ += " " + std::string(words);
      return;
    }
    if (indent == 0) return add_prose(words);
    end();
    indent_ = indent;
    if (const std::size_t gap = words.find("  "); gap != std::string_view::npos) {
      name_ = words.substr(0, gap);
      what_ = words.substr(words.find_first_not_of(' ', gap));
    } else {
      text_ += fmt::format(".RS 2\n.ad l\n.nh\n{}\n.hy\n.ad b\n.RE\n", escaped(words));
    }
  }
  std::string text() && {
    end();
    return std::move(text_);
  }

 private:
  void add_prose(std::string_view words) {
    if (!name_.empty()) end();
    if (!in_paragraph_) text_ += ".PP\n";
    in_paragraph_ = true;
    text_ += escaped(words) + "\n";
  }
  void end() {
    if (!name_.empty()) text_ += entry_of(name_, what_);
    name_.clear();
    in_paragraph_ = false;
  }

  std::string text_, name_, what_;  // name_: of an entry that may go on
  std::size_t indent_ = 0;
  bool in_paragraph_ = false;
};

std::string laid_out(std::string_view text) {
  Layout layout;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    layout.add(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return std::move(layout).text();
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
  return text + laid_out(verb.footer);
}

}  // namespace

std::string man_page(CLI::App& app) {
  std::string text = fmt::format(
      ".TH WANDER 1 \"\" \"Wanderlight {}\" \"User Commands\"\n"
      ".SH NAME\nwander \\- a Metropolis light transport testbed\n"
      ".SH SYNOPSIS\n\\fBwander\\fR \\fIVERB\\fR [\\fIOPTIONS\\fR] ...\n"
      ".SH DESCRIPTION\n{}",
      program_version(), laid_out(app.get_description()));
  text += ".SH VERBS\n";
  for (const VerbEntry& verb : verb_table(app)) text += section_of(verb);
  text += ".SH OPTIONS OF EVERY VERB\n";
  for (const OptionEntry& option : common_options(app)) text += text_of(option);
  return text + ".SH EXIT STATUS\n" + laid_out(exit_code_table());
}

}  // namespace wander::packaging
