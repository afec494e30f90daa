// Where outputs may go: nothing that exists is replaced without --force.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "records/atomic_file.h"
#include "tools/verb.h"

namespace wander {

// `-o -`
bool is_standard_output(const std::filesystem::path& path);

// Throws UsageError if `file` exists and may not be replaced.  Allowed are --force, pipes and
// devices, and standard output unless --json has it.
void require_replaceable(const std::filesystem::path& file, const Global& global);
// The same of a directory, which may be empty: what it holds, a finished run or an interrupted one
// or a comparison too, is replaced only with --force.  The message ends with the remedy.
void require_replaceable_directory(const std::filesystem::path& path, const Global& global,
                                   std::string_view remedy = "or add --force to replace it");
// Throws UsageError if it is one of the files or directories that are read, which it would replace.
void require_apart(const std::filesystem::path& out, std::span<const std::string> read);
// Throws OutputError if no file can be made in the directory of `file`; pipes and devices need
// none.
void require_writable_directory(const std::filesystem::path& file);

// Throws RunFileError if it is a directory: one that holds nothing finished.  The message says what it holds.
void require_no_directory(const std::filesystem::path& path);

// Throws OutputError if something is there that is no file, and so cannot be replaced by one.
void require_file(const std::filesystem::path& file);
// If it is one.
void remove_file(const std::filesystem::path& file);

// Throws UsageError unless -o names where what is continued, a run or a comparison, stands, and
// nothing asks to replace it.
void require_place_of(std::string_view continued, const Global& global);

// To the file, whole or not at all, or to standard output.
void write_output(const std::filesystem::path& file, std::string_view bytes);

// The directory of a run or comparison, made when this object is and gone again with it if nothing
// was written.  Of two programs at a time, one has it.
class OutputDirectory {
 public:
  // Throws UsageError if the directory may not be replaced, OutputError if nothing can be written
  // there, CommandFailure if another program has it; before anything is computed.
  OutputDirectory(const std::filesystem::path& path, const Global& global);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // outermost first
  std::unique_ptr<DirectoryLock> lock_;
};

}  // namespace wander
