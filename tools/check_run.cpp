#include "tools/check_run.h"

#include <fmt/format.h>

#include "lab/engine.h"
#include "tools/check_parts.h"

namespace wander {

namespace {

// Of the whole command; shared by its decisions after Bonferroni.
constexpr double false_alarm_of_all = 1e-6;
constexpr int steps = 20;
// A film needs more samples than a mutation: one method makes this many for each of --samples.
constexpr std::uint64_t samples_per_film = 4;

// In the order in which they are made.
std::vector<std::string> names_of_parts(std::span<const std::string_view> mutations) {
  std::vector<std::string> names;
  for (const std::string_view name : mutations) names.push_back(fmt::format("mutation {}", name));
  if (mutations.size() > 1) names.emplace_back("the mixture of the mutations");
  names.push_back(fmt::format("film by {}, the reference", reference_method().name));
  for (const Method* method : checked_methods())
    names.push_back(fmt::format("film by {}", method->name));
  return names;
}

}  // namespace

// Whose mutations are checked.
const Method& mutated_method() {
  return *methods_that([](const Method& m) { return m.state == ChainState::path; }).front();
}

CheckReport check(const SceneDocument& document, const Job& job, std::uint64_t samples,
                  const Session& session) {
  const auto mutations = names_taken(job.family(), requires_of(job.scene()));
  const std::size_t mixtures = mutations.size() > 1 ? 1 : 0;
  const std::size_t kernels = mutations.size() + mixtures, methods = checked_methods().size();
  const double false_alarm = false_alarm_of_all / static_cast<double>(3 * kernels + methods);
  CheckReport report{.scene_name = document.scene.name,
                     .scene_sha256 = document.digest.text,
                     .samples = samples,
                     .method_samples = samples * samples_per_film,
                     .seed = session.seed,
                     .steps = steps,
                     .false_alarm = false_alarm_of_all};
  const Run run(session);
  CheckParts parts(session, run, names_of_parts(mutations));
  check_mutations(
      job, {.samples = samples, .steps = steps, .seed = session.seed, .false_alarm = false_alarm},
      run, [&](KernelCheck result) {
        parts.done(samples);
        report.mutations.push_back(std::move(result));
      });
  Session rendering = session;
  rendering.budget = SampleBudget{report.method_samples};
  rendering.report = nullptr;
  report.methods =
      check_methods(job, rendering, false_alarm, [&] { parts.done(report.method_samples); });
  return report;
}

}  // namespace wander
