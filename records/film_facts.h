// What made a film, and what is known of it as a whole, by name: the attributes of the files that
// hold films.
//
//   scene, scene_name, scene_sha256, scene_files (scene_record.h), command_line, wanderlight_version,
//   the origin (origin.h), method, seed, merged_seeds, samples, complete    texts
//   dimension, max_vertices where it is known        whole numbers
//   degrees_of_freedom, and for Markov chain methods
//   normalization, normalization_standard_error      numbers
#pragma once

#include <map>
#include <string>
#include <variant>

#include "records/run_record.h"

namespace wander {

using FilmFact = std::variant<std::string, int, double>;
using FilmFacts = std::map<std::string, FilmFact>;

FilmFacts facts_of(const RunRecord& run);

// The run of these facts, whose film has no numbers yet; its times are NaN, for they are none of
// them.  Throws std::runtime_error if one is missing or of another kind; others are let be.
RunRecord run_of(const FilmFacts& facts);

}  // namespace wander
