// A stretch of a path moved a little [Veach and Guibas 1997, 5.3.2; Veach 1997, 11.4]: what the
// lens, caustic and multi-chain perturbations have in common.
//
// The stretch begins at a vertex `first`, goes toward the sensor or the light, and ends at `last`.
//   at an end of the path   the point moves on its surface by d, and the direction turns
//   at a surface that scatters  the point stays, or is where the walk arrives; the direction turns
//   at a specular surface   the same event is followed, with probability one
// A direction turns by an angle θ, or for a camera by a distance d on its film.  The last vertex is
// connected to the kept one behind it, unless it is itself an end of the path, which must be hit.
//
//   T(x→y) = p(d)/ring(d) end_density(y) Π_turned p(θ_i)/cone(θ_i) aim_density_i(y)
//            Π_specular follow_density_i(y)
// The kernels are symmetric in x and y and have a fixed range, so every move can be undone; what is
// left of dω/dA in the ratio is the cosine at each turned direction.  Measure: area product.
#pragma once

#include <array>
#include <numbers>

#include "core/transport.h"
#include "mlt/join.h"
#include "mlt/mutation.h"
#include "mlt/traits.h"
#include "mutations/log_uniform.h"

namespace wander {

// How far a perturbation goes.
struct PerturbationRange {
  LogUniform position{1e-4, 0.5};  // as a share of the film, or of the light's extent
  LogUniform angle{1e-5, 0.1};     // radians

  // So many times as far; across the film is the farthest, and half a turn.
  PerturbationRange scaled(double factor) const {
    return {position.scaled(factor, 1), angle.scaled(factor, std::numbers::pi)};
  }
};

// Of a mutation with such a range.
template <class M>
inline constexpr std::array<Parameter<M>, 2> perturbation_parameters{{
    {"position", "how far an end moves, as a share of the film or of the light's extent", 1,
     [](const M& m) -> Ends {
       return {m.range.position.smallest, m.range.position.largest};
     },
     [](M& m, Ends e) {
       m.range.position = {e.smallest, e.largest};
     }},
    {"angle", "how far a direction turns, in radians", std::numbers::pi,
     [](const M& m) -> Ends {
       return {m.range.angle.smallest, m.range.angle.largest};
     },
     [](M& m, Ends e) {
       m.range.angle = {e.smallest, e.largest};
     }},
}};

struct Stretch {
  Toward toward;
  int first, last;
  int step() const { return toward == Toward::sensor ? 1 : -1; }
};

// Proposes y, which differs from x in the stretch alone, for one space and one range.
template <class Space>
class Perturbation {
 public:
  using W = typename Space::Universe;

  Perturbation(const Space& space, const PerturbationRange& range, const Path<W>& x, Path<W>& y,
               Stretch stretch)
      : space_(space), range_(range), x_(x), y_(y), stretch_(stretch) {}

  template <class Random>
  Proposed propose(Random& random) {
    y_.resize(x_.size());
    y_.copy(x_, 0, x_.size(), 0);
    Reason flaw = walk(random);
    if (flaw == Reason::none) flaw = close();
    if (flaw != Reason::none) return Failure{flaw};
    const auto [low, high] = std::minmax({stretch_.first, stretch_.last + stretch_.step()});
    flaw = evaluate(space_, y_, std::max(low, 0), std::min(high, x_.size() - 1));
    if (flaw != Reason::none) return Failure{flaw};
    return Proposal{kernels_ * density(y_), kernels_ * density(x_)};
  }

 private:
  bool is_end(int i) const { return i == 0 || i == x_.size() - 1; }

  template <class Random>
  Reason walk(Random& random) {
    const int first = stretch_.first;
    if (is_end(first) && !space_.is_pinhole(x_[first])) {
      const Reason flaw = move_end(random);
      if (flaw != Reason::none) return flaw;
    }
    for (int i = first; i != stretch_.last; i += stretch_.step()) {
      const bool specular = is_specular(x_[i].event);
      if (i != first && specular != is_specular(y_[i].event)) return Reason::changed_class;
      const Reason flaw = specular ? follow(i) : turn(i, random);
      if (flaw != Reason::none) return flaw;
    }
    return Reason::none;
  }

