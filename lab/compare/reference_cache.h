// Long runs that were made as references, kept for the next comparison of the same scene: files in
// $XDG_CACHE_HOME/wanderlight, or else ~/.cache/wanderlight, which may be removed at any time.
//
// One file holds the independent runs of one method at one setting, by one version of the program, on one
// scene with paths of one greatest length: a line of JSON, the runs as they are archived, and a seal
// (records/seal.h), so that what was cut short or changed is no reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "records/run_record.h"

namespace wander::compare {

struct LongRuns {
  std::string made_by;  // "mlt", "mlt --mutations lens=1"
  std::vector<Rendering> runs;
};

class ReferenceCache {
 public:
  ReferenceCache(Provenance provenance, int max_vertices);

  // What there is of films of this shape; each file that is broken adds a warning, and is as good
  // as none.
  std::vector<LongRuns> load(const std::vector<int>& shape,
                             std::vector<std::string>& warnings) const;
  // A place that cannot be written to is a warning.
  void store(const LongRuns& runs, std::vector<std::string>& warnings) const;

  // Where files are looked for; empty if the environment names no place.
  static std::filesystem::path folder();

 private:
  std::filesystem::path file_of(const LongRuns& runs) const;

  Provenance provenance_;
  int max_vertices_;
};

}  // namespace wander::compare
