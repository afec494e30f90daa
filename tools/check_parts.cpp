#include "tools/check_parts.h"

#include <algorithm>

#include "lab/failure.h"

namespace wander {

CheckParts::CheckParts(const Session& session, const Run& run, std::vector<std::string> names)
    : session_(session), run_(run), names_(std::move(names)) {
  say();
}

void CheckParts::done(std::uint64_t samples) {
  if (run_.is_interrupted())
    throw CommandFailure(ExitCode::interrupted, "interrupted before the check was complete");
  samples_ += samples;
  ++done_;
  say();
}

void CheckParts::say() const {
  if (!session_.report) return;
  const std::string& name = names_[std::min(done_, names_.size() - 1)];
  session_.report({static_cast<double>(done_) / static_cast<double>(names_.size()), samples_,
                   run_.seconds(), name.c_str()});
}

}  // namespace wander
