// What `wander inspect` has to say about a scene, a run, a trajectory or a comparison: a JSON
// document for programs, the same in a dozen lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lab/compare/comparison.h"
#include "lab/probe.h"
#include "records/run_record.h"
#include "records/trajectory_record.h"
#include "scenes/format/scene_file.h"

namespace wander {

nlohmann::ordered_json inspect_scene(const SceneDocument& document, const Probe& probe);
std::string text_of_scene(const nlohmann::ordered_json& inspection);

// A run held against another one of the same scene.  Throws UsageError if the films differ in
// shape.
nlohmann::ordered_json compare_runs(const RunRecord& run, const RunRecord& reference);

nlohmann::ordered_json inspect_run(const RunRecord& run);
std::string text_of_run(const RunRecord& run);
std::string text_of_comparison(const nlohmann::ordered_json& comparison);

nlohmann::ordered_json inspect_trajectory(const TrajectoryRecord& record);
std::string text_of_trajectory(const TrajectoryRecord& record);

// The command, version, build, machine and date, as lines for people.
std::string made_by_lines(const Provenance& provenance);

// Of many runs: `wander compare`.  Without films.
nlohmann::ordered_json inspect_comparison(const compare::Comparison& comparison);
std::string text_of_comparison(const compare::Comparison& comparison);

}  // namespace wander
