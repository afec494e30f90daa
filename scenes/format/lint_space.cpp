#include "scenes/format/lint_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scenes/format/lint_bounds.h"
#include "scenes/format/measured_face.h"
#include "scenes/format/overlaps.h"

namespace wander {

namespace {

// What of a shape is looked at.
struct Measured {
  Extent extent;
  std::size_t faces = 0, flattened = 0;                      // flattened ones have no area
  double feature = std::numeric_limits<double>::infinity();  // of the last face

  void operator()(const Face& face) {
    extent.include(extent_of(face));
    ++faces;
    const Sheet* sheet = std::get_if<Sheet>(&face);
    if (sheet != nullptr && !sheet->has_area())
      ++flattened;
    else
      feature = sheet != nullptr ? sheet->shortest_side() : std::get<Ball>(face).radius;
  }
};

// Of a surface of many faces none is looked at alone.
Measured measured(const description::ShapeKind& kind) {
  Measured shape;
  for_each_face(kind, [&](const Face& face) { shape(face); });
  if (shape.faces != 1) shape.feature = std::numeric_limits<double>::infinity();
  return shape;
}

class LintOfSpace {
 public:
  explicit LintOfSpace(const description::Scene& scene) : scene_(scene) {
    Extent all;
    for (const description::Shape& shape : scene.shapes) {
      measured_.push_back(measured(shape.kind));
      all.include(measured_.back().extent);
    }
    diameter_ = all.diameter();
    remoteness_ = all.remoteness();
  }

  Lint found() && {
    doubt_extent();
    for (std::size_t i = 0; i < measured_.size(); ++i) doubt_shape(i);
    find_overlaps();
    return std::move(found_);
  }

 private:
  void note(std::vector<Fault>& list, std::size_t shape, std::string what) {
    if (list.size() >= most_findings) return;
    const description::Shape& place = scene_.shapes[shape];
    list.push_back({place.line, place.column, fmt::format("/shapes/{}", shape), std::move(what)});
  }

  void doubt_extent() {
    if (remoteness_ > most_remote)
      note(found_.warnings, 0,
           fmt::format("the scene lies {:.1e} of its diameters from the origin, which costs as "
                       "many digits; move it nearer to (0, 0, 0)",
                       remoteness_));
  }

  void doubt_shape(std::size_t i) {
    const Measured& shape = measured_[i];
    if (shape.feature < smallest_feature * diameter_)
      note(found_.warnings, i,
           fmt::format("this shape is {:.1e} times smaller than the scene, too small for exact "
                       "results; ratios up to 1e12 are safe",
                       diameter_ / shape.feature));
    if (shape.flattened == shape.faces && scene_.shapes[i].light)
      note(found_.faults, i, "this light has no area, so it shines on nothing: give it some");
    else if (shape.flattened > 0)
      note(found_.warnings, i,
           fmt::format("{} of the triangles of this mesh {} no area, and light never meets {}; "
                       "leave them out of the file",
                       shape.flattened, shape.flattened == 1 ? "has" : "have",
                       shape.flattened == 1 ? "it" : "them"));
  }

  void find_overlaps() {
    const Overlaps overlaps = overlaps_of(scene_, rounding_of_points(diameter_, remoteness_));
    for (const auto& [shape, other] : overlaps.of_roles)
      note(found_.faults, shape,
           light_or_sensor_lies_on(scene_.shapes[shape].light.has_value(), other));
    for (const auto& [shape, other] : overlaps.of_passive)
      note(
          found_.warnings, shape,
          shape == other
              ? std::string("triangles of this mesh lie on each other, and each method meets "
                            "another of them: leave out what is there twice, such as the back of a "
                            "sheet, and split faces that are not convex into triangles")
              : fmt::format("this shape lies on /shapes/{}; where light reaches both, each "
                            "method meets another of them: move one a small distance off",
                            other));
  }

  const description::Scene& scene_;
  std::vector<Measured> measured_;
  double diameter_ = 0, remoteness_ = 0;
  Lint found_;
};

}  // namespace

Lint lint_space(const description::Scene& scene) { return LintOfSpace(scene).found(); }

}  // namespace wander
