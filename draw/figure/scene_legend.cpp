#include "draw/figure/scene_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "draw/figure/marks.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

// "0.5", or "0.2–0.8" where materials of one kind differ; empty where there is none.
class Spread {
 public:
  void include(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  void include(const description::Quantity& quantity) {
    for (const double channel : quantity.channels) include(channel);
  }
  std::string after(std::string_view prefix, std::string_view suffix = "") const {
    if (low_ > high_) return "";
    const std::string low = number_text(low_), high = number_text(high_);
    return fmt::format("{}{}{}", prefix, low == high ? low : low + "–" + high, suffix);
  }

 private:
  double low_ = INFINITY, high_ = -INFINITY;
};

// The parameters of all materials of one kind.
struct Parameters {
  Spread reflectance, roughness, index, extinction;

  void operator()(const description::Black&) {}
  void operator()(const description::Diffuse& m) { reflectance.include(m.reflectance); }
  void operator()(const description::Mirror& m) { reflectance.include(m.reflectance); }
  void operator()(const description::Dielectric& m) {
    index.include(m.interior_index / m.exterior_index);
  }
  void operator()(const description::RoughConductor& m) {
    reflectance.include(m.reflectance);
    roughness.include(m.roughness);
  }
  void operator()(const description::RoughDielectric& m) {
    roughness.include(m.roughness);
    index.include(m.interior_index / m.exterior_index);
  }
  void operator()(const description::Conductor& m) {
    index.include(m.eta);
    extinction.include(m.k);
  }
  void operator()(const description::RoughMetal& m) {
    roughness.include(m.roughness);
    index.include(m.eta);
    extinction.include(m.k);
  }
  std::string text() const {
    return roughness.after(", α ") + index.after(", n ") + extinction.after(", k ") +
           reflectance.after(", ρ ");
  }
};

std::string_view name_of(Surface surface) {
  switch (surface) {
    case Surface::black:
      return "black";
    case Surface::diffuse:
      return "diffuse";
    case Surface::mirror:
      return "mirror";
    case Surface::dielectric:
      return "dielectric";
    case Surface::rough_conductor:
      return "rough conductor";
    case Surface::rough_dielectric:
      return "rough dielectric";
  }
  return "";
}

std::string bins(const std::vector<int>& resolution) {
  const int count = resolution.empty() ? 0 : resolution.front();
  return fmt::format("{} bin{} from the dot", count, count == 1 ? "" : "s");
}

// Samples are pieces of a scene drawn one point to the metre.
PageMap swatch_map(Vector left) { return {{0, 0}, left, 1}; }

LegendEntry entry(Surface surface, std::string text) {
  const auto draw = [surface](Svg& svg, Vector left) {
    const PageMap map = swatch_map(left);
    const double y = is_transparent(surface) ? 3 : 0;
    const Line line{{0, y}, {swatch_width, y}};
    if (is_transparent(surface)) draw_inside_ribbon(svg, surface, outline(line, map, -3.25), 6.5);
    draw_surface(svg, surface, outline(line, map, 0));
  };
  return {draw, std::move(text)};
}

LegendEntry entry(Role role, std::string text) {
  const auto draw = [role](Svg& svg, Vector left) {
    const std::array<Curve, 1> curve{Line{{0, -2}, {swatch_width, -2}}};
    draw_role(svg, role, curve, swatch_map(left), Offset::none);
  };
  return {draw, std::move(text)};
}

LegendEntry camera_entry(std::string text) {
  const auto draw = [](Svg& svg, Vector left) {
    draw_camera(svg, {{4, 0}, {14, 4}, {14, -4}}, swatch_map(left));
  };
  return {draw, std::move(text)};
}

void add_emitters(const description::Scene& scene, std::vector<LegendEntry>& entries) {
  Spread radiance;
  for (const description::Shape& shape : scene.shapes)
    if (shape.light) radiance.include(shape.light->radiance);
  if (const std::string text = radiance.after("light, ", " W/(m·rad)"); !text.empty())
    entries.push_back(entry(Role::light, text));
  for (const description::Shape& shape : scene.shapes)
    if (shape.sensor)
      entries.push_back(entry(Role::sensor, "sensor, " + bins(shape.sensor->resolution)));
  if (scene.camera) entries.push_back(camera_entry("camera, " + bins(scene.camera->resolution)));
}

void add_surface(const description::Scene& scene, Surface surface,
                 std::vector<LegendEntry>& entries) {
  Parameters parameters;
  bool occurs = false;
  for (const description::Shape& shape : scene.shapes) {
    if (surface_of(scene, shape) != surface) continue;
    occurs = true;
    if (shape.material) std::visit(parameters, scene.materials[*shape.material].kind);
  }
  if (occurs) entries.push_back(entry(surface, std::string(name_of(surface)) + parameters.text()));
}

}  // namespace

std::vector<LegendEntry> legend_of(const description::Scene& scene) {
  std::vector<LegendEntry> entries;
  add_emitters(scene, entries);
  // Long texts first: they share the first column.
  for (const Surface surface :
       {Surface::rough_conductor, Surface::rough_dielectric, Surface::diffuse, Surface::mirror,
        Surface::dielectric, Surface::black})
    add_surface(scene, surface, entries);
  return entries;
}

}  // namespace wander::figure
