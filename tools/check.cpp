// `wander check`: does each mutation leave the target invariant on this scene, and do the methods
// agree?
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/parsing.h"
#include "lab/scene_source.h"
#include "tools/check_report.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/dial_options.h"
#include "tools/examined_job.h"
#include "tools/extremes_report.h"
#include "tools/interruption.h"
#include "tools/progress.h"
#include "tools/verb.h"

namespace wander {

namespace {

// Of the whole command; shared by its decisions after Bonferroni.
constexpr double false_alarm_of_all = 1e-6;
constexpr int steps = 20;
// A film needs more samples than a mutation: one method makes this many for each of --samples.
constexpr std::uint64_t samples_per_film = 4;

struct CheckOptions {
  std::string scene;
  std::shared_ptr<DialOptions> given = std::make_shared<DialOptions>();
  std::uint64_t samples = 200'000;
  bool wants_extremes = false;
  // Once the scene is read.
  std::optional<SceneDocument> document;
  std::optional<Job> job;
};

// Whose mutations are checked.
const Method& mutated_method() {
  return *methods_that([](const Method& m) { return m.state == ChainState::path; }).front();
}

std::uint64_t parse_samples(std::string_view text) {
  const Budget budget = parse_budget(text);
  if (const auto* count = std::get_if<SampleBudget>(&budget)) return count->samples;
  throw UsageError(
      fmt::format("--samples '{}': allowed is a number of samples (200000, 200k, 2M)", text));
}

// Says which of the parts is being made, and ends the command when it is interrupted.
class Parts {
 public:
  Parts(const Session& session, const Run& run, std::vector<std::string> names)
      : session_(session), run_(run), names_(std::move(names)) {
    say();
  }

  void done(std::uint64_t samples) {
    if (run_.is_interrupted())
      throw CommandFailure(ExitCode::interrupted, "interrupted before the check was complete");
    samples_ += samples;
    ++done_;
    say();
  }

 private:
  void say() const {
    if (!session_.report) return;
    const std::string& name = names_[std::min(done_, names_.size() - 1)];
    session_.report({static_cast<double>(done_) / static_cast<double>(names_.size()), samples_,
                     run_.seconds(), name.c_str()});
  }

