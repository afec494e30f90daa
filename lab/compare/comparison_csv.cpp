#include "lab/compare/comparison_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "lab/compare/comparison_fields.h"

namespace wander::compare {

namespace {

std::string text_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

// Not every reader takes `-nan` for a number.
double without_sign_of_nan(double x) { return std::isnan(x) ? std::abs(x) : x; }

}  // namespace

std::string to_csv(const Comparison& comparison) {
  const Runs& runs = comparison.runs;
  std::string text =
      "contender,method,dial,setting,budget,replicate,seed,samples,seconds,seed_seconds,"
      "seed_samples,cpu_seconds";
  for (const auto& field : error_fields) text += fmt::format(",{}", field.name);
  text += '\n';
  for (std::size_t i = 0; i < runs.runs.size(); ++i) {
    const Run& run = runs.runs[i];
    const Contender& contender = runs.contenders.at(run.contender);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", text_field(contender.label),
                        text_field(contender.method), text_field(contender.dial),
                        text_field(contender.setting), text_field(runs.budgets.at(run.budget)),
                        run.replicate + 1, run.seed, run.samples, without_sign_of_nan(run.seconds),
                        without_sign_of_nan(run.seed_seconds), run.seed_samples,
                        without_sign_of_nan(run.processor_seconds));
    for (const auto& field : error_fields)
      text += fmt::format(",{}", without_sign_of_nan(comparison.errors.at(i).*field.member));
    text += '\n';
  }
  return text;
}

}  // namespace wander::compare
