// Files that appear whole or not at all: the bytes go to a temporary file in the same directory,
// every write is checked, the file is synced and then renamed into place.  A failure removes the
// temporary file and leaves what was there before as it was.  Only a program that is killed leaves
// one behind; it is locked while it is in use, so that a leftover can be told, and goes when the
// next file of that directory is written.  Files that belong together appear together.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wander {

class Descriptor;
class TemporaryFile;

// what() = "cannot write PATH: No space left on device"
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& place, int error_number);
};

// Takes the next bytes of a file.
using ByteSink = std::function<void(std::string_view)>;
// Gives all bytes of a file, piece by piece: what is large need not be held as a whole.
using FileWriter = std::function<void(const ByteSink&)>;

// A file that is on the disk, complete and synced, but does not yet bear its name.  Stage all files
// of one output before the first is committed: a full disk is then found while nothing has changed.
class StagedFile {
 public:
  StagedFile(const std::filesystem::path& path, std::string_view bytes);
  StagedFile(const std::filesystem::path& path, const FileWriter& write);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  void commit();
  // All or none: where the program is stopped between two names, or one cannot be given, the others
  // follow when the directory is next looked at (pending_names.h).
  static void commit_together(std::span<StagedFile> files);

 private:
  void take_name();
  std::filesystem::path path_;
  std::unique_ptr<TemporaryFile> temporary_;  // none: nothing is left to do
};

// A pipe or device (`/dev/stdout`) is written in place, for it must not be replaced by a file.
void write_file(const std::filesystem::path& path, std::string_view bytes);
void write_file(const std::filesystem::path& path, const FileWriter& write);

// A folder beside a file that is to be, gone again with this object; a leftover goes as files do.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& beside);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<Descriptor> lock_;
};

// No other program has the lock of a directory while this object is.  Where locks are unknown,
// every one gets it.
class DirectoryLock {
 public:
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  bool is_held() const { return is_held_; }

 private:
  std::unique_ptr<Descriptor> directory_;
  bool is_held_;
};

// Does this name belong to a temporary file or folder?
bool is_temporary(const std::filesystem::path& path);
// Ends what a program that was stopped has left in a directory: files of an output that lack their names
// get them, and the temporary files and folders that no program is writing any more go.
void remove_leftovers(const std::filesystem::path& directory);

// Writes all bytes to an open descriptor; `place` is named in the error.
void write_to_descriptor(int descriptor, std::string_view bytes, const std::string& place);
void write_to_descriptor(int descriptor, const FileWriter& write, const std::string& place);

}  // namespace wander
