// The methods of `render` in one world: light transport is written for any precision, and each
// precision is made in a file of its own (world_methods_float.cpp, world_methods_double.cpp).
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
  WorldMethods(const description::Scene& description, const Dials& dials, const Session& session)
      : description_(description),
        dials_(dials),
        session_(session),
        scene_(build_flatland<W>(description)) {}

  Rendering render(std::string_view method) const {
    for (const Estimator& estimator : estimators())
      if (method == estimator.name) return estimated(estimator);
    const Space space(*scene_, Roulette::off);
    if (method == "pssmlt") return primary<PssmltGroup>(space, "pssmlt");
    if (method == "mmlt") return primary<MmltGroup>(space, "mmlt");
    const Family family = make_family(dials_.family(), requires_of(description_));
    return ChainRenderer(space, family, session_, dials_.chains).render("mlt");
  }

 private:
  using Space = Transport<W>;

  Rendering estimated(const Estimator& estimator) const {
    Rendering rendering = estimate(*scene_, estimator, session_);
    warn_if_dark(rendering);
    warn_if_blind(rendering);
    return rendering;
  }

  template <template <class S, class SmallStep, class Estimator> class Chains>
  Rendering primary(const Space& space, const char* method) const {
    const PrimaryKernel<Kelemen> kernel{Kelemen{}.scaled(dials_.kernel), dials_.large_step};
    const auto with = [&]<class Estimator>(Estimator) {
      using Group = Chains<Space, Kelemen, Estimator>;
      return ChainRenderer<Space, Group>(space, kernel, session_, dials_.chains).render(method);
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
  const Session& session_;
  std::unique_ptr<const Scene<W>> scene_;
};

extern template class WorldMethods<FlatlandSingle>;
extern template class WorldMethods<Flatland>;

}  // namespace wander
