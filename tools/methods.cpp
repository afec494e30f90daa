#include "tools/methods.h"

#include <algorithm>
#include <array>

#include "core/build_scene.h"
#include "core/estimate.h"
#include "mlt/mmlt_group.h"
#include "mlt/pssmlt_group.h"
#include "mlt/render.h"
#include "mutations/kelemen.h"
#include "tools/failure.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 8> names{"pt",     "lt",   "bdpt",     "mlt",
                                                "pssmlt", "mmlt", "pt-naive", "lt-naive"};

void warn_if_dark(Rendering& rendering) {
  const auto& value = rendering.film.value;
  if (std::ranges::any_of(value, [](double v) { return v > 0; })) return;
  rendering.warnings.push_back(
      "no light path was found, so the film is zero; look for walls without a gap, a light or "
      "sensor that faces away, or a max_vertices that is too small");
}

void warn_if_blind(Rendering& rendering, const description::Scene& scene) {
  if (sees_all_light(rendering.method, scene)) return;
  rendering.warnings.push_back(
      "light tracing cannot find paths that reach the camera from a mirror or from smooth glass, "
      "so their light is missing from this film; use pt, bdpt or mlt");
}

using Flat = Transport<Flatland>;

template <template <class Space, class SmallStep, class Estimator> class Chains>
Rendering render_primary(const Flat& space, const Session& session, const char* method,
                         StepEstimator estimator) {
  const PrimaryKernel<Kelemen> kernel{Kelemen{}, default_large_step};
  const auto with = [&]<class Estimator>(Estimator) {
    using Group = Chains<Flat, Kelemen, Estimator>;
    return ChainRenderer<Flat, Group>(space, kernel, session, ChainSettings{}).render(method);
  };
  return estimator == StepEstimator::kelemen ? with(KelemenWeights{}) : with(ExpectedValues{});
}

}  // namespace

std::span<const std::string_view> method_names() { return names; }

void require_possible(std::string_view method, const description::Scene& scene) {
  if (method == "lt-naive" && scene.camera)
    throw UsageError(
        "lt-naive cannot see through a camera: its light paths must hit the sensor by chance, and "
        "no path hits a pinhole, nor a lens, which is no surface of the scene; use lt, or a sensor "
        "shape");
}

bool sees_all_light(std::string_view method, const description::Scene& scene) {
  return method != "lt" || !scene.camera || !requires_of(scene).specular;
}

Rendering render(const description::Scene& described, std::string_view method, const Dials& dials,
                 const Session& session) {
  description::Scene description = described;
  description.max_vertices = dials.max_vertices.value_or(described.max_vertices);
  const auto scene = build_flatland(description);
  for (const Estimator& estimator : estimators()) {
    if (method != estimator.name) continue;
    Rendering rendering = estimate(*scene, estimator, session);
    warn_if_dark(rendering);
    warn_if_blind(rendering, description);
    return rendering;
  }
  const Flat transport(*scene, Roulette::off);
  if (method == "pssmlt")
    return render_primary<PssmltGroup>(
        transport, session, "pssmlt",
        dials.estimator == StepEstimator::usual ? StepEstimator::kelemen : dials.estimator);
  if (method == "mmlt")
    return render_primary<MmltGroup>(transport, session, "mmlt", dials.estimator);
  const Family family = make_family(dials.mutations, requires_of(description));
  return ChainRenderer(transport, family, session, ChainSettings{}).render("mlt");
}

}  // namespace wander
