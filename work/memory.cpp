#include "work/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

namespace wander {

namespace {

namespace fs = std::filesystem;

// The number after a word at the beginning of a line; none if there is no such line.
std::optional<double> number_after(const fs::path& path, const std::string& word) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(word)) continue;
    std::istringstream rest(line.substr(word.size()));
    if (double number = 0; rest >> number) return number;
  }
  return std::nullopt;
}

void lower(AvailableMemory& least, std::optional<double> bytes, const char* word) {
  if (bytes && *bytes < least.bytes) least = {std::max(0.0, *bytes), word};
}

// What is left in one control group; pages of files are given back when they are needed.
std::optional<double> left_in(const fs::path& group, const char* limit, const char* usage) {
  const auto most = number_after(group / limit, "");
  const auto used = number_after(group / usage, "");
  if (!most || !used) return std::nullopt;
  const double files = number_after(group / "memory.stat", "inactive_file ").value_or(0);
  return *most - *used + files;
}

// A group is bound by the limits of all that it lies in.
void lower_by_groups(AvailableMemory& least, const fs::path& root) {
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_second_version = controllers.empty();
    if (!is_second_version && controllers.find("memory") == std::string::npos) continue;
    const fs::path top = root / (is_second_version ? "sys/fs/cgroup" : "sys/fs/cgroup/memory");
    const auto lower_by = [&](const fs::path& group) {
      lower(least,
            is_second_version ? left_in(group, "memory.max", "memory.current")
                              : left_in(group, "memory.limit_in_bytes", "memory.usage_in_bytes"),
            "the control group");
    };
    lower_by(top);
    fs::path group = top;
    for (const fs::path& part : fs::path(line.substr(second + 1)).relative_path())
      lower_by(group /= part);
  }
}

std::optional<double> left_of_addresses(const fs::path& root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const double pages = number_after(root / "proc/self/statm", "").value_or(0);
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

AvailableMemory available_memory(const fs::path& root) {
  AvailableMemory least{std::numeric_limits<double>::infinity(), "nothing"};
  if (const auto kibibytes = number_after(root / "proc/meminfo", "MemAvailable:"))
    lower(least, 1024 * *kibibytes, "the machine");
  lower_by_groups(least, root);
  lower(least, left_of_addresses(root), "the limit of addresses (ulimit -v)");
  return least;
}

}  // namespace wander
