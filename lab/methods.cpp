#include "lab/methods.h"

#include <array>

#include "lab/failure.h"
#include "lab/world_methods.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 8> names{"pt",     "lt",   "bdpt",     "mlt",
                                                "pssmlt", "mmlt", "pt-naive", "lt-naive"};

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
  require_precision(dials.precision, description);
  Session begun = session;
  begun.begun = session.clock->now();
  Rendering rendering = dials.precision == Precision::of_float
                            ? WorldMethods<FlatlandSingle>(description, dials, begun).render(method)
                            : WorldMethods<Flatland>(description, dials, begun).render(method);
  rendering.precision = name_of(dials.precision);
  return rendering;
}

}  // namespace wander
