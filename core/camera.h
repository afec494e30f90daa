// A perspective camera: an emitter of importance that no light path can hit.
//
// A film coordinate in [0,1)^(D-1) is a point of a flat film at distance 1.  With |film| the
// measure of that film and θ the angle to the axis, film points are uniform, so directions have the
// density
//   p(ω) = 1 / (|film| cos^(D+1) θ)     with respect to projected angle,
// and We = p(x) p(ω): the camera measures mean radiance.  A pinhole's position carries a formal δ
// in We and in p(x) alike.  A thin lens keeps the film's image at `focus_distance` sharp.
#pragma once

#include <limits>
#include <optional>

#include "core/ray.h"

namespace wander {

template <World W>
struct Camera {
  using Real = typename W::Real;
  using Length = typename W::Length;
  using Point = typename W::Point;
  using Direction = typename W::Direction;
  using Square = typename W::Square;

  Point position;
  Direction axis;
  std::array<Direction, W::dimension - 1> across;  // unit vectors of growing film coordinates
  std::array<Length, W::dimension - 1> extent;     // of the film at distance 1, along `across`
  Length lens_radius = 0;                          // 0, or too small: a pinhole
  Length focus_distance = 1;

  // So is a lens whose density of area is beyond numbers, and what is multiplied with it.
  bool is_pinhole() const { return !(lens_measure() > 0x1p40 * std::numeric_limits<Real>::min()); }

  Point sample_lens(Square u) const {
    if (is_pinhole()) return position;
    const Square p = W::Dimension::ball_sample(u);
    Point lens = position;
    for (std::size_t k = 0; k < across.size(); ++k) lens += lens_radius * Length(p[k]) * across[k];
    return lens;
  }
  Square invert_lens(Point lens) const {
    Square p{};
    for (std::size_t k = 0; k < across.size(); ++k)
      p[k] = static_cast<Real>(glm::dot(lens - position, across[k]) / lens_radius);
    Square u = W::Dimension::ball_invert(p);
    for (Real& number : u) number = into_unit<Real>(number);
    return u;
  }
  Real lens_density() const { return is_pinhole() ? 1 : static_cast<Real>(1 / lens_measure()); }

  Direction sample_direction(Point lens, Square film) const {
    Direction focus = axis;
    for (std::size_t k = 0; k < across.size(); ++k)
      focus += extent[k] * (Length(film[k]) - Length(0.5)) * across[k];
    return glm::normalize(focus - off_center(lens));
  }
  // Where a ray that arrives at the lens against `direction` meets the film, if it does.
  std::optional<Square> film_coordinate(Point lens, Direction direction) const {
    const Length cosine = glm::dot(direction, axis);
    if (!(cosine > 0)) return {};
    const Direction focus = off_center(lens) + direction / cosine;
    Square film{};
    for (std::size_t k = 0; k < across.size(); ++k) {
      const Length u = glm::dot(focus, across[k]) / extent[k] + Length(0.5);
      if (!(u >= 0 && u < 1)) return {};
      film[k] = unit_number<Real>(u);
    }
    return film;
  }
  // p(ω) of the table above; 0 outside the film.
  Real direction_density(Point lens, Direction direction) const {
    if (!film_coordinate(lens, direction)) return 0;
    Length film = 1;
    for (const Length e : extent) film *= e;
    return static_cast<Real>(1 /
                             (film * W::Dimension::film_spread(Length(glm::dot(direction, axis)))));
  }

 private:
  Length lens_measure() const {
    Length measure = W::Dimension::template ball_measure<Length>;
    for (std::size_t k = 0; k < across.size(); ++k) measure *= lens_radius;
    return measure;
  }
  // As seen from the image of the film, which is at distance 1 then: of a pinhole nothing, wherever it is.
  Direction off_center(Point lens) const { return (lens - position) / focus_distance; }
};

}  // namespace wander
