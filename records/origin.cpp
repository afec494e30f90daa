#include "records/origin.h"

#include <fmt/chrono.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>

namespace wander {

extern const char* const build_commit;  // the build writes it (records/commit.cmake)

namespace {

// Machines that name no model have at least an architecture.
std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  utsname machine{};
  return uname(&machine) == 0 ? machine.machine : "unknown";
}

std::string or_unknown(std::string text) { return text.empty() ? "unknown" : text; }

}  // namespace

Origin origin_here() {
  return {.commit = build_commit,
          .compiler = WANDER_COMPILER,
          .build_type = or_unknown(WANDER_BUILD_TYPE),
          .cpu = or_unknown(cpu_model()),
          .date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

}  // namespace wander
