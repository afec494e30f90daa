#include "tools/examined_job.h"

#include "lab/failure.h"

namespace wander {

std::optional<Job> examined_job(const description::Scene& scene, const Method& method,
                                const Dials& dials, Examination& examination) {
  const std::vector<std::string> reasons = why_unfit(scene, method, dials);
  for (const std::string& why : reasons) examination.part([&] { throw UsageError(why); });
  if (!reasons.empty()) return std::nullopt;
  return Job(scene, method, dials);
}

}  // namespace wander
