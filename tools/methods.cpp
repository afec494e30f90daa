#include "tools/methods.h"

#include <algorithm>
#include <array>

#include "core/build_scene.h"
#include "core/estimate.h"
#include "mlt/render.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 6> names{"pt", "lt", "bdpt", "mlt", "pt-naive", "lt-naive"};

void warn_if_dark(Rendering& rendering) {
  const auto& value = rendering.film.value;
  if (std::ranges::any_of(value, [](double v) { return v > 0; })) return;
  rendering.warnings.push_back(
      "no light path was found, so the film is zero; look for walls without a gap, a light or "
      "sensor that faces away, or a max_vertices that is too small");
}

// Light tracing reaches a camera by connections alone.
void warn_if_blind(Rendering& rendering, const Scene<Flatland>& scene) {
  if (rendering.method != "lt" || !scene.camera() || !scene.has_specular()) return;
  rendering.warnings.push_back(
      "light tracing cannot find paths that reach the camera from a mirror or from smooth glass, "
      "so "
      "their light is missing from this film; use pt, bdpt or mlt");
}

}  // namespace

std::span<const std::string_view> method_names() { return names; }

Rendering render(const description::Scene& description, std::string_view method,
                 const MutationWeights& weights, const Session& session) {
  const auto scene = build_flatland(description);
  for (const Estimator& estimator : estimators()) {
    if (method != estimator.name) continue;
    Rendering rendering = estimate(*scene, estimator, session);
    warn_if_dark(rendering);
    warn_if_blind(rendering, *scene);
    return rendering;
  }
  const Transport<Flatland> transport(*scene, Roulette::off);
  const Family family =
      make_family(weights.empty() ? choose_mutations(requires_of(description)).weights : weights,
                  scene->max_vertices());
  return ChainRenderer(transport, family, session, ChainSettings{}).render("mlt");
}

}  // namespace wander
