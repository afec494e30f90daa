// What errors are measured against, and how well it is known, where nothing need be sampled for it:
//
//   a file   a film that was made before
//   exact    where the scene is diffuse: core/exact/diffuse_film.h
//
// Else it is made of long runs (long_reference.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/description.h"
#include "lab/compare/runs.h"

namespace wander::compare {

// For the film of a scene, `asked`, which is `provenance`.  Throws RunFileError where it cannot be read or is an image of
// another shape, UsageError where it is a row of bins of another length.
Reference reference_from_file(const std::filesystem::path& file, const description::Scene& asked,
                              const Provenance& provenance, std::vector<std::string>& warnings);

// None where the scene is not diffuse, or not known exactly enough; `why` then says so.
std::optional<Reference> exact_reference(const description::Scene& scene, std::string& why);

// Of which nothing is known: a film of unknown values.
Reference no_reference(const std::vector<int>& shape);

}  // namespace wander::compare
