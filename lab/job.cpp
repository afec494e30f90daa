#include "lab/job.h"

#include <fmt/format.h>

#include "lab/engine.h"
#include "lab/failure.h"

namespace wander {

WorldKind world_of(const description::Scene& scene, const Dials& dials) {
  return {scene.dimension, dials.precision, requires_of(scene).colour_channels};
}

std::vector<std::string> why_unfit(const description::Scene& scene, const Method& method,
                                   const Dials& dials) {
  std::vector<std::string> reasons;
  if (const std::string why = why_no_engine(world_of(scene, dials)); !why.empty())
    reasons.push_back(why);
  else if (const std::string why = why_beyond(dials.precision, scene); !why.empty())
    reasons.push_back(fmt::format("--precision {} cannot hold this scene: {}; use double",
                                  name_of(dials.precision), why));
  if (const std::string_view why = method.why_impossible(scene); !why.empty())
    reasons.push_back(fmt::format("{} {}", method.name, why));
  return reasons;
}

Job::Job(const description::Scene& scene, const Method& method, const Dials& dials)
    : scene_(scene), method_(&method), dials_(dials) {
  if (const auto reasons = why_unfit(scene, method, dials); !reasons.empty())
    throw UsageError(reasons.front());
  scene_.max_vertices = dials.max_vertices.value_or(scene.max_vertices);
}

FamilySettings Job::family(double kernel) const {
  FamilySettings settings = dials_.family();
  settings.kernel = kernel;
  return settings;
}

StepEstimator Job::estimator() const {
  return dials_.estimator == StepEstimator::usual ? method_->usual_estimator : dials_.estimator;
}

}  // namespace wander
