// Files of one output appear together.  Before the first of them takes its name, a list of who is to
// become what is written beside them, and it goes when the last has done so.  A program that is stopped in between
// leaves the list, and whoever reads or writes there next gives the names that lack: a write-ahead log.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

namespace wander {

class TemporaryFile;

class PendingNames {
 public:
  struct Renaming {
    std::filesystem::path from, to;
  };
  // The list stands in the folder of the last file.  None is made for less than two files, nor where one
  // lies outside that folder.  Throws OutputError.
  explicit PendingNames(std::span<const Renaming> renamings);
  ~PendingNames();
  PendingNames(const PendingNames&) = delete;
  PendingNames& operator=(const PendingNames&) = delete;

  // Leaves the list to who comes next; false if there is none.
  bool keep();

 private:
  std::filesystem::path list_;
  std::unique_ptr<TemporaryFile> file_;  // locked as long as this object is
};

// Ends the list in this folder, if there is one and no program works on it.  Is none left?
// A list may come with somebody else's folder: it moves nothing but temporary files, to names
// beside them in the folder or below it.
bool give_pending_names(const std::filesystem::path& directory);

}  // namespace wander
