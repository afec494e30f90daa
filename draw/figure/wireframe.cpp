#include "draw/figure/wireframe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <tuple>

#include "draw/figure/clip.h"
#include "draw/figure/style.h"
#include "records/scene_curves.h"

namespace wander::figure {
namespace {

constexpr std::array kinds{WireKind::surface, WireKind::glass, WireKind::sensor, WireKind::light};
constexpr std::size_t most_lines = 20'000;  // of a kind
constexpr double bend = 0.88;               // cosine between normals: beyond it, an edge is drawn
constexpr int rim_sides = 64;

// Faces meet where their corners are the same to the last bit.
using Key = std::tuple<double, double, double>;
Key key_of(const Place& p) { return {p.x, p.y, p.z}; }

struct Edge {
  Place from, to;
  std::vector<Place> normals{};  // of the faces that share it
  WireKind kind{};
};

class Edges {
 public:
  explicit Edges(const Place& eye) : eye_(eye) {}

  void add(const Place& from, const Place& to, const Place& normal, WireKind kind) {
    const std::pair<Key, Key> ends = std::minmax({key_of(from), key_of(to)});
    Edge& edge = edges_.try_emplace(ends, Edge{from, to}).first->second;
    edge.normals.push_back(normal);
    edge.kind = std::max(edge.kind, kind);
  }
  void add_drawn(std::vector<WireLine>& lines) const {
    for (const auto& [ends, edge] : edges_)
      if (is_drawn(edge)) lines.push_back({edge.from, edge.to, edge.kind});
  }

 private:
  bool is_drawn(const Edge& edge) const {
    if (edge.normals.size() != 2) return true;
    const Place &a = edge.normals[0], &b = edge.normals[1];
    const Place view = edge.from - eye_;
    return glm::dot(a, b) < bend || glm::dot(a, view) * glm::dot(b, view) < 0;
  }

  Place eye_;
  std::map<std::pair<Key, Key>, Edge> edges_{};
};

// As the eye sees it.
void add_rim(const Place& centre, double radius, const Place& eye, WireKind kind,
             std::vector<WireLine>& lines) {
  const Place to_eye = eye - centre;
  const double distance = glm::length(to_eye);
  if (!(distance > radius)) return;
  const Place axis = to_eye / distance;
  const Place beside = std::abs(axis.y) < 0.9 ? Place{0, 1, 0} : Place{1, 0, 0};
  const Place u = glm::normalize(glm::cross(axis, beside)), v = glm::cross(axis, u);
  const double along = radius * radius / distance;
  const double across = std::sqrt(radius * radius - along * along);
  const auto spot = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / rim_sides;
    return centre + along * axis + across * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int k = 0; k < rim_sides; ++k) lines.push_back({spot(k), spot(k + 1), kind});
}

WireKind kind_of(const SceneFaces& faces, std::size_t face) {
  if (faces.radiance[face] > 0) return WireKind::light;
  if (faces.is_sensor[face] != 0) return WireKind::sensor;
  const auto material = static_cast<std::size_t>(std::max(faces.material[face], 0));
  const bool is_glass = material < material_types.size() &&
                        material_types[material].find("dielectric") != std::string::npos;
  return is_glass ? WireKind::glass : WireKind::surface;
}

void thin(std::vector<WireLine>& lines) {
  if (lines.size() <= most_lines) return;
  const std::size_t step = (lines.size() + most_lines - 1) / most_lines;
  std::vector<WireLine> few;
  for (std::size_t k = 0; k < lines.size(); k += step) few.push_back(lines[k]);
  lines = std::move(few);
}

std::string_view colour_of(WireKind kind) {
  switch (kind) {
    case WireKind::surface:
      return style::neutral.colour;
    case WireKind::glass:
      return style::glass_mark;
    case WireKind::light:
      return style::light;
    case WireKind::sensor:
      return style::sensor;
  }
  return style::ink;
}

}  // namespace

std::vector<WireLine> wireframe(const SceneFaces& faces, const Place& eye) {
  Edges edges(eye);
  std::vector<WireLine> all;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const WireKind kind = kind_of(faces, f);
    const auto corner = [&](std::size_t k) {
      const double* c = &faces.corners[9 * f + 3 * k];
      return Place{c[0], c[1], c[2]};
    };
    const Place a = corner(0), b = corner(1), c = corner(2);
    if (faces.kinds[static_cast<std::size_t>(faces.kind[f])] == "sphere") {
      add_rim(a, faces.radius[f], eye, kind, all);
      continue;
    }
    const Place cross = glm::cross(b - a, c - a);
    const double size = glm::length(cross);
    const Place normal = size > 0 ? cross / size : cross;
    const bool is_triangle = faces.kinds[static_cast<std::size_t>(faces.kind[f])] == "triangle";
    const std::vector<Place> corners =
        is_triangle ? std::vector{a, b, c} : std::vector{a, b, b + c - a, c};
    for (std::size_t k = 0; k < corners.size(); ++k)
      edges.add(corners[k], corners[(k + 1) % corners.size()], normal, kind);
  }
  edges.add_drawn(all);
  std::vector<WireLine> lines;
  for (const WireKind kind : kinds) {
    std::vector<WireLine> of_kind;
    std::ranges::copy_if(all, std::back_inserter(of_kind),
                         [&](const WireLine& line) { return line.kind == kind; });
    thin(of_kind);
    lines.insert(lines.end(), of_kind.begin(), of_kind.end());
  }
  return lines;
}

void draw_wire(Svg& svg, WireKind kind, std::string_view data) {
  const bool stands_out = kind == WireKind::light || kind == WireKind::sensor;
  svg.path(data, {{"stroke", colour_of(kind)},
                  {"stroke-width", stands_out ? 1.2 : 0.5},
                  {"stroke-linecap", "round"},
                  {"fill", "none"}});
}

void draw_wireframe(Svg& svg, const std::vector<WireLine>& lines, const View& view,
                    const PageMap& map) {
  const Vector one = map(view.extent().low), other = map(view.extent().high);
  const Window window{{std::min(one.x, other.x), std::min(one.y, other.y)},
                      {std::max(one.x, other.x), std::max(one.y, other.y)}};
  const auto scope = svg.group("wireframe");
  for (const WireKind kind : kinds) {
    std::string data;
    for (const WireLine& line : lines)
      if (line.kind == kind)
        if (const auto piece = view.line(line.from, line.to))
          data += clipped({map(piece->from), map(piece->to)}, window);
    if (!data.empty()) draw_wire(svg, kind, data);
  }
}

}  // namespace wander::figure
