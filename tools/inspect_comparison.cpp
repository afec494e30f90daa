#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/film_statistics.h"
#include "lab/compare/comparison_json.h"
#include "lab/compare/verdict.h"
#include "lab/reference_name.h"
#include "lab/wording.h"
#include "statistics/number_text.h"
#include "tools/inspection.h"

namespace wander {

namespace {

using compare::Cell;
using compare::Comparison;
using nlohmann::ordered_json;

std::size_t widest_label(const Comparison& comparison) {
  std::size_t width = 9;
  for (const compare::Contender& contender : comparison.runs.contenders)
    width = std::max(width, contender.label.size());
  return width;
}

std::string table_of(const Comparison& comparison) {
  const std::size_t width = widest_label(comparison);
  std::string text = fmt::format("  {:<{}}  {:>8}  {:>10}  {:>9}  {}\n", "contender", width,
                                 "budget", "replicates", "time", "relative RMSE (95 %)");
  for (const Cell& cell : comparison.cells) {
    if (cell.replicates == 0) continue;
    text += fmt::format(
        "  {:<{}}  {:>8}  {:>10}  {:>9}  {}\n", comparison.runs.contenders[cell.contender].label,
        width, comparison.runs.budgets[cell.budget], cell.replicates,
        duration_in_words(cell.seconds.value), compare::percent_with_interval(cell.relative_rmse));
  }
  return text;
}

std::string crossings_of(const Comparison& comparison) {
  std::string text;
  for (const compare::Crossing& c : comparison.crossings) {
    const std::string chance =
        std::isfinite(c.p_value) ? fmt::format(", p = {}", number_text(c.p_value, 2)) : "";
    text += fmt::format("  {}{}\n", compare::standing(comparison, c), chance);
  }
  return text;
}

}  // namespace

ordered_json inspect_comparison(const Comparison& comparison) {
  ordered_json json{{"schema", "wanderlight-inspection/1"}, {"kind", "comparison"}};
  const ordered_json whole = compare::to_json(comparison);
  for (const auto& [key, value] : whole.items())
    if (key != "schema" && key != "details") json[key] = value;
  json["scene"].erase("text");
  const double error = relative_error(comparison.runs.reference.film);
  json["reference"].erase("film");
  json["reference"]["relative_error"] =
      std::isfinite(error) ? ordered_json(error) : ordered_json(nullptr);
  for (ordered_json& run : json["runs"]) run.erase("film");
  return json;
}

std::string text_of_comparison(const Comparison& comparison) {
  const compare::Runs& runs = comparison.runs;
  std::string text;
  for (const std::string& sentence : comparison.verdict) text += sentence + '\n';
  text += '\n' + table_of(comparison);
  if (!comparison.crossings.empty()) text += '\n' + crossings_of(comparison);
  text += fmt::format("\n  reference       {}", runs.reference.origin);
  if (!is_exact(runs.reference.origin))
    text +=
        fmt::format("; its own relative error is {}", percent(relative_error(runs.reference.film)));
  text += '\n';
  text += fmt::format("  scene           {}\n", runs.provenance.scene_name.empty()
                                                    ? "without a name"
                                                    : runs.provenance.scene_name);
  text += made_by_lines(runs.provenance);
  for (const std::string& warning : runs.warnings)
    text += fmt::format("  warning         {}\n", warning);
  return text;
}

}  // namespace wander
