#include "tools/run_directory.h"

#include <spdlog/spdlog.h>

#include <system_error>
#include <utility>

#include "draw/report/comparison_files.h"
#include "lab/compare/kept_comparison.h"
#include "records/run_files.h"

namespace wander {

namespace {

bool is_of_what_is_kept(Beginning beginning) {
  return beginning == Beginning::carried_on || beginning == Beginning::carried_further;
}

Global replacing_itself(Global global, Beginning beginning) {
  global.force = global.force || beginning != Beginning::anew;
  return global;
}

}  // namespace

RunDirectory::RunDirectory(const std::filesystem::path& path, const Global& global,
                           Beginning beginning)
    : place_(path, replacing_itself(global, beginning)), beginning_(beginning) {
  require_file(checkpoint_in(place_.path()));
}

Keeper RunDirectory::keeper(Keeper when, Checkpoint run) {
  run_ = std::move(run);
  is_kept_ = is_of_what_is_kept(beginning_);
  if (!(when.every > 0)) return when;
  if (beginning_ == Beginning::carried_further || (!is_kept_ && !has_something())) {
    write_checkpoint(
        run_, [&](std::ostream& bytes) { bytes << run_.run.state; }, path());
    is_kept_ = true;
  }
  std::string().swap(run_.run.state);
  when.keep = [this](const Headway& headway, const StateWriter& state) { keep(headway, state); };
  return when;
}

// Of another run, or of a comparison.
bool RunDirectory::has_something() const {
  std::error_code error;
  return holds_run(path()) || std::filesystem::exists(checkpoint_in(path()), error) ||
         compare::holds_comparison(path()) || compare::holds_kept_comparison(path());
}

void RunDirectory::keep(const Headway& headway, const StateWriter& state) {
  run_.run.headway = headway;
  try {
    write_checkpoint(run_, state, path());
    failure_.reset();
  } catch (const OutputError& error) {
    if (!failure_) spdlog::warn("{}; the run goes on without", error.what());
    failure_ = error;
    return;
  }
  if (!is_kept_) {
    remove_run(path());
    compare::remove_comparison(path());
  }
  is_kept_ = true;
}

void RunDirectory::save(const RunRecord& run, const description::Scene& scene, double exposure) {
  write_run(run, scene, path(), exposure);
  if (!is_kept_) remove_file(checkpoint_in(path()));
  if (beginning_ == Beginning::anew) compare::remove_comparison(path());
}

void RunDirectory::require_kept() const {
  if (failure_) throw *failure_;
}

}  // namespace wander
