#include "tools/extremes_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "statistics/number_text.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

const char* word_of(SymmetryVerdict verdict) {
  switch (verdict) {
    case SymmetryVerdict::same:
      return "same";
    case SymmetryVerdict::differs:
      return "differs";
    case SymmetryVerdict::refused:
      return "refused";
  }
  return "";
}

std::string words_of(const SymmetryCheck& check) {
  if (check.verdict == SymmetryVerdict::differs)
    return fmt::format("differs by {} of the largest value", number_text(check.difference, 2));
  if (check.verdict == SymmetryVerdict::refused) return "refused: " + check.reason;
  return "same";
}

}  // namespace

bool ExtremesReport::passed() const {
  return with(SymmetryVerdict::same) > 0 && with(SymmetryVerdict::differs) == 0;
}

std::size_t ExtremesReport::with(SymmetryVerdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count(checks, verdict, &SymmetryCheck::verdict));
}

std::string text_of(const ExtremesReport& report) {
  std::string text;
  const SymmetryCheck* before = nullptr;
  for (const SymmetryCheck& check : report.checks) {
    if (before == nullptr || before->method != check.method || before->precision != check.precision)
      text += fmt::format("{} in {}\n", check.method, name_of(check.precision));
    text += fmt::format("  {:<28} {}\n", check.variation, words_of(check));
    before = &check;
  }
  return text + fmt::format(
                    "{} films of {} samples are the same to the last bit, {} differ, {} are "
                    "refused: {}\n",
                    report.with(SymmetryVerdict::same), report.samples,
                    report.with(SymmetryVerdict::differs), report.with(SymmetryVerdict::refused),
                    report.passed() ? "passed" : "failed");
}

ordered_json json_of(const ExtremesReport& report) {
  ordered_json checks = ordered_json::array();
  for (const SymmetryCheck& check : report.checks)
    checks.push_back({{"method", check.method},
                      {"precision", name_of(check.precision)},
                      {"variation", check.variation},
                      {"verdict", word_of(check.verdict)},
                      {"difference", check.difference},
                      {"reason", check.reason}});
  return {{"schema", "wanderlight-extremes/1"},
          {"scene", {{"name", report.scene_name}, {"sha256", report.scene_sha256}}},
          {"samples", report.samples},
          {"seed", report.seed},
          {"passed", report.passed()},
          {"checks", checks}};
}

}  // namespace wander
