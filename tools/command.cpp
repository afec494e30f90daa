#include "tools/command.h"

#include <CLI/CLI.hpp>

namespace wander {

CommandOption CommandOption::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

CommandOption CommandOption::group(const std::string& name) {
  option_->group(name);
  return *this;
}

CommandOption CommandOption::required() {
  option_->required();
  return *this;
}

CommandOption CommandOption::one_value_each_time() {
  option_->allow_extra_args(false);
  return *this;
}

CommandOption Command::add_option(const std::string& names, std::string& value,
                                  const std::string& help) {
  return CommandOption(*app_->add_option(names, value, help));
}

CommandOption Command::add_option(const std::string& names, std::optional<std::string>& value,
                                  const std::string& help) {
  return CommandOption(*app_->add_option(names, value, help));
}

CommandOption Command::add_option(const std::string& names, std::vector<std::string>& values,
                                  const std::string& help) {
  return CommandOption(*app_->add_option(names, values, help));
}

CommandOption Command::add_option(const std::string& names, const Text& read,
                                  const std::string& help) {
  return CommandOption(*app_->add_option_function<std::string>(names, read, help));
}

CommandOption Command::add_flag(const std::string& names, bool& is_given, const std::string& help) {
  return CommandOption(*app_->add_flag(names, is_given, help));
}

CommandOption Command::add_flag(const std::string& names, const std::function<void()>& given,
                                const std::string& help) {
  return CommandOption(*app_->add_flag_callback(names, given, help));
}

CommandOption Command::set_help_flag(const std::string& names, const std::string& help) {
  return CommandOption(*app_->set_help_flag(names, help));
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::preparse_callback(const std::function<void()>& begin) {
  app_->preparse_callback([begin](std::size_t) { begin(); });
}

void Command::callback(const std::function<void()>& done) { app_->callback(done); }

std::size_t Command::count(const std::string& option) const { return app_->count(option); }

Command add_verb(CLI::App& app, const std::string& name, const std::string& description) {
  return Command(*app.add_subcommand(name, description));
}

}  // namespace wander
