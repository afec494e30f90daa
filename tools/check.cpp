// `wander check`: does each mutation leave the target invariant on this scene, and do the methods
// agree?
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/parsing.h"
#include "lab/scene_source.h"
#include "tools/check_parts.h"
#include "tools/check_report.h"
#include "tools/check_run.h"
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

struct CheckOptions {
  std::string scene;
  std::shared_ptr<DialOptions> given = std::make_shared<DialOptions>();
  std::uint64_t samples = usual_check_samples;
  bool wants_extremes = false;
  // Once the scene is read.
  std::optional<SceneDocument> document;
  std::optional<Job> job;
};

std::uint64_t parse_samples(std::string_view text) {
  if (const auto count = sample_count_in(text)) return *count;
  throw UsageError(fmt::format(
      "--samples '{}': allowed is a whole number of samples, one or more (200000, 200k, 2M)",
      text));
}

std::vector<std::string> names_of_symmetries() {
  std::vector<std::string> names;
  for (auto precision = precisions.rbegin(); precision != precisions.rend(); ++precision)
    for (const Method& method : methods())
      names.push_back(fmt::format("{} in {}", method.name, name_of(*precision)));
  return names;
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
                        .scene_sha256 = document.digest.text,
                        .samples = options.samples,
                        .seed = global.seed};
  {
    Progress progress(global);
    const Session session = session_of(options, global, progress);
    const Run run(session);
    CheckParts parts(session, run, names_of_symmetries());
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
    report = check(document, *options.job, options.samples, session_of(options, global, progress));
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
      "side.\nExit code 4 when a test fails, and when none could be made, 1 when no light path is "
      "found;\nwhat could not be tested is listed with the reason.  \"2 % would show\": an error "
      "of 2 %,"
      "\nof what is compared, would be seen with a probability of 99 % by half of the comparisons "
      "of the\nsharpest test.\n\n"
      "Example:\n  wander check scene.json --samples 1M");
  examine_with(verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb.callback([options, &global] {
    global.job = [options, &global] { return check_scene(*options, global); };
  });
}

}  // namespace wander
