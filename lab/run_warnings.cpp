#include "lab/run_warnings.h"

#include <fmt/format.h>

#include "lab/load_warning.h"

namespace wander {

void add_warnings(Rendering& rendering, const Session& session, const SceneDocument& document,
                  const std::string& source) {
  std::vector<std::string> all = scene_warnings(document, source);
  all.insert(all.end(), rendering.warnings.begin(), rendering.warnings.end());
  if (is_of_wall_time(session.budget))
    if (std::string load =
            load_warning(rendering.seconds, rendering.processor_seconds, rendering.threads);
        !load.empty())
      all.push_back(std::move(load));
  if (rendering.threads < session.threads)
    all.push_back(fmt::format("only {} of the {} threads could be started", rendering.threads,
                              session.threads));
  rendering.warnings = std::move(all);
}

}  // namespace wander
