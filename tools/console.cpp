#include "tools/console.h"

#include <spdlog/sinks/ansicolor_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "records/atomic_file.h"

namespace wander {

void print_data(std::string_view text) {
  write_to_descriptor(STDOUT_FILENO, text, "standard output");
}

void print_data(const FileWriter& write) {
  write_to_descriptor(STDOUT_FILENO, write, "standard output");
}

void print_json(const nlohmann::ordered_json& document) {
  print_data(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

nlohmann::ordered_json finite_or_null(double x) {
  return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
}

void print_note(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

namespace {

bool colour_is_unwanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return no_color != nullptr && *no_color != '\0';
}

spdlog::level::level_enum level_of(Verbosity verbosity) {
  switch (verbosity) {
    case Verbosity::quiet:
      return spdlog::level::err;
    case Verbosity::normal:
      return spdlog::level::info;
    case Verbosity::verbose:
      return spdlog::level::debug;
  }
  return spdlog::level::info;
}

}  // namespace

void open_log(Verbosity verbosity) {
  const auto colour =
      colour_is_unwanted() ? spdlog::color_mode::never : spdlog::color_mode::automatic;
  auto sink = std::make_shared<spdlog::sinks::ansicolor_stderr_sink_st>(colour);
  auto log = std::make_shared<spdlog::logger>("wander", std::move(sink));
  log->set_pattern("%^%l%$: %v");
  log->set_level(level_of(verbosity));
  spdlog::set_default_logger(std::move(log));
}

void print_error(std::string_view message) { spdlog::error("{}", message); }

}  // namespace wander
