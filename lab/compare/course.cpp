#include "lab/compare/course.h"

#include <algorithm>

#include "lab/compare/budgets.h"

namespace wander::compare {

Course::Course(const description::Scene& scene, const Session& common, double effort)
    : scene_(scene), common_(common), effort_(effort), start_(std::chrono::steady_clock::now()) {}

double Course::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

Rendering Course::render(const Job& job, const Budget& budget, std::uint64_t seed,
                         const std::string& what) {
  Session session = common_;
  session.budget = budget;
  session.seed = seed;
  const double before = done_;
  done_ += effort_of(budget);  // whatever comes of it
  if (common_.report)
    session.report = [&](const ProgressReport& run) {
      const double done = before + run.fraction * effort_of(budget);
      fraction_ = std::max(fraction_, std::min(1.0, done / effort_));
      common_.report({fraction_, samples_ + run.samples, seconds(), what.c_str()});
    };
  Rendering rendering = wander::render(job, session);
  samples_ += rendering.samples;
  return rendering;
}

}  // namespace wander::compare
