#include "records/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <utility>

#include "records/atomic_file.h"

namespace wander {

namespace fs = std::filesystem;

Descriptor::Descriptor(const fs::path& path, int flags)
    : descriptor_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {}

Descriptor::~Descriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool Descriptor::close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

bool sync(int descriptor) {
  return fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

void sync_names(const fs::path& directory, const fs::path& place) {
  const Descriptor opened(directory, O_RDONLY | O_DIRECTORY);
  if (opened.is_open() && !sync(opened.number())) throw OutputError(place.string(), errno);
}

namespace {

bool has_a_name(const Descriptor& file) {
  struct stat status {};
  return fstat(file.number(), &status) != 0 || status.st_nlink > 0;
}

}  // namespace

bool is_locked_in_place(const Descriptor& file) {
  return flock(file.number(), LOCK_EX) != 0 || has_a_name(file);
}

bool is_left_over(const Descriptor& file) {
  return flock(file.number(), LOCK_EX | LOCK_NB) == 0 && has_a_name(file);
}

fs::path directory_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

namespace {

constexpr std::string_view prefix = ".wander-", suffix = ".tmp";

}  // namespace

fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> count = 0;
  return path.parent_path() / fmt::format("{}{}-{}{}", prefix, getpid(), count++, suffix);
}

bool is_temporary(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(prefix) && name.ends_with(suffix);
}

TemporaryFile::TemporaryFile(const fs::path& path, const std::string& place)
    : path_(path), place_(place) {
  do {
    file_ = std::make_unique<Descriptor>(path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (!file_->is_open()) throw OutputError(place_, errno);
  } while (!is_locked_in_place(*file_));
}

TemporaryFile::~TemporaryFile() {
  if (is_ours_) unlink(path_.c_str());
}

void TemporaryFile::sync_bytes() const {
  if (!sync(file_->number())) throw OutputError(place_, errno);
}

void TemporaryFile::rename_to(const fs::path& path) {
  if (rename(path_.c_str(), path.c_str()) != 0) throw OutputError(path.string(), errno);
  keep();
}

void TemporaryFile::close() {
  if (!file_->close()) throw OutputError(place_, errno);
}

}  // namespace wander
