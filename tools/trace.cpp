// `wander trace`: runs some Markov chains and records their steps, or takes one step apart.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/parsing.h"
#include "lab/replay.h"
#include "lab/scene_source.h"
#include "lab/trace.h"
#include "lab/trace_request.h"
#include "lab/wording.h"
#include "records/atomic_file.h"
#include "records/trajectory_csv.h"
#include "records/trajectory_netcdf.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/dial_options.h"
#include "tools/examined_job.h"
#include "tools/inspection.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"
#include "tools/replay_report.h"
#include "tools/verb.h"

namespace wander {

namespace {

constexpr std::uint64_t default_steps = 1000;
constexpr std::uint64_t most_steps = std::uint64_t{1} << 53;

struct TraceOptions {
  std::string scene;
  const Method* method = traced_methods().front();
  std::shared_ptr<DialOptions> given = std::make_shared<DialOptions>();
  std::optional<int> chains_asked;
  int chains() const { return chains_asked.value_or(4); }
  std::optional<std::uint64_t> steps;
  std::uint64_t every = 1;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> window;
  struct Step {
    int chain;
    std::uint64_t step;
  };
  std::optional<Step> replay;
  bool is_replay = false;  // also where its step could not be read
  // Once the scene is read.
  std::optional<SceneDocument> document;
  std::optional<Job> job;
};

// Of the run that is asked for, where it is said how large that is.
void require_within(const TraceOptions::Step& replay, const TraceOptions& options) {
  const auto refuse = [&](const char* what, auto most) {
    throw UsageError(
        fmt::format("--replay {}:{}: there is no such {} among the {} that are asked for",
                    replay.chain, replay.step, what, most));
  };
  if (options.chains_asked && replay.chain >= *options.chains_asked)
    refuse("chain", *options.chains_asked);
  if (options.steps && replay.step >= *options.steps) refuse("step", *options.steps);
}

void require_traceable(const TraceOptions& options) {
  const Method& method = *options.method;
  require_traced(method);
  options.given->require_for(method);
  if (options.replay && !method.is_replayed())
    throw UsageError(fmt::format(
        "--replay takes apart steps of {}, which are proposed in path space; those of {} are moves "
        "of random numbers: record them with -o FILE.nc, which has every term of their acceptance",
        in_words(methods_that([](const Method& m) { return m.is_replayed(); })), method.name));
  if (options.replay) require_within(*options.replay, options);
}

bool is_csv(const Global& global) {
  const std::string ending = global.out.extension().string();
  return ending == ".csv" || ending == ".CSV";
}

void require_sensible_output(const TraceOptions& options, const Global& global) {
  if (options.is_replay) {
    if (global.out.empty()) return;
    throw UsageError("--replay prints one step and writes no file; leave out -o");
  }
  if (global.out.empty() && !global.json)
    throw UsageError("trace needs -o FILE.nc (or FILE.csv), or --json, or both");
  if (global.out.empty()) return;
  if (is_standard_output(global.out))
    throw UsageError(
        "-o - is standard output, where no netCDF file can be made; write FILE.nc, or FILE.csv for "
        "rows of text");
  require_replaceable(global.out, global);
  require_apart(global.out, std::span(&options.scene, 1));
  require_writable_directory(global.out);
}

// The chains run no further than the last recorded step.
TraceWindow window_of(const TraceOptions& options) {
  TraceWindow window{
      .first = 0, .end = options.steps.value_or(default_steps), .every = options.every};
  if (options.window) {
    const auto [first, end] = *options.window;
    if (first >= end || (options.steps && end > *options.steps))
      throw UsageError(fmt::format(
          "--window {}:{}: allowed is A:B with A < B{}; the steps A to B - 1 are recorded", first,
          end, options.steps ? fmt::format(" <= {}, the steps of a chain", *options.steps) : ""));
    window.first = first;
    window.end = end;
  }
  require_bounded({options.chains(), window});
  return window;
}

TrajectoryRecord record_of(const SceneDocument& document, const TraceOptions& options,
                           const Global& global, Trace&& trace) {
  return {.trajectory = std::move(trace.trajectory),
          .complete = trace.complete,
          .method = std::string(options.method->name),
          .seed = global.seed,
          .normalization = trace.normalization,
          .provenance = provenance_of(document, global.command_line)};
}

void write(const TrajectoryRecord& record, const description::Scene& scene, const Global& global) {
  write_file(global.out, is_csv(global) ? to_csv(record.trajectory) : to_netcdf(record, scene));
}

ExitCode record_chains(const SceneDocument& document, const TraceOptions& options,
                       const Session& session, const Global& global) {
  const TraceRequest request{options.chains(), window_of(options)};
  Trace trace = wander::trace(*options.job, session, request);
  const double seconds = trace.seconds, seed_seconds = trace.seed_seconds;
  const int threads = trace.threads;
  const TrajectoryRecord record = record_of(document, options, global, std::move(trace));
  if (!global.out.empty()) write(record, options.job->scene(), global);

  if (!global.quiet) {
    print_note(text_of_trajectory(record));
    print_note(fmt::format("  time            {}, of which seed pass {}\n",
                           duration_in_words(seconds), duration_in_words(seed_seconds)));
    if (!global.out.empty()) print_note(fmt::format("  saved as        {}\n", global.out.string()));
  }
  if (global.json) {
    nlohmann::ordered_json json = inspect_trajectory(record);
    json["schema"] = "wanderlight-trace/1";
    json.erase("kind");
    json["threads"] = threads;
    json["seconds"] = seconds;
    json["seed_seconds"] = seed_seconds;
    if (!global.out.empty()) json["file"] = global.out.string();
    print_json(json);
  }
  return record.complete ? ExitCode::ok : ExitCode::interrupted;
}

ExitCode replay_step(const TraceOptions& options, const Session& session, const Global& global) {
  const Replay step = replay(*options.job, session, options.replay->chain, options.replay->step);
  if (global.json)
    print_json(json_of_replay(step));
  else
    print_data(text_of_replay(step));
  return ExitCode::ok;
}

void examine(TraceOptions& options, const Global& global, Examination& examination) {
  examination.part([&] { require_sensible_output(options, global); });
  examination.part([&] { require_traceable(options); });
  examination.part([&] { window_of(options); });
  if (options.scene.empty()) return;
  examination.part([&] { options.document = open_scene(options.scene); });
  if (!options.document) return;
  options.job =
      examined_job(options.document->scene, *options.method, options.given->dials, examination);
}

ExitCode trace_scene(const TraceOptions& options, const Global& global) {
  const SceneDocument& document = *options.document;
  for (const std::string& warning : scene_warnings(document, options.scene))
    spdlog::warn("{}", warning);
  Progress progress(global);
  const Session session{.seed = global.seed,
                        .threads = global.threads,
                        .interrupted = &watch_for_interruption(),
                        .report = progress.reporter()};
  try {
    return options.replay ? replay_step(options, session, global)
                          : record_chains(document, options, session, global);
  } catch (const NothingComputed& nothing) {
    throw CommandFailure(ExitCode::interrupted, nothing.what());
  }
}

TraceOptions::Step parse_step(const std::string& text) {
  const auto [chain, step] = parse_pair("--replay", text);
  if (chain >= most_traced_chains)
    throw UsageError(fmt::format("--replay {}: allowed is CHAIN:STEP with a chain from 0 to {}",
                                 text, most_traced_chains - 1));
  return {static_cast<int>(chain), step};
}

constexpr const char* trace_details = R"(
One draw is one step of a chain: what was proposed, every term of its acceptance
probability, and the state after the decision.  A file with the ending .csv has one row
per draw; any other is netCDF-4 and opens with arviz.from_netcdf.

The chains are those that `render --film chains --target light --kernel 1` runs by the same
method with the same scene, dials and seed, no --chains, and a budget of 256 to 131072 mutations; where
samples find light often, those of its pooled film, too.  A chain of mmlt keeps to paths of one
length: the lengths share the chains in proportion to their light.  Ctrl-C saves the draws
that all chains have.

Examples:
  wander trace scene.json --steps 2000 --chains 4 -o chains.nc
  wander trace scene.json -m mmlt --chains 8 -o lengths.nc
  wander trace scene.json --replay 0:17
)";

void add_trace_options(Command verb, const std::shared_ptr<TraceOptions>& options) {
  const auto option = [&](const char* name, const char* type, const std::string& help,
                          auto&& parse) { verb.add_option(name, parse, help).type_name(type); };
  verb.add_option("SCENE", options->scene, scene_help).type_name("").required();
  option("-m,--method", "METHOD",
         fmt::format("{} (default: {})", in_words(traced_methods(), "or"), options->method->name),
         [options](const std::string& text) { options->method = &find_method(text); });
  add_dial_options(verb, chain_dials, options->given);
  option("--chains", "N", "how many chains (default: 4)", [options](const std::string& text) {
    options->chains_asked = static_cast<int>(parse_count("--chains", text, 1, most_traced_chains));
  });
  option("--steps", "N", "steps of each chain (default: 1000)", [options](const std::string& text) {
    options->steps = parse_count("--steps", text, 1, most_steps);
  });
  option("--every", "K", "record one step of K (default: 1)", [options](const std::string& text) {
    options->every = parse_count("--every", text, 1, most_steps);
  });
  option("--window", "A:B", "record the steps A to B - 1 of each chain (default: all)",
         [options](const std::string& text) { options->window = parse_pair("--window", text); });
  option("--replay", "CHAIN:STEP", "record nothing; print every factor of this one step",
         [options](const std::string& text) {
           options->is_replay = true;
           options->replay = parse_step(text);
         });
}

}  // namespace

void add_trace(CLI::App& app, Global& global) {
  auto options = std::make_shared<TraceOptions>();
  Command verb = add_verb(app, "trace", "run Markov chains and record every mutation");
  add_trace_options(verb, options);
  add_global_options(verb, global);
  verb.footer(trace_details);
  examine_with(verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb.callback([options, &global] {
    global.job = [options, &global] { return trace_scene(*options, global); };
  });
}

}  // namespace wander
