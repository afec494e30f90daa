// Says which of the parts of a check is being made, and ends it when it is interrupted.
#pragma once

#include <string>
#include <vector>

#include "work/parallel.h"
#include "work/session.h"

namespace wander {

class CheckParts {
 public:
  // In the order in which they are made.
  CheckParts(const Session& session, const Run& run, std::vector<std::string> names);

  // Of one of them; throws CommandFailure if the run was interrupted.
  void done(std::uint64_t samples);

 private:
  void say() const;

  const Session& session_;
  const Run& run_;
  std::vector<std::string> names_;
  std::size_t done_ = 0;
  std::uint64_t samples_ = 0;
};

}  // namespace wander
