// What Python asks to be run, in the words of the command line: one language for dials, and one set
// of messages.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "lab/checkpoint.h"
#include "lab/job.h"
#include "python/binding/scene.h"

namespace wander::python {

struct RunRequest {
  BoundScene scene;
  std::string method;
  std::map<std::string, std::string> dials;  // those that are turned: word, value
  std::uint64_t seed = 1;
  std::string command_line;  // that makes the same

  // Throws UsageError with all that speaks against it.
  void require_sound() const;
  Job job() const;
  Checkpoint checkpoint(const std::string& budget) const;
};

}  // namespace wander::python
