#include "records/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "records/pending_names.h"
#include "records/temporary_file.h"

namespace wander {

namespace fs = std::filesystem;

namespace {

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
  temporary_ = std::make_unique<TemporaryFile>(temporary_beside(path_), path.string());
  write_to_descriptor(temporary_->number(), write, path.string());
  temporary_->sync_bytes();
}

StagedFile::StagedFile(StagedFile&& other) noexcept = default;
StagedFile::~StagedFile() = default;

void StagedFile::take_name() {
  temporary_->rename_to(path_);
  temporary_->close();
}

void StagedFile::commit() { commit_together({this, 1}); }

void StagedFile::commit_together(std::span<StagedFile> files) {
  std::vector<StagedFile*> unnamed;
  std::vector<PendingNames::Renaming> renamings;
  for (StagedFile& file : files)
    if (file.temporary_) {
      unnamed.push_back(&file);
      renamings.push_back({file.temporary_->path(), file.path_});
    }
  PendingNames pending(renamings);
  bool has_begun = false;
  try {
    for (StagedFile* file : unnamed) {
      file->take_name();
      has_begun = true;
    }
    for (const StagedFile* file : unnamed) sync_names(directory_of(file->path_), file->path_);
  } catch (const OutputError&) {
    if (has_begun && pending.keep())
      for (StagedFile* file : unnamed) file->temporary_->keep();
    throw;
  }
  for (StagedFile* file : unnamed) file->temporary_.reset();
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

void remove_leftovers(const fs::path& directory) {
  // Of an output with folders in it, the list stands in its own.
  const bool is_at_rest = give_pending_names(directory / "..") && give_pending_names(directory);
  if (!is_at_rest) return;
  std::error_code unreadable;  // then there is nothing to be done about it
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, unreadable)) {
    if (!is_temporary(entry.path())) continue;
    const Descriptor file(entry.path(), O_RDONLY | O_NOFOLLOW);
    if (file.is_open() && is_left_over(file)) fs::remove_all(entry.path(), unreadable);
  }
}

void write_file(const fs::path& path, std::string_view bytes) { StagedFile(path, bytes).commit(); }

void write_file(const fs::path& path, const FileWriter& write) { StagedFile(path, write).commit(); }

}  // namespace wander
