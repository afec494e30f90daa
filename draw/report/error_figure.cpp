#include "draw/report/error_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/report/chart_pages.h"
#include "draw/report/numbers.h"
#include "lab/compare/curves.h"
#include "lab/wording.h"

namespace wander::report {
namespace {

using compare::Cell;
using compare::Comparison;
using compare::Crossing;
using compare::Measured;

constexpr std::size_t most_crossings = 6;

std::optional<figure::Range> range_of(const compare::Interval& interval, double unit = 1) {
  if (std::isnan(interval.low) && std::isnan(interval.high)) return std::nullopt;
  return figure::Range{unit * interval.low, unit * interval.high};
}

figure::Quantity quantity_of(TimeKind time) {
  return {time == TimeKind::wall ? "time" : "processor time", "s"};
}

figure::Series curve(const Comparison& comparison, std::size_t contender, Measured Cell::*cost) {
  figure::Series series{.label = comparison.runs.contenders[contender].label,
                        .look = figure::look_of(contender)};
  for (const Cell& cell : comparison.cells)
    if (cell.contender == contender && cell.replicates > 0)
      series.points.push_back({(cell.*cost).value, 100 * cell.relative_rmse.value,
                               range_of((cell.*cost).interval),
                               range_of(cell.relative_rmse.interval, 100)});
  std::ranges::sort(series.points, {}, &figure::Point::x);
  return series;
}

// On to the target, where the time to it is extrapolated.
void extrapolate(figure::Series& series, const Comparison& comparison, std::size_t contender) {
  const compare::Curve& curve = comparison.curves[contender];
  if (!is_extrapolated(comparison, curve)) return;
  series.measured_to = longest_run(comparison, contender);
  series.points.push_back({curve.seconds_to_target.value, 100 * comparison.target,
                           range_of(curve.seconds_to_target.interval), std::nullopt});
}

// Where what was measured ends.
figure::Guide end_of(double longest) {
  return {longest,
          fmt::format("longest run, {}; beyond it extrapolated", duration_in_words(longest))};
}

double longest_of_all(const Comparison& comparison) {
  double longest = 0;
  for (std::size_t k = 0; k < comparison.runs.contenders.size(); ++k)
    longest = std::fmax(longest, longest_run(comparison, k));
  return longest;
}

figure::Chart error_chart(const Comparison& comparison, const figure::Quantity& quantity,
                          Measured Cell::*cost) {
  figure::ChartPanel panel{.empty_note = "no error is known"};
  for (std::size_t k = 0; k < comparison.runs.contenders.size(); ++k)
    panel.series.push_back(curve(comparison, k, cost));
  if (comparison.target > 0)
    panel.guides.push_back(
        {100 * comparison.target, fmt::format("target {}", percent(comparison.target))});
  return {.x = {.quantity = quantity, .spacing = figure::Spacing::logarithmic},
          .y = {.quantity = {"relative RMSE", "%"}, .spacing = figure::Spacing::logarithmic},
          .panels = {std::move(panel)}};
}

std::string label_of(const Comparison& comparison, const Crossing& crossing) {
  const auto& contenders = comparison.runs.contenders;
  return fmt::format("{} ahead of {} from {}", contenders[crossing.ahead].label,
                     contenders[crossing.behind].label, duration_in_words(crossing.seconds.value));
}

std::string spoken(const Comparison& comparison) {
  std::string text = "Relative root mean square error in percent.";
  for (const Cell& cell : comparison.cells)
    if (cell.replicates > 0)
      text += fmt::format(" {} at {}: {}.", comparison.runs.contenders[cell.contender].label,
                          comparison.runs.budgets[cell.budget],
                          rounded(100 * cell.relative_rmse.value));
  return text;
}

}  // namespace

std::vector<Crossing> marked_crossings(const Comparison& comparison) {
  std::vector<Crossing> marked;
  for (const Crossing& crossing : comparison.crossings)
    if (crossing.significant && std::isfinite(crossing.seconds.value) && crossing.seconds.value > 0)
      marked.push_back(crossing);
  std::ranges::sort(marked, {}, [](const Crossing& c) { return c.seconds.value; });
  if (marked.size() > most_crossings) marked.resize(most_crossings);
  return marked;
}

bool has_extrapolated(const Comparison& comparison) {
  return std::ranges::any_of(comparison.curves, [&](const compare::Curve& curve) {
    return is_extrapolated(comparison, curve);
  });
}

std::string error_time_figure(const Comparison& comparison, const std::string& title,
                              double width) {
  figure::Chart chart = error_chart(comparison, quantity_of(comparison.runs.time), &Cell::seconds);
  for (const Crossing& crossing : marked_crossings(comparison))
    chart.guides.push_back({crossing.seconds.value, label_of(comparison, crossing)});
  for (std::size_t k = 0; k < comparison.curves.size(); ++k)
    extrapolate(chart.panels.front().series[k], comparison, k);
  if (has_extrapolated(comparison)) chart.guides.push_back(end_of(longest_of_all(comparison)));
  return chart_document(std::move(chart), title, spoken(comparison), width);
}

std::string error_samples_figure(const Comparison& comparison) {
  return chart_document(error_chart(comparison, {"samples", ""}, &Cell::samples),
                        "Error against samples", spoken(comparison));
}

std::vector<double> times_shown(const Comparison& comparison, const compare::Profile& profile) {
  const double least = shortest_run(comparison, profile.contender);
  std::vector<double> times;
  for (const double seconds : profile.seconds)
    if (std::isfinite(seconds)) times.push_back(std::max(seconds, least));
  return times;
}

std::string profile_figure(const Comparison& comparison) {
  figure::ChartPanel panel{
      .empty_note = fmt::format(
          "no replicate comes to the target, even in {} times its longest run", compare::farthest)};
  const double measured = longest_of_all(comparison);
  double longest = measured, shortest = INFINITY;
  for (const compare::Profile& profile : comparison.profiles)
    for (const double seconds : times_shown(comparison, profile)) {
      longest = std::max(longest, seconds);
      shortest = std::min(shortest, seconds);
    }
  const double first = std::min(shortest, measured);
  const figure::Range range =
      longest > 0 ? figure::Range{first / 3, longest * 3} : figure::Range{0.1, 10};
  for (const compare::Profile& profile : comparison.profiles) {
    figure::Series series{.label = comparison.runs.contenders[profile.contender].label,
                          .look = figure::look_of(profile.contender),
                          .connection = figure::Connection::distribution,
                          .measured_to = longest_run(comparison, profile.contender)};
    for (std::size_t k = 0; const double seconds : times_shown(comparison, profile))
      series.points.push_back({.x = seconds, .y = 100 * profile.share[k++]});
    panel.series.push_back(std::move(series));
  }
  std::vector<figure::Guide> guides;
  if (measured > 0) guides.push_back(end_of(measured));
  return chart_document(
      {.x = {.quantity = quantity_of(comparison.runs.time),
             .spacing = figure::Spacing::logarithmic,
             .range = range},
       .y = {.quantity = {"replicates at the target", "%"}, .range = figure::Range{0, 104}},
       .panels = {std::move(panel)},
       .guides = std::move(guides),
       .panel_height = 120},
      "Time to the target error",
      "For each contender the share of replicates that need no more than a time.");
}

}  // namespace wander::report
