// Where outputs may go: nothing of the user's is replaced without --force.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/verb.h"

namespace wander {

// Throws UsageError if `file` exists and may not be replaced.  Allowed are --force, pipes and
// devices, and files beside a run that the program itself wrote.
void require_replaceable(const std::filesystem::path& file, const Global& global);
// Throws OutputError if no file can be made in the directory of `file`; pipes and devices need
// none.
void require_writable_directory(const std::filesystem::path& file);

// The directory of a run, made when this object is and gone again with it if nothing was written.
class OutputDirectory {
 public:
  // An existing directory must be empty, hold a run or comparison of the program, or be forced.
  // Throws UsageError or OutputError, before anything is computed.
  OutputDirectory(const std::filesystem::path& path, const Global& global);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // outermost first
};

}  // namespace wander
