#include "python/binding/run_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lab/failure.h"

namespace wander::python {

namespace {

Dials turned(const std::map<std::string, std::string>& texts, const Method& method) {
  Dials values;
  for (const auto& [word, text] : texts) {
    const Dial& dial = find_dial(word);
    require_dial(dial, method);
    dial.set(values, text);
  }
  return values;
}

}  // namespace

void RunRequest::require_sound() const {
  const Method& known = find_method(method);
  const auto reasons = why_unfit(scene.document.scene, known, turned(dials, known));
  if (!reasons.empty()) throw UsageError(fmt::format("{}", fmt::join(reasons, "\n")));
}

Job RunRequest::job() const {
  const Method& known = find_method(method);
  return {scene.document.scene, known, turned(dials, known)};
}

Checkpoint RunRequest::checkpoint(const std::string& budget) const {
  return {.scene = kept_scene(scene.document, scene.source),
          .method = method,
          .budget = budget,
          .dials = dials,
          .seed = seed,
          .run = {}};
}

}  // namespace wander::python
