#include "tools/output_place.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "draw/report/comparison_files.h"
#include "lab/checkpoint.h"
#include "lab/compare/kept_comparison.h"
#include "lab/failure.h"
#include "records/run_files.h"
#include "tools/console.h"

namespace wander {

namespace fs = std::filesystem;

namespace {

fs::path directory_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// What a directory holds, in the words of a message.
const char* contents_of(const fs::path& directory) {
  if (holds_run(directory)) return "a run";
  if (std::error_code error; fs::exists(checkpoint_in(directory), error))
    return "a run that did not come to its end";
  if (compare::holds_comparison(directory)) return "a comparison";
  if (compare::holds_kept_comparison(directory)) return "a comparison that did not come to its end";
  return "files that this program did not make";
}

// What a program that was killed has left behind does not count.
bool holds_nothing(const fs::path& directory, std::error_code& error) {
  return std::ranges::all_of(
      fs::directory_iterator(directory, error), [&](const fs::directory_entry& entry) {
        return is_temporary(entry) || (entry.path() == compare::kept_in(directory) &&
                                       entry.is_directory() && holds_nothing(entry, error));
      });
}

void require_empty(const fs::path& directory, const Global& global, std::string_view remedy) {
  std::error_code error;
  const bool empty = holds_nothing(directory, error);
  if (error) throw OutputError(directory.string(), error.value());
  if (empty || global.force) return;
  throw UsageError(fmt::format("{} holds {}; choose another place, {}", directory.string(),
                               contents_of(directory), remedy));
}

// The directories that must be made so that `path` exists, outermost first.
std::vector<fs::path> missing_directories(fs::path path) {
  std::vector<fs::path> missing;
  std::error_code error;
  while (!path.empty() && !fs::exists(path, error)) {
    missing.insert(missing.begin(), path);
    path = path.parent_path();
  }
  return missing;
}

// "run/" names the same directory as "run".
fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

bool is_standard_output(const fs::path& path) { return path == "-"; }

void require_replaceable(const fs::path& file, const Global& global) {
  if (is_standard_output(file)) {
    if (global.json)
      throw UsageError(
          "-o - and --json both write to standard output; name a file, or leave out --json");
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) throw OutputError(file.string(), EISDIR);
  if (!fs::is_regular_file(status) || global.force) return;
  throw UsageError(fmt::format("{} exists; add --force to replace it", file.string()));
}

void require_apart(const fs::path& out, std::span<const std::string> read) {
  std::error_code error;
  for (const std::string& one : read)
    if (fs::equivalent(out, one, error))
      throw UsageError(fmt::format(
          "-o {} is one of those that are read, and would be replaced; choose another place",
          out.string()));
}

void require_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw OutputError(file.string(), EISDIR);
}

void remove_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_regular_file(file, error)) fs::remove(file, error);
}

void require_no_directory(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return;
  const std::string name = path.string();
  if (fs::exists(checkpoint_in(path), error))
    throw RunFileError(
        fmt::format("{} holds a run that did not come to its end; `wander render --continue -o {}` "
                    "carries it on",
                    name, name));
  if (compare::holds_kept_comparison(path))
    throw RunFileError(
        fmt::format("{} holds a comparison that did not come to its end; `wander compare "
                    "--continue -o {}` carries it on",
                    name, name));
  throw RunFileError(name + ": a directory without a run.json or a compare.json");
}

void require_replaceable_directory(const fs::path& path, const Global& global,
                                   std::string_view remedy) {
  if (is_standard_output(path))
    throw UsageError(
        "-o - is standard output, and this output is a directory of files; --json prints its "
        "document there");
  std::error_code error;
  const fs::path directory = without_trailing_slash(path);
  const fs::file_status status = fs::status(directory, error);
  if (fs::is_directory(status)) {
    require_empty(directory, global, remedy);
  } else if (fs::exists(status)) {
    throw OutputError(directory.string(), ENOTDIR);
  }
}

void require_place_of(std::string_view continued, const Global& global) {
  if (global.out.empty())
    throw UsageError(fmt::format(
        "--continue needs -o DIR, the directory of the {} that is to go on", continued));
  if (global.force)
    throw UsageError(
        fmt::format("--continue carries the {} in DIR on, and --force replaces it: leave one of "
                    "them out",
                    continued));
}

void write_output(const fs::path& file, std::string_view bytes) {
  if (is_standard_output(file))
    print_data(bytes);
  else
    write_file(file, bytes);
}

void require_writable_directory(const fs::path& file) {
  const fs::path directory = directory_of(file);
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  if (fs::exists(directory, ignored) && !fs::is_directory(directory, ignored))
    throw OutputError(file.string(), ENOTDIR);
  if (access(directory.c_str(), W_OK | X_OK) != 0) throw OutputError(file.string(), errno);
}

OutputDirectory::OutputDirectory(const fs::path& path, const Global& global)
    : path_(without_trailing_slash(path)) {
  require_replaceable_directory(path_, global);
  for (const fs::path& directory : missing_directories(path_)) {
    if (mkdir(directory.c_str(), 0777) != 0 && errno != EEXIST) {
      const int reason = errno;
      for (auto made = made_.rbegin(); made != made_.rend(); ++made) rmdir(made->c_str());
      throw OutputError(directory.string(), reason);
    }
    made_.push_back(directory);
  }
  if (access(path_.c_str(), W_OK | X_OK) != 0) throw OutputError(path_.string(), errno);
  lock_ = std::make_unique<DirectoryLock>(path_);
  if (!lock_->is_held())
    throw CommandFailure(
        ExitCode::failure,
        fmt::format("another program is writing into {}; wait for its end, or choose another place",
                    path_.string()));
  remove_leftovers(path_);
  require_replaceable_directory(path_, global);  // another may have come to its end since
}

OutputDirectory::~OutputDirectory() {
  // Only what is still empty goes.
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) rmdir(made->c_str());
}

}  // namespace wander
