// The methods of `render` in one world: light transport is written for any precision, and each
// precision is made in a file of its own (world_methods_float.cpp, world_methods_double.cpp).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "lab/estimate.h"
#include "lab/render.h"
#include "lab/worlds.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/kelemen.h"
#include "scenes/format/build_scene.h"

namespace wander {

template <World W>
class WorldMethods {
 public:
  WorldMethods(const Job& job, const Session& session)
      : job_(job), session_(session), scene_(build_flatland<W>(job.scene())) {}

  Rendering render() const {
    switch (const Method& method = job_.method(); method.id) {
      case MethodId::pt:
      case MethodId::lt:
      case MethodId::bdpt:
      case MethodId::pt_naive:
      case MethodId::lt_naive:
        return estimated(estimator_of(method));
      case MethodId::mlt:
        return in_path_space();
      case MethodId::pssmlt:
        return in_primary_space<PssmltGroup>();
      case MethodId::mmlt:
        return in_primary_space<MmltGroup>();
    }
    throw std::logic_error("a method that is not of the table");
  }

 private:
  using Space = Transport<W>;

  Rendering estimated(const Estimator& estimator) const {
    Rendering rendering = estimate(*scene_, estimator, session_);
    warn_if_dark(rendering);
    warn_if_blind(rendering);
    return rendering;
  }

  Rendering in_path_space() const {
    const Space space(*scene_, Roulette::off);
    return ChainRenderer(space, job_.family(), session_, job_.dials().chains)
        .render(job_.method().name.data());
  }

  template <template <class S, class SmallStep, class Estimator> class Chains>
  Rendering in_primary_space() const {
    const Space space(*scene_, Roulette::off);
    const Dials& dials = job_.dials();
    const PrimaryKernel<Kelemen> kernel{Kelemen{}.scaled(dials.kernel), dials.large_step};
    const auto with = [&]<class Estimator>(Estimator) {
      using Group = Chains<Space, Kelemen, Estimator>;
      return ChainRenderer<Space, Group>(space, kernel, session_, dials.chains)
          .render(job_.method().name.data());
    };
    return job_.estimator() == StepEstimator::kelemen ? with(KelemenWeights{})
                                                      : with(ExpectedValues{});
  }

  static void warn_if_dark(Rendering& rendering) {
    const auto& value = rendering.film.value;
    if (std::ranges::any_of(value, [](double v) { return v > 0; })) return;
    rendering.warnings.push_back(
        fmt::format("no light path was found, so the film is zero; {}", where_light_is_lost));
  }

  void warn_if_blind(Rendering& rendering) const {
    const std::string_view why = job_.method().why_blind(job_.scene());
    if (why.empty()) return;
    const auto better = methods_that([&](const Method& method) {
      return method.check != CheckRole::none && method.sees_all_light(job_.scene());
    });
    rendering.warnings.push_back(
        fmt::format("{} {}, so their light is missing from this film; use {}", job_.method().name,
                    why, in_words(better, "or")));
  }

  const Job& job_;
  const Session& session_;
  std::unique_ptr<const Scene<W>> scene_;
};

template <World W>
Rendering render_in(const Job& job, const Session& session) {
  return WorldMethods<W>(job, session).render();
}

}  // namespace wander
