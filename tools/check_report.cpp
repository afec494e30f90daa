#include "tools/check_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/wording.h"
#include "statistics/number_text.h"
#include "tools/console.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

const char* word_of(Verdict verdict) {
  constexpr std::array words{"passed", "failed", "untested"};
  return words[static_cast<std::size_t>(verdict)];
}

// The three decisions about a kernel, the name of each, and what its comparisons are.
struct Part {
  const char* key;
  std::string words;
  const Decision* decision;
  std::string (*name)(std::size_t);
};

std::string name_of_flow(std::size_t k) {
  return "the flow between (" + name_of_cell(k / cell_count) + ") and (" +
         name_of_cell(k % cell_count) + ")";
}

std::array<Part, 3> parts_of(const InvarianceReport& r, int steps) {
  return {Part{"one_step", "after one step", &r.one_step, name_of_function},
          Part{"many_steps", fmt::format("after {} steps", steps), &r.many_steps, name_of_function},
          Part{"flux", "there and back", &r.flux, name_of_flow}};
}

// What came nearest to its threshold, or beyond.
const Part& worst_of(const std::array<Part, 3>& parts) {
  const auto share = [](const Part& part) {
    const Decision& d = *part.decision;
    if (d.comparisons == 0) return -1.0;
    return std::isnan(d.statistic) ? HUGE_VAL : std::abs(d.statistic) / d.threshold;
  };
  return *std::ranges::max_element(parts, {}, share);
}

std::string reason_untested(const InvarianceReport& r) {
  if (r.starts == 0) return "none of its samples found a path; a larger --samples may find some";
  if (r.acted == 0) return fmt::format("it cannot act on any of the {} paths found", r.starts);
  if (r.moved == 0)
    return fmt::format("it could act on {} paths, and none of its proposals could be accepted",
                       r.acted);
  return fmt::format(
      "it moved {} of {} paths, which is not {} of equal weight in any comparison; a larger "
      "--samples may help",
      r.moved, r.starts, fewest_contributions);
}

// How large an error would have been seen.
std::string sight(double visible) {
  if (!std::isfinite(visible)) return "";
  return fmt::format("; {} % would show{}", number_text(100 * visible, 2),
                     visible > 1 ? ", no less: a larger --samples sees more" : "");
}

std::string words_of(const KernelCheck& check, int steps, std::uint64_t samples) {
  const InvarianceReport& r = check.report;
  const Verdict verdict = verdict_of(r);
  if (verdict == Verdict::untested) return "not tested: " + reason_untested(r);
  const auto parts = parts_of(r, steps);
  const Part& worst = worst_of(parts);
  const Decision& d = *worst.decision;
  if (verdict == Verdict::failed)
    return fmt::format("DOES NOT leave the target invariant: {} |z| is {}, threshold {:.1f}, in {}",
                       worst.words, number_text(std::abs(d.statistic)), d.threshold,
                       worst.name(d.worst));
  std::size_t comparisons = 0;
  double visible = HUGE_VAL;
  for (const Part& part : parts) {
    comparisons += part.decision->comparisons;
    if (part.decision->comparisons > 0) visible = std::min(visible, part.decision->visible);
  }
  return fmt::format(
      "leaves the target invariant (largest |z| {:.1f} of {} comparisons, threshold {:.1f}; {} "
      "samples{})",
      std::abs(d.statistic), comparisons, d.threshold, count_in_words(static_cast<double>(samples)),
      sight(visible));
}

std::string words_of(const MethodCheck& check) {
  if (check.verdict == Verdict::untested) return "not compared: " + check.reason;
  const Decision& d = check.decision;
  if (check.verdict == Verdict::failed)
    return fmt::format("DISAGREES with {} in bin {}: |t| is {}, threshold {:.1f}; {}",
                       reference_method().name, d.worst, number_text(std::abs(d.statistic)),
                       d.threshold, d.detail);
  const std::string others = d.comparisons < check.bins
                                 ? fmt::format(", the other {} are not", check.bins - d.comparisons)
                                 : std::string();
  return fmt::format(
      "agrees with {} (largest |t| {:.1f} of {} reliable bins{}, threshold {:.1f}{})",
      reference_method().name, std::abs(d.statistic), d.comparisons, others, d.threshold,
      sight(d.visible));
}

ordered_json json_of(const Decision& d) {
  return {{"passed", d.passed},
          {"statistic", d.statistic},
          {"threshold", d.threshold},
          {"p_value", d.p_value},
          {"comparisons", d.comparisons},
          {"worst", d.worst},
          {"visible_error", finite_or_null(d.visible)}};
}

