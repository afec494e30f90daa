#include "records/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>
#include <utility>

namespace wander {

namespace fs = std::filesystem;

// Owns an open file; `close` reports what the destructor could not.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : descriptor_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int number() const { return descriptor_; }
  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

namespace {

// Pipes and some file systems cannot sync, which is no failure to write.
bool sync(int descriptor) {
  return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_in_place(const fs::path& path, const FileWriter& write) {
  Descriptor file(path, O_WRONLY);
  if (!file.is_open()) throw OutputError(path.string(), errno);
  write_to_descriptor(file.number(), write, path.string());
  if (!file.close()) throw OutputError(path.string(), errno);
}

// The file a link points to is the one to replace, not the link.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

fs::path directory_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Another program may have taken it for a leftover before it was locked; then it has no name left.
// Where locks are unknown, no leftover is removed.
bool is_locked_in_place(const Descriptor& file) {
  if (flock(file.number(), LOCK_EX) != 0) return true;
  struct stat status {};
  return fstat(file.number(), &status) != 0 || status.st_nlink > 0;
}

constexpr std::string_view temporary_prefix = ".wander-", temporary_suffix = ".tmp";

// Short, so that it is valid wherever the name of the file is.
fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> count = 0;
  return path.parent_path() /
         fmt::format("{}{}-{}{}", temporary_prefix, getpid(), count++, temporary_suffix);
}

}  // namespace

OutputError::OutputError(const std::string& place, int error_number)
    : std::runtime_error(fmt::format("cannot write {}: {}", place,
                                     std::generic_category().message(error_number))) {}

void write_to_descriptor(int descriptor, std::string_view bytes, const std::string& place) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw OutputError(place, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_to_descriptor(int descriptor, const FileWriter& write, const std::string& place) {
  constexpr std::size_t buffer_size = 1 << 20;  // so that calls of the system do not count
  std::string buffer;
  const auto empty = [&] {
    write_to_descriptor(descriptor, buffer, place);
    buffer.clear();
  };
  write([&](std::string_view bytes) {
    if (buffer.size() + bytes.size() > buffer_size) empty();
    if (bytes.size() > buffer_size)
      write_to_descriptor(descriptor, bytes, place);
    else
      buffer += bytes;
  });
  empty();
}

// A file that goes with its owner, unless it is renamed before.
class StagedFile::Temporary {
 public:
  Temporary(const fs::path& path, const std::string& place) : path_(path), place_(place) {
    do {
      file_ = std::make_unique<Descriptor>(path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
      if (!file_->is_open()) throw OutputError(place_, errno);
    } while (!is_locked_in_place(*file_));
  }
  ~Temporary() {
    if (!path_.empty()) unlink(path_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void write(const FileWriter& write) {
    write_to_descriptor(file_->number(), write, place_);
    if (!sync(file_->number())) throw OutputError(place_, errno);
  }
  void rename_to(const fs::path& path) {
    if (rename(path_.c_str(), path.c_str()) != 0) throw OutputError(path.string(), errno);
    path_.clear();
    if (!file_->close()) throw OutputError(path.string(), errno);
  }

 private:
  fs::path path_;
  std::unique_ptr<Descriptor> file_;
  std::string place_;
};

StagedFile::StagedFile(const fs::path& path, std::string_view bytes)
    : StagedFile(path, [bytes](const ByteSink& file) { file(bytes); }) {}

StagedFile::StagedFile(const fs::path& path, const FileWriter& write) : path_(behind_links(path)) {
  std::error_code unreachable;  // then opening the file says why
  if (fs::is_directory(path_, unreachable)) throw OutputError(path.string(), EISDIR);
  if (is_special(path_)) {
    write_in_place(path_, write);
    return;
  }
  remove_leftovers(directory_of(path_));
  temporary_ = std::make_unique<Temporary>(temporary_beside(path_), path.string());
  temporary_->write(write);
}

StagedFile::StagedFile(StagedFile&& other) noexcept = default;
StagedFile::~StagedFile() = default;

void StagedFile::take_name() {
  if (temporary_) temporary_->rename_to(path_);
}

// The new name itself must reach the disk, too.
void StagedFile::sync_name() const {
  if (!temporary_) return;
  const Descriptor directory(directory_of(path_), O_RDONLY | O_DIRECTORY);
  if (directory.is_open() && !sync(directory.number())) throw OutputError(path_.string(), errno);
}

void StagedFile::commit() { commit_together({this, 1}); }

void StagedFile::commit_together(std::span<StagedFile> files) {
  for (StagedFile& file : files) file.take_name();
  for (const StagedFile& file : files) file.sync_name();
  for (StagedFile& file : files) file.temporary_.reset();
}

TemporaryFolder::TemporaryFolder(const fs::path& beside) {
  remove_leftovers(directory_of(beside));
  do {
    path_ = temporary_beside(beside);
    if (mkdir(path_.c_str(), 0777) != 0 && errno != EEXIST)
      throw OutputError(beside.string(), errno);
    lock_ = std::make_unique<Descriptor>(path_, O_RDONLY | O_DIRECTORY);
  } while (lock_->is_open() && !is_locked_in_place(*lock_));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

DirectoryLock::DirectoryLock(const fs::path& directory)
    : directory_(std::make_unique<Descriptor>(directory, O_RDONLY | O_DIRECTORY)),
      is_held_(!directory_->is_open() || flock(directory_->number(), LOCK_EX | LOCK_NB) == 0 ||
               errno != EWOULDBLOCK) {}

DirectoryLock::~DirectoryLock() = default;

bool is_temporary(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(temporary_prefix) && name.ends_with(temporary_suffix);
}

void remove_leftovers(const fs::path& directory) {
  std::error_code unreadable;  // then there is nothing to be done about it
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, unreadable)) {
    if (!is_temporary(entry.path())) continue;
    const Descriptor file(entry.path(), O_RDONLY | O_NOFOLLOW);
    if (file.is_open() && flock(file.number(), LOCK_EX | LOCK_NB) == 0)
      fs::remove_all(entry.path(), unreadable);
  }
}

void write_file(const fs::path& path, std::string_view bytes) { StagedFile(path, bytes).commit(); }

void write_file(const fs::path& path, const FileWriter& write) { StagedFile(path, write).commit(); }

}  // namespace wander
