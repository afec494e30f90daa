#include "records/pending_names.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "records/atomic_file.h"
#include "records/temporary_file.h"

namespace wander {

namespace fs = std::filesystem;

namespace {

constexpr const char* name_of_list = ".wander-names.tmp";
constexpr std::size_t longest_list = 1 << 20;
constexpr char end_of_path = '\0';  // no path has it in it

fs::path resolved(const fs::path& file) {
  std::error_code unreachable;
  const fs::path directory = fs::weakly_canonical(directory_of(file), unreachable);
  return (unreachable ? directory_of(file) : directory) / file.filename();
}

bool is_below(const fs::path& relative) {
  return !relative.empty() && relative.is_relative() &&
         std::ranges::none_of(relative, [](const fs::path& part) { return part == ".."; });
}

// From, to, from, to, ..., as seen from the folder; none if a file lies outside it.
std::optional<std::string> list_of(std::span<const PendingNames::Renaming> renamings,
                                   const fs::path& directory) {
  std::string list;
  for (const auto& [from, to] : renamings)
    for (const fs::path& path : {from, to}) {
      const fs::path relative = resolved(path).lexically_relative(directory);
      if (!is_below(relative)) return std::nullopt;
      list += relative.string() + end_of_path;
    }
  if (list.size() > longest_list) return std::nullopt;
  return list;
}

bool is_allowed(const PendingNames::Renaming& renaming) {
  return is_below(renaming.from) && is_below(renaming.to) && is_temporary(renaming.from) &&
         !is_temporary(renaming.to) && renaming.from.parent_path() == renaming.to.parent_path();
}

// Empty if this is no list.
std::vector<PendingNames::Renaming> renamings_in(std::string_view list) {
  std::vector<fs::path> paths;
  while (!list.empty()) {
    const std::size_t end = list.find(end_of_path);
    if (end == std::string_view::npos) return {};
    paths.emplace_back(list.substr(0, end));
    list.remove_prefix(end + 1);
  }
  if (paths.size() % 2 != 0) return {};
  std::vector<PendingNames::Renaming> renamings;
  for (std::size_t i = 0; i < paths.size(); i += 2) renamings.push_back({paths[i], paths[i + 1]});
  if (!std::ranges::all_of(renamings, is_allowed)) return {};
  return renamings;
}

std::string contents(const Descriptor& file) {
  std::string text(longest_list + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t got = read(file.number(), text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  text.resize(size);
  return text.size() > longest_list ? std::string() : text;
}

// Those that have their names already are no longer there.
bool give_name(const PendingNames::Renaming& renaming, const fs::path& directory) {
  std::error_code error;
  fs::rename(directory / renaming.from, directory / renaming.to, error);
  return !error || error == std::errc::no_such_file_or_directory;
}

}  // namespace

PendingNames::PendingNames(std::span<const Renaming> renamings) {
  if (renamings.size() < 2) return;
  const fs::path last = resolved(renamings.back().to);
  const fs::path directory = last.parent_path();
  const std::optional<std::string> list = list_of(renamings, directory);
  if (!list) return;
  list_ = directory / name_of_list;
  file_ = std::make_unique<TemporaryFile>(temporary_beside(list_), list_.string());
  write_to_descriptor(file_->number(), *list, list_.string());
  file_->sync_bytes();
  file_->rename_to(list_);
  sync_names(directory, list_);
}

PendingNames::~PendingNames() {
  if (file_) unlink(list_.c_str());
}

bool PendingNames::keep() {
  const bool is_there = file_ != nullptr;
  file_.reset();
  return is_there;
}

bool give_pending_names(const fs::path& directory) {
  const fs::path list = directory / name_of_list;
  const Descriptor file(list, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  if (!file.is_open()) return true;
  if (!is_left_over(file)) return false;
  for (const PendingNames::Renaming& renaming : renamings_in(contents(file)))
    if (!give_name(renaming, directory)) return false;
  sync_names(directory, list);
  unlink(list.c_str());
  return true;
}

}  // namespace wander
