// The directory of a run that is computed: what is kept of it to carry it on, its film, and what stood there before.
#pragma once

#include <filesystem>
#include <optional>

#include "core/description.h"
#include "lab/checkpoint.h"
#include "lab/drive.h"
#include "records/atomic_file.h"
#include "records/run_record.h"
#include "tools/command.h"
#include "tools/output_place.h"

namespace wander {

// Is what is kept in the directory of this run already, and does it go further than that says?
// One that is begun again is a new one in the place of its old self.
enum class Beginning { anew, begun_again, carried_on, carried_further };

// What stood there before a run that replaces it goes when there is something of the new one, and no sooner: a
// program that is killed leaves the one or the other.
class RunDirectory {
 public:
  // Throws as OutputDirectory does.
  RunDirectory(const std::filesystem::path& path, const Global& global, Beginning beginning);

  const std::filesystem::path& path() const { return place_.path(); }
  // Keeps `run` there from now on, as often as `when` says, as long as this directory is there.  Throws OutputError if
  // that cannot be begun.  What cannot be kept later, as on a full disk, takes no film with it: the run goes on.
  Keeper keeper(Keeper when, Checkpoint run);
  void save(const RunRecord& run, const description::Scene& scene, double exposure);
  // Throws the OutputError of the last checkpoint, if there was one.
  void require_kept() const;

 private:
  void keep(const Headway& headway, const StateWriter& state);
  bool has_something() const;

  OutputDirectory place_;
  Beginning beginning_;
  bool is_kept_ = false;
  Checkpoint run_;
  std::optional<OutputError> failure_;
};

}  // namespace wander