ordered_json json_of(const KernelCheck& check, const CheckReport& report) {
  const InvarianceReport& r = check.report;
  ordered_json json = {{"name", check.name},
                       {"verdict", word_of(verdict_of(r))},
                       {"words", words_of(check, report.steps, report.samples)},
                       {"paths", r.starts},
                       {"acted", r.acted},
                       {"moved", r.moved},
                       {"mean_acceptance", r.acceptance}};
  for (const Part& part : parts_of(r, report.steps)) {
    if (part.decision->comparisons == 0) continue;
    json[part.key] = json_of(*part.decision);
    json[part.key]["worst"] = part.name(part.decision->worst);
  }
  return json;
}

ordered_json json_of(const MethodCheck& check) {
  ordered_json json = {{"name", check.method},
                       {"reference", reference_method().name},
                       {"verdict", word_of(check.verdict)},
                       {"words", words_of(check)}};
  if (check.verdict != Verdict::untested) json["bins"] = json_of(check.decision);
  return json;
}

std::vector<std::string> not_tested_of(const KernelCheck& check, int steps) {
  std::vector<std::string> tests;
  for (const Part& part : parts_of(check.report, steps))
    if (part.decision->comparisons == 0) tests.push_back(part.words);
  return tests;
}

std::string outcome(const CheckReport& report) {
  const TestCounts counts = report.counts();
  const char* lead = report.passed()      ? ""
                     : counts.failed == 0 ? "NOTHING COULD BE TESTED: "
                                          : "FAILED: ";
  std::string text =
      fmt::format("{}{} test{} passed, {} failed, {} could not be made", lead, counts.passed,
                  counts.passed == 1 ? "" : "s", counts.failed, counts.not_made);
  text += counts.not_made > 0 ? ":\n" : "\n";
  for (const NotTested& missing : report.not_tested())
    text +=
        fmt::format("  {}, {}: {}\n", missing.name, fmt::join(missing.tests, ", "), missing.reason);
  return text;
}

}  // namespace

bool CheckReport::passed() const {
  const TestCounts tests = counts();
  return tests.failed == 0 && tests.passed > 0;
}

TestCounts CheckReport::counts() const {
  TestCounts counts;
  const auto add = [&](Verdict verdict) {
    ++(verdict == Verdict::untested ? counts.not_made
       : verdict == Verdict::passed ? counts.passed
                                    : counts.failed);
  };
  for (const KernelCheck& check : mutations)
    for (const Part& part : parts_of(check.report, steps))
      add(part.decision->comparisons == 0 ? Verdict::untested
          : part.decision->passed         ? Verdict::passed
                                          : Verdict::failed);
  for (const MethodCheck& check : methods) add(check.verdict);
  return counts;
}

std::vector<NotTested> CheckReport::not_tested() const {
  std::vector<NotTested> all;
  for (const KernelCheck& check : mutations)
    if (auto tests = not_tested_of(check, steps); !tests.empty())
      all.push_back({check.name, std::move(tests), reason_untested(check.report)});
  for (const MethodCheck& check : methods)
    if (check.verdict == Verdict::untested)
      all.push_back(
          {check.method, {fmt::format("against {}", reference_method().name)}, check.reason});
  return all;
}

std::string text_of(const CheckReport& report) {
  std::size_t width = 0;
  for (const KernelCheck& check : report.mutations) width = std::max(width, check.name.size());
  std::string text = "mutations\n";
  for (const KernelCheck& check : report.mutations)
    text += fmt::format("  {:<{}}  {}\n", check.name, width,
                        words_of(check, report.steps, report.samples));
  text += "methods\n";
  for (const MethodCheck& check : report.methods)
    text += fmt::format("  {:<{}}  {}\n", check.method, width, words_of(check));
  return text + outcome(report) +
         fmt::format("a correct program fails with a probability of {}\n",
                     number_text(report.false_alarm, 1));
}

ordered_json json_of(const CheckReport& report) {
  ordered_json mutations = ordered_json::array(), methods = ordered_json::array();
  for (const KernelCheck& check : report.mutations) mutations.push_back(json_of(check, report));
  for (const MethodCheck& check : report.methods) methods.push_back(json_of(check));
  const TestCounts counts = report.counts();
  ordered_json not_tested = ordered_json::array();
  for (const NotTested& missing : report.not_tested())
    not_tested.push_back(
        {{"name", missing.name}, {"tests", missing.tests}, {"reason", missing.reason}});
  return {{"schema", "wanderlight-check/1"},
          {"scene", {{"name", report.scene_name}, {"sha256", report.scene_sha256}}},
          {"samples", report.samples},
          {"method_samples", report.method_samples},
          {"seed", report.seed},
          {"false_alarm", report.false_alarm},
          {"passed", report.passed()},
          {"tests",
           {{"passed", counts.passed},
            {"failed", counts.failed},
            {"could_not_be_made", counts.not_made}}},
          {"not_tested", std::move(not_tested)},
          {"mutations", std::move(mutations)},
          {"methods", std::move(methods)}};
}

}  // namespace wander
