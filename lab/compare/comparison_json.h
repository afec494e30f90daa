// `compare.json`, schema "wanderlight-compare/1": the whole of a comparison, and its way back.
//
//   verdict, cautions, complete, scene, dimension, command_line, version, warnings
//   contenders, budgets, replicates        what was compared; lists are referred to by index
//   decisive_budget, ranking, target       of contenders, least error first
//   reference                              its origin in words, and the film
//   cells, curves, crossings, profiles     with the names and units of comparison.h
//     of a curve, "extrapolated": true     its seconds_to_target lie beyond its longest run
//   runs                                   each with seed, samples, seconds, errors, film, and the
//                                          command that makes it again
//   failures                               runs that gave no film, and why
//   details                                a run.json for the first replicate of each contender
//
// What is measured is {"value", "low", "high"}, the interval of 95 %; what is not known is null.
// Films of scenes in space have a shape alone; "file" of the reference and of a cell names the image
// that lies beside compare.json (film_files.h).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lab/compare/comparison.h"

namespace wander::compare {

inline constexpr const char* comparison_schema = "wanderlight-compare/1";

nlohmann::ordered_json to_json(const Comparison& comparison);

// A document that is not such a comparison throws RunFileError; `place` names it in the message.
Comparison comparison_from_json(const nlohmann::ordered_json& document, const std::string& place);

// Reads compare.json or the directory that holds it; none if the file is something else.  Throws
// RunFileError if it is one but broken.
std::optional<Comparison> find_comparison(const std::filesystem::path& path);

}  // namespace wander::compare
