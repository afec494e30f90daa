// What is to be computed, resolved once: a scene, a method, its dials, and the world in which light
// is transported.  Everything that computes takes a Job, and asks no further.
#pragma once

#include <string>
#include <vector>

#include "core/description.h"
#include "lab/dials.h"
#include "lab/method.h"
#include "mutations/family_settings.h"

namespace wander {

// Of which kind a world is.
struct WorldKind {
  int dimension;
  Precision precision;
  int channels = 1;  // of colour
  bool operator==(const WorldKind&) const = default;
};

// That a scene asks for.
WorldKind world_of(const description::Scene& scene, const Dials& dials);

// All that speaks against it, each in a sentence; none if it can be computed.
std::vector<std::string> why_unfit(const description::Scene& scene, const Method& method,
                                   const Dials& dials);

class Job {
 public:
  // Dials that the method does not have are of no effect.  Throws UsageError where the method
  // cannot render the scene, or the precision cannot hold it.
  Job(const description::Scene& scene, const Method& method, const Dials& dials = {});

  // Its longest paths are those of the dial, where it was turned.
  const description::Scene& scene() const { return scene_; }
  const Method& method() const { return *method_; }
  const Dials& dials() const { return dials_; }
  WorldKind world() const { return world_of(scene_, dials_); }

  // How the mutations in path space act; with small moves that go so many times as far.
  FamilySettings family() const { return dials_.family(); }
  FamilySettings family(double kernel) const;
  // What the steps deposit.
  StepEstimator estimator() const;

  // The same with another method.
  Job by(const Method& method) const { return {scene_, method, dials_}; }
  // The same scene, with all dials as usual.
  Job usual(const Method& method) const { return {scene_, method}; }

 private:
  description::Scene scene_;
  const Method* method_;
  Dials dials_;
};

}  // namespace wander