  const Session& session_;
  const Run& run_;
  std::vector<std::string> names_;
  std::size_t done_ = 0;
  std::uint64_t samples_ = 0;
};

// In the order in which they are made.
std::vector<std::string> names_of_parts(const Family& family) {
  const std::vector<std::size_t> mutations = selectable(family);
  std::vector<std::string> names;
  for (const std::size_t i : mutations)
    names.push_back(fmt::format("mutation {}", Family::names[i]));
  if (mutations.size() > 1) names.emplace_back("the mixture of the mutations");
  names.push_back(fmt::format("film by {}, the reference", reference_method().name));
  for (const Method* method : checked_methods())
    names.push_back(fmt::format("film by {}", method->name));
  return names;
}

std::vector<std::string> names_of_symmetries() {
  std::vector<std::string> names;
  for (const Precision precision : std::views::reverse(precisions))
    for (const Method& method : methods())
      names.push_back(fmt::format("{} in {}", method.name, name_of(precision)));
  return names;
}

CheckReport check(const SceneDocument& document, const CheckOptions& options,
                  const Session& session) {
  const Job& job = *options.job;
  const Family family = job.family();
  const std::size_t mutations = selectable(family).size(), mixtures = mutations > 1 ? 1 : 0;
  const std::size_t kernels = mutations + mixtures, methods = checked_methods().size();
  const double false_alarm = false_alarm_of_all / static_cast<double>(3 * kernels + methods);
  CheckReport report{.scene_name = document.scene.name,
                     .scene_sha256 = document.sha256,
                     .samples = options.samples,
                     .method_samples = options.samples * samples_per_film,
                     .seed = session.seed,
                     .steps = steps,
                     .false_alarm = false_alarm_of_all};
  const Run run(session);
  Parts parts(session, run, names_of_parts(family));
  check_mutations(job,
                  {.samples = options.samples,
                   .steps = steps,
                   .seed = session.seed,
                   .false_alarm = false_alarm},
                  run, [&](KernelCheck result) {
                    parts.done(options.samples);
                    report.mutations.push_back(std::move(result));
                  });
  Session rendering = session;
  rendering.budget = SampleBudget{report.method_samples};
  rendering.report = nullptr;
  report.methods =
      check_methods(job, rendering, false_alarm, [&] { parts.done(report.method_samples); });
  return report;
}

void examine(CheckOptions& options, const Global& global, Examination& examination) {
  examination.part([&] {
    if (!global.out.empty()) throw UsageError("check writes no files; --json prints one document");
  });
  if (options.scene.empty()) return;
  examination.part([&] { options.document = open_scene(options.scene); });
  if (!options.document) return;
  options.job =
      examined_job(options.document->scene, mutated_method(), options.given->dials, examination);
}

Session session_of(const CheckOptions& options, const Global& global, Progress& progress) {
  return {.budget = SampleBudget{options.samples},
          .seed = global.seed,
          .threads = global.threads,
          .interrupted = &watch_for_interruption(),
          .report = progress.reporter(Lines::of_each_phase)};
}

ExitCode check_extremes(const SceneDocument& document, const CheckOptions& options,
                        const Global& global) {
  ExtremesReport report{.scene_name = document.scene.name,
                        .scene_sha256 = document.sha256,
                        .samples = options.samples,
                        .seed = global.seed};
  {
    Progress progress(global);
    const Session session = session_of(options, global, progress);
    const Run run(session);
    Parts parts(session, run, names_of_symmetries());
    Session rendering = session;
    rendering.report = nullptr;
    report.checks = check_symmetries(*options.job, variations_of(options.job->scene()), rendering,
                                     [&] { parts.done(options.samples); });
  }
  if (global.json)
    print_json(json_of(report));
  else
    print_data(text_of(report));
  return report.passed() ? ExitCode::ok : ExitCode::check_failed;
}

ExitCode check_scene(const CheckOptions& options, const Global& global) {
  const SceneDocument& document = *options.document;
  for (const std::string& warning : scene_warnings(document, options.scene))
    spdlog::warn("{}", warning);
  if (options.wants_extremes) return check_extremes(document, options, global);
  CheckReport report;
  {
    Progress progress(global);
    report = check(document, options, session_of(options, global, progress));
  }
  if (global.json)
    print_json(json_of(report));
  else
    print_data(text_of(report));
  return report.passed() ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

void add_check(CLI::App& app, Global& global) {
  auto options = std::make_shared<CheckOptions>();
  Command verb =
      add_verb(app, "check",
               "test that each mutation leaves the target invariant and that the methods agree");
  verb.add_option("SCENE", options->scene, scene_help).type_name("").required();
  add_dial_options(verb, chain_dials, options->given);
  verb.add_option(
          "--samples",
          [options](const std::string& text) { options->samples = parse_samples(text); },
          "independent paths from which each mutation starts (default: 200k)")
      .type_name("N");
  verb.add_flag("--extremes", options->wants_extremes,
                "instead: lengths and radiances times powers of two, a quarter turn, a material "
                "that is not used; no bit of any method's film may change");
  add_global_options(verb, global);
  verb.footer(
      "\nEach mutation, and their mixture, starts from weighted independent paths and makes 1 and "
      "20\nsteps; films are compared bin by bin, those of images with 16 pixels along the longer "
      "side.\nExit code 4 when a test fails, and when none could be made; what could not be tested "
      "is\nlisted with the reason.  \"2 % would show\": an error of 2 %, of what is compared, "
      "would be "
      "seen\nwith a probability of 99 % by half of the comparisons of the sharpest test.\n\n"
      "Example:\n  wander check scene.json --samples 1M");
  examine_with(verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb.callback([options, &global] {
    global.job = [options, &global] { return check_scene(*options, global); };
  });
}

}  // namespace wander
