// Files of the system below atomic_file.h: open descriptors, locks by which a leftover is told from what
// is in use, and files that go with their owner.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace wander {

// Owns an open file; `close` reports what the destructor could not.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags);
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int number() const { return descriptor_; }
  bool close();

 private:
  int descriptor_;
};

// To the disk.  Pipes and some file systems cannot, which is no failure to write.
bool sync(int descriptor);
// The names in a directory, too, must reach the disk.  Throws OutputError that names `place`.
void sync_names(const std::filesystem::path& directory, const std::filesystem::path& place);

// Waits for the lock; false if another program has taken the file for a leftover before, so that it has
// no name left.  Where locks are unknown, no leftover is removed.
bool is_locked_in_place(const Descriptor& file);
// Without waiting: false if a program works on it, or it has no name left.
bool is_left_over(const Descriptor& file);

std::filesystem::path directory_of(const std::filesystem::path& file);
// Short, so that it is valid wherever the name of the file is.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

// A file that goes with its owner, unless it is renamed before or kept.  Errors name `place`.
class TemporaryFile {
 public:
  TemporaryFile(const std::filesystem::path& path, const std::string& place);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int number() const { return file_->number(); }
  const std::filesystem::path& path() const { return path_; }
  void sync_bytes() const;
  // It stays open, and locked.
  void rename_to(const std::filesystem::path& path);
  void close();
  // It stays where it is when its owner goes.
  void keep() { is_ours_ = false; }

 private:
  std::filesystem::path path_;
  std::string place_;
  std::unique_ptr<Descriptor> file_;
  bool is_ours_ = true;
};

}  // namespace wander
