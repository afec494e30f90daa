// What a verb says of its options, without the header of CLI11, which takes the compiler seconds in
// every file that includes it: it is included where the command line is read, and in command.cpp.
// The names are those of CLI11.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace wander {

// An option that was added: what else there is to say of it.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  CommandOption type_name(const std::string& name);
  CommandOption group(const std::string& name);
  CommandOption required();
  CommandOption one_value_each_time();  // of an option that may be given often

 private:
  CLI::Option* option_;
};

// A verb, or the program itself; it refers to what CLI11 knows of it.
class Command {
 public:
  using Text = std::function<void(const std::string& text)>;

  explicit Command(CLI::App& app) : app_(&app) {}

  // `names` are those of an option (-b,--budget) or of an argument (SCENE).
  CommandOption add_option(const std::string& names, std::string& value, const std::string& help);
  CommandOption add_option(const std::string& names, std::optional<std::string>& value,
                           const std::string& help);
  CommandOption add_option(const std::string& names, std::vector<std::string>& values,
                           const std::string& help);
  CommandOption add_option(const std::string& names, const Text& read, const std::string& help);
  CommandOption add_flag(const std::string& names, bool& is_given, const std::string& help);
  CommandOption add_flag(const std::string& names, const std::function<void()>& given,
                         const std::string& help);
  CommandOption set_help_flag(const std::string& names, const std::string& help);
  void footer(const std::string& text);

  // Before its words are read, and when all of them were.
  void preparse_callback(const std::function<void()>& begin);
  void callback(const std::function<void()>& done);
  // How often an option was given.
  std::size_t count(const std::string& option) const;

 private:
  CLI::App* app_;
};

Command add_verb(CLI::App& app, const std::string& name, const std::string& description);

}  // namespace wander
