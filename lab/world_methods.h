// The methods by chains in primary sample space, and the run of any method, in one world: light
// transport is written for any precision, and each world is made in a file of its own
// (world_methods_plane.cpp, world_methods_plane_float.cpp, ...).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "lab/chain_methods.h"
#include "lab/chains_on_stage.h"
#include "lab/drive.h"
#include "lab/failure.h"
#include "lab/held_run.h"
#include "lab/render.h"
#include "lab/run_state.h"
#include "lab/worlds.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/kelemen.h"
#include "scenes/format/build_scene.h"

namespace wander {

// ---- methods by Markov chains in primary sample space

template <template <class S, class SmallStep, class Estimator> class Chains, World W>
std::unique_ptr<LiveRun> in_primary_space(const Stage<W>& stage) {
  const Dials& dials = stage.job.dials();
  const auto kernel = [large_step = dials.large_step](double factor) {
    return PrimaryKernel<Kelemen>{Kelemen{}.scaled(factor), large_step};
  };
  using Space = Transport<W>;
  return stage.job.estimator() == StepEstimator::kelemen
             ? chain_run<Chains<Space, Kelemen, KelemenWeights>>(stage, kernel)
             : chain_run<Chains<Space, Kelemen, ExpectedValues>>(stage, kernel);
}

template <World W>
std::unique_ptr<LiveRun> PssmltMethod::make(const Stage<W>& stage) {
  return in_primary_space<PssmltGroup>(stage);
}
template <World W>
std::unique_ptr<LiveRun> MmltMethod::make(const Stage<W>& stage) {
  return in_primary_space<MmltGroup>(stage);
}

// ---- all methods

template <World W>
class WorldMethods {
 public:
  // A run that is made goes on as long as these methods and `execution` are there.
  WorldMethods(const Job& job, const Run& execution)
      : job_(job),
        execution_(execution),
        scene_(build_scene<W>(job.scene())),
        space_(*scene_, Roulette::off) {}

  std::unique_ptr<LiveRun> make() const {
    const auto made = std::get<MakeRun<W>>(job_.method().run.makers);
    return made({job_, execution_, *scene_, space_});
  }

  // What there is to say against the film of a run that has come to its end.
  void doubt(Rendering& rendering) const {
    if (job_.method().is_markov_chain()) return;
    warn_if_dark(rendering);
    warn_if_blind(rendering);
  }

 private:
  static void warn_if_dark(Rendering& rendering) {
    const auto& value = rendering.film.value;
    if (std::ranges::any_of(value, [](double v) { return v > 0; })) return;
    rendering.warnings.push_back(
        fmt::format("no light path was found, so the film is zero; {}", where_light_is_lost));
  }

  // How much of the light is missing from a bin nobody knows: none is reliable.
  void warn_if_blind(Rendering& rendering) const {
    const std::string_view why = job_.method().why_blind(job_.scene());
    if (why.empty()) return;
    rendering.film.reliable.assign(rendering.film.reliable.size(), false);
    const auto better = methods_that([&](const Method& method) {
      return method.check != CheckRole::none && method.sees_all_light(job_.scene());
    });
    rendering.warnings.push_back(
        fmt::format("{} {}, so their light is missing from this film; use {}", job_.method().name,
                    why, in_words(better, "or")));
  }

  const Job& job_;
  const Run& execution_;
  std::unique_ptr<const Scene<W>> scene_;
  Transport<W> space_;
};

inline void load(LiveRun& run, const std::string& state, std::string_view remedy) {
  try {
    if (!state.empty()) restore(run, state);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& problem) {
    throw CommandFailure(
        ExitCode::invalid_input,
        fmt::format("the state in the checkpoint is not one that this build of the program reads "
                    "({}); {}",
                    problem.what(), remedy));
  }
}

// The same bits whether it is interrupted or not: from the seed pass it goes on as it was kept, not
// from the chains that show what an interrupted one had found.
template <World W>
class RunInWorld final : public WorldRun {
 public:
  RunInWorld(const KeptRun& from, const Job& job, const Session& session)
      : session_(session),
        execution_(std::in_place, session_),
        methods_(job, *execution_),
        headway_(from.headway) {
    begin(from.state);
  }

  Rendering go_on(const Session& session, const Keeper& keeper) override {
    session_ = session;
    execution_.emplace(session_);  // where the run knows it
    const Farewell farewell{session_};
    if (!unstarted_.empty()) begin(std::exchange(unstarted_, {}));
    Keeper both = keeper;
    both.keep = [&](const Headway& headway, const StateWriter& state) {
      headway_ = headway;
      if (run_->takes_seeds() && execution_->is_interrupted()) unstarted_ = bytes_of(state);
      if (keeper.keep) keeper.keep(headway, state);
    };
    try {
      Rendering rendering = drive(*run_, *execution_, headway_, both);
      methods_.doubt(rendering);
      return rendering;
    } catch (...) {
      if (run_->samples() == 0) begin({});
      throw;
    }
  }
  const Headway& headway() const override { return headway_; }
  KeptRun kept() const override {
    return {headway_, unstarted_.empty() ? state_of(*run_) : unstarted_};
  }

 private:
  // Who asked for this much need not be there any more when it is over.
  struct Farewell {
    Session& session;
    ~Farewell() {
      session.interrupted = nullptr;
      session.report = nullptr;
    }
  };

  void begin(const std::string& state) {
    run_ = methods_.make();
    load(*run_, state,
         "carry the run on with the build that began it, or compute it anew, with --force instead "
         "of --continue");
  }
  static std::string bytes_of(const StateWriter& state) {
    std::ostringstream bytes;
    state(bytes);
    return std::move(bytes).str();
  }

  Session session_;
  std::optional<Run> execution_;
  WorldMethods<W> methods_;
  std::unique_ptr<LiveRun> run_;
  Headway headway_;
  std::string unstarted_;  // the state of an interrupted seed pass
};

template <World W>
std::unique_ptr<WorldRun> hold_in(const KeptRun& from, const Job& job, const Session& session) {
  return std::make_unique<RunInWorld<W>>(from, job, session);
}

// One after the other: of each run what it found is kept, not its state.
template <World W>
Rendering merge_in(const Job& job, std::span<const StoredRun> runs, const Session& session) {
  Run execution(session);
  std::unique_ptr<Findings> all;
  for (const StoredRun& stored : runs) {
    Session its_session = session;
    its_session.seed = stored.seed;
    const Run its_execution(its_session);
    const WorldMethods<W> methods(job, its_execution);
    const std::unique_ptr<LiveRun> run = methods.make();
    load(*run, stored.state(), stored.remedy);
    if (!all) all = run->no_findings();
    run->add_to(*all);
    all->keep();
  }
  Rendering rendering;
  run_within(execution, [&] { rendering = all->rendering(); });
  WorldMethods<W>(job, execution).doubt(rendering);
  return rendering;
}

}  // namespace wander
