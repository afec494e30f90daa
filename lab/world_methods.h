// The methods of `render` in one world, each as a run: light transport is written for any
// precision, and each precision is made in a file of its own (world_methods_float.cpp,
// world_methods_double.cpp).
#pragma once

#include <algorithm>

#include "lab/dials.h"
#include "lab/estimate.h"
#include "lab/methods.h"
#include "lab/render.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/kelemen.h"
#include "scenes/format/build_scene.h"

namespace wander {

template <World W>
class WorldMethods {
 public:
  // A run that is made goes on as long as these methods and `execution` are there.
  WorldMethods(const description::Scene& description, const Dials& dials, const Run& execution)
      : description_(description),
        dials_(dials),
        execution_(execution),
        scene_(build_flatland<W>(description)),
        space_(*scene_, Roulette::off) {}

  std::unique_ptr<LiveRun> make(std::string_view method) const {
    for (const Estimator& estimator : estimators())
      if (method == estimator.name) return make_estimate(*scene_, estimator, execution_);
    if (method == "pssmlt") return primary<PssmltGroup>("pssmlt");
    if (method == "mmlt") return primary<MmltGroup>("mmlt");
    const Family family = make_family(dials_.family(), requires_of(description_));
    return std::make_unique<ChainRun<Space, PathGroup<Space, Family>>>("mlt", space_, family,
                                                                       execution_, settings());
  }

  // What there is to say against the film of a run that has come to its end.
  void doubt(Rendering& rendering) const {
    for (const Estimator& estimator : estimators()) {
      if (rendering.method != estimator.name) continue;
      warn_if_dark(rendering);
      warn_if_blind(rendering);
    }
  }

 private:
  using Space = Transport<W>;

  ChainSettings settings() const { return fitted(dials_.chains, execution_.session().budget); }

  template <template <class S, class SmallStep, class Estimator> class Chains>
  std::unique_ptr<LiveRun> primary(const char* method) const {
    const PrimaryKernel<Kelemen> kernel{Kelemen{}.scaled(dials_.kernel), dials_.large_step};
    const auto with = [&]<class Estimator>(Estimator) -> std::unique_ptr<LiveRun> {
      using Group = Chains<Space, Kelemen, Estimator>;
      return std::make_unique<ChainRun<Space, Group>>(method, space_, kernel, execution_,
                                                      settings());
    };
    const StepEstimator estimator =
        dials_.estimator == StepEstimator::usual ? usual_estimator(method) : dials_.estimator;
    return estimator == StepEstimator::kelemen ? with(KelemenWeights{}) : with(ExpectedValues{});
  }

  static void warn_if_dark(Rendering& rendering) {
    const auto& value = rendering.film.value;
    if (std::ranges::any_of(value, [](double v) { return v > 0; })) return;
    rendering.warnings.push_back(
        "no light path was found, so the film is zero; look for walls without a gap, a light or "
        "sensor that faces away, or a max_vertices that is too small");
  }

  void warn_if_blind(Rendering& rendering) const {
    if (sees_all_light(rendering.method, description_)) return;
    rendering.warnings.push_back(
        "light tracing cannot find paths that reach the camera from a mirror or from smooth "
        "glass, so their light is missing from this film; use pt, bdpt or mlt");
  }

  const description::Scene& description_;
  const Dials& dials_;
  const Run& execution_;
  std::unique_ptr<const Scene<W>> scene_;
  Space space_;
};

extern template class WorldMethods<FlatlandSingle>;
extern template class WorldMethods<Flatland>;

}  // namespace wander
