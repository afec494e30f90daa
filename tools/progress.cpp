#include "tools/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/wording.h"
#include "tools/console.h"

namespace wander {

namespace {

constexpr double seconds_between_draws = 0.1;
constexpr double seconds_between_lines = 5;
const std::string erase_line = "\r\x1b[K";

double rate_of(const ProgressReport& report) {
  return report.seconds > 0 ? static_cast<double>(report.samples) / report.seconds : 0;
}

}  // namespace

Progress::Progress(const Global& global) : display_(display_for(global)) {}

Progress::~Progress() {
  if (display_ == Display::bar && last_drawn_ >= 0) print_note(erase_line);
}

Progress::Display Progress::display_for(const Global& global) {
  switch (global.progress) {
    case ProgressMode::none:
      return Display::none;
    case ProgressMode::json:
      return Display::json;
    case ProgressMode::bar:
      return stderr_is_terminal() ? Display::bar : Display::none;
    case ProgressMode::automatic:
      break;
  }
  if (global.quiet) return Display::none;
  return stderr_is_terminal() ? Display::bar : Display::lines;
}

std::function<void(const ProgressReport&)> Progress::reporter(Lines lines) {
  if (display_ == Display::none) return {};
  if (display_ == Display::json)
    return [](const ProgressReport& report) { print_note(json_line_of(report) + "\n"); };
  if (display_ == Display::lines)
    return [this, lines](const ProgressReport& report) { print_line(report, lines); };
  return [this](const ProgressReport& report) { draw_bar(report); };
}

void Progress::draw_bar(const ProgressReport& report) {
  if (last_drawn_ >= 0 && report.seconds - last_drawn_ < seconds_between_draws) return;
  last_drawn_ = report.seconds;
  print_note(erase_line + bar_of(report));
}

void Progress::print_line(const ProgressReport& report, Lines lines) {
  const bool is_due = report.seconds - std::max(last_drawn_, 0.0) >= seconds_between_lines;
  const bool is_new = lines == Lines::of_each_phase && report.phase != last_phase_;
  if (!is_due && !is_new) return;
  last_drawn_ = report.seconds;
  last_phase_ = report.phase;
  print_note(line_of(report) + "\n");
}

void Progress::say(const std::string& line) {
  const bool is_below_a_bar = display_ == Display::bar && last_drawn_ >= 0;
  print_note((is_below_a_bar ? erase_line : "") + line + "\n");
}

std::string bar_of(const ProgressReport& report) {
  constexpr int width = 30;
  const double fraction = std::clamp(report.fraction, 0.0, 1.0);
  const int full = static_cast<int>(std::floor(fraction * width));
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", full, "", width - full, line_of(report));
}

std::string line_of(const ProgressReport& report) {
  const double fraction = std::clamp(report.fraction, 0.0, 1.0);
  std::string line = fmt::format("{:3.0f} %  {}", std::floor(100 * fraction), report.phase);
  if (const double rate = rate_of(report); rate > 0)
    line += fmt::format("  {}/s", count_in_words(rate));
  if (fraction > 0)
    line += fmt::format("  {} left", duration_in_words(report.seconds * (1 - fraction) / fraction));
  return line;
}

std::string json_line_of(const ProgressReport& report) {
  const nlohmann::ordered_json line{{"phase", report.phase},
                                    {"fraction", report.fraction},
                                    {"samples", report.samples},
                                    {"seconds", report.seconds},
                                    {"samples_per_second", rate_of(report)}};
  return line.dump();
}

}  // namespace wander
