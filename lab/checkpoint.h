// The file in which a run is kept beside its record, so that it can be carried on.
//
//   "wanderlight-checkpoint/N\n" HEADER "\n" STATE SEAL
//
// HEADER is one line of JSON: what was asked for, with the text of the scene, and how far the run
// has come.  STATE, packed by zstd, is read by the version of the program that wrote it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "lab/dials.h"
#include "lab/drive.h"
#include "lab/kept_scene.h"

namespace wander {

struct Checkpoint {
  KeptScene scene;
  std::string method, budget;
  std::map<std::string, std::string> dials;  // those that were turned: word, value
  std::uint64_t seed = 1;
  KeptRun run;

  Dials turned() const;  // throws UsageError
};

std::filesystem::path checkpoint_in(const std::filesystem::path& directory);

// With this state instead of its own.  Whole or not at all; throws OutputError.
void write_checkpoint(const Checkpoint& checkpoint, const StateWriter& state,
                      const std::filesystem::path& directory);

// Throws UsageError if there is none, RunFileError if it is damaged or of another version; `remedy`
// ends the message.
Checkpoint read_checkpoint(const std::filesystem::path& directory, std::string_view remedy);

}  // namespace wander
