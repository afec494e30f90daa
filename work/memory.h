// How much memory a run may still take.
#pragma once

#include <filesystem>
#include <string>

namespace wander {

struct AvailableMemory {
  double bytes;      // infinite where nothing is known
  std::string word;  // what sets the limit, such as "the machine"
};

// The least of what the machine has free, what is left of the limits of the control groups that the
// process is in, and what is left of its own limit of addresses (ulimit -v).  Of what is read, /proc
// and /sys are below `root`.
AvailableMemory available_memory(const std::filesystem::path& root = "/");

}  // namespace wander