  // Adds an offset to coordinates of the unit square; false: it leads outside.
  template <class Random>
  bool offset(typename W::Square& u, Random& random) {
    using Real = typename W::Real;
    const auto [distance, density] = range_.position.draw(random);
    const double around = random.uniform();
    const auto d = static_cast<Real>(distance);
    kernels_ *= density / double(W::Dimension::ring_measure(d));
    const auto step = W::Dimension::ring_offset(d, static_cast<Real>(around));
    for (std::size_t k = 0; k < u.size(); ++k) {
      u[k] += step[k];
      if (!(u[k] >= 0 && u[k] < 1)) return false;
    }
    return true;
  }

  template <class Random>
  Reason move_end(Random& random) {
    auto u = space_.end_parameter(x_, stretch_.first);
    if (!offset(u, random)) return Reason::outside_range;
    space_.move_end(y_, stretch_.first, u);
    return Reason::none;
  }

  Reason follow(int i) {
    return space_.follow(y_, i, stretch_.toward, x_[i].event) ? Reason::none : Reason::missed_scene;
  }

  template <class Random>
  Reason turn(int i, Random& random) {
    using Length = typename W::Length;
    if (space_.is_camera(x_[i])) {
      auto film = space_.film_position(x_);
      if (!offset(film, random)) return Reason::outside_range;
      return space_.aim_film(y_, i, film) ? Reason::none : Reason::missed_scene;
    }
    const auto [angle, density] = range_.angle.draw(random);
    const double around = random.uniform();
    const auto theta = static_cast<Length>(angle);
    kernels_ *= density / double(W::Dimension::cone_measure(theta));
    const auto axis = space_.direction(x_, i, stretch_.toward);
    const auto turned =
        glm::normalize(W::Dimension::cone_direction(axis, theta, static_cast<Length>(around)));
    return space_.shoot(y_, i, stretch_.toward, turned) ? Reason::none : Reason::missed_scene;
  }

  // The last new vertex: an end that was hit, or connected to what is kept.
  Reason close() {
    Vertex<W>& last = y_[stretch_.last];
    if (stretch_.last == 0)
      return space_.is_light(last) ? become(last, Event::emission) : Reason::changed_class;
    if (stretch_.last == x_.size() - 1)
      return space_.is_sensor(last) ? become(last, Event::detection) : Reason::changed_class;
    if (!space_.can_connect(last)) return Reason::changed_class;
    const int lower = std::min(stretch_.last, stretch_.last + stretch_.step());
    return space_.connect(y_, lower) == Connection::open ? Reason::none : Reason::occluded;
  }
  static Reason become(Vertex<W>& v, Event event) {
    v.event = event;
    return Reason::none;
  }

  // T without the kernels, which are the same both ways.
  Scaled density(const Path<W>& z) const {
    const int first = stretch_.first;
    Scaled p = is_end(first) && !space_.is_pinhole(z[first]) ? space_.end_density(z, first) : 1;
    for (int i = first; i != stretch_.last; i += stretch_.step())
      p *= is_specular(z[i].event) ? space_.follow_density(z, i, stretch_.toward)
                                   : space_.aim_density(z, i, stretch_.toward);
    return p;
  }

  const Space& space_;
  const PerturbationRange& range_;
  const Path<W>& x_;
  Path<W>& y_;
  Stretch stretch_;
  Scaled kernels_ = 1;  // K(x→y) = K(y→x)
};

// The first vertex after x_i, going toward an end, that is not specular.
template <class W>
int next_not_specular(const Path<W>& x, int i, Toward toward) {
  const int step = toward == Toward::sensor ? 1 : -1;
  do i += step;
  while (is_specular(x[i].event));
  return i;
}

}  // namespace wander
