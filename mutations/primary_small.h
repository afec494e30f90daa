// The small step in primary sample space, on a path: choose one of the techniques that could have
// made it by its MIS weight, find the random numbers, move each a little, and map back with the
// same technique [Kelemen et al. 2002; inverse maps: Bitterli et al. 2018, Otsu et al. 2017].
//
//   T(x→y) = w_s(x) K(u→v) p_s(y),  so  a = min(1, [f w_s / p_s](y) / [f w_s / p_s](x)).
// Numbers that a path does not fix (a lobe within its Fresnel interval, the direction at a mirror)
// are auxiliary, and are drawn anew at every inversion.  A number that chooses is moved where both x
// and y have a choice, and drawn where y alone has: either way back it is the same.  Measure: area
// product.
#pragma once

#include "core/transport.h"
#include "mlt/join.h"
#include "mlt/mutation.h"
#include "mlt/traits.h"
#include "mutations/kelemen.h"
#include "mutations/primary.h"

namespace wander {

struct PrimarySmall {
  static constexpr std::string_view name = "primary_small";
  Kelemen kernel{};

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = x.size(), s = random.choose(x.weights());
    y.resize(n);
    Scaled moves = 1;  // K(u→v) = K(v→u)
    if (!walk(space, x, y, Toward::sensor, s, moves, random) ||
        !walk(space, x, y, Toward::light, n - s, moves, random))
      return Failure{Reason::missed_scene};
    Reason flaw = join(space, y, s);
    if (flaw == Reason::none) flaw = evaluate(space, y, 0, n - 1);
    if (flaw != Reason::none) return Failure{flaw};
    weigh(space, y);
    const auto label = static_cast<std::size_t>(s);
    return Proposal{Scaled(x.weights()[label]) * moves * technique_density(y, s),
                    Scaled(y.weights()[label]) * moves * technique_density(x, s)};
  }

 private:
  // Perturbs the subpath of `count` vertices at one end of x into y, and multiplies the density of
  // its moves into `moves`.  False: y's walk ended too soon.
  template <class Space, class Random>
  bool walk(const Space& space, const Path<typename Space::Universe>& x,
            Path<typename Space::Universe>& y, Toward toward, int count, Scaled& moves,
            Random& random) const {
    if (count == 0) return true;
    const bool from_light = toward == Toward::sensor;
    const int end = from_light ? 0 : x.size() - 1, step = from_light ? 1 : -1;
    auto point = space.invert_begin(x, end, random);
    double density = 1;
    if (space.chooses_light(x[end])) density *= move(point.light, random);
    if (!space.is_pinhole(x[end]))
      for (auto& u : point.position) density *= move(u, random);
    moves *= density;
    if (from_light)
      space.begin_light(y, end, point);
    else
      space.begin_sensor(y, end, point);
    for (int k = 0, i = end; k + 1 < count; ++k, i += step) {
      auto numbers = space.invert_extend(x, i, toward, random);
      density = 1;
      for (auto& u : numbers.direction) density *= move(u, random);
      if (space.chooses_lobe(x[i]))
        density *= move(numbers.lobe, random);
      else if (space.chooses_lobe(y[i]))
        numbers.lobe = unit_number<typename Space::Universe::Real>(random.uniform());
      moves *= density;
      if (!space.extend(y, i, toward, numbers)) return false;
    }
    return true;
  }

  template <class Real, class Random>
  double move(Real& u, Random& random) const {
    const auto [moved, density] = kernel.move(static_cast<double>(u), random);
    u = unit_number<Real>(moved);
    return density;
  }
};

inline constexpr std::array<Parameter<PrimarySmall>, 1> primary_small_parameters{
    {{"step", "how far a random number moves, of [0,1)", 0.5,
      [](const PrimarySmall& m) -> Ends {
        return {m.kernel.smallest, m.kernel.largest};
      },
      [](PrimarySmall& m, Ends e) {
        m.kernel = {e.smallest, e.largest};
      }}}};

template <>
inline constexpr Traits<PrimarySmall> traits<PrimarySmall>{
    .word = primary_word,
    .auto_weight = primary_auto_weight,
    .share = [](double large_step) { return 1 - large_step; },
    .scaled = [](const PrimarySmall& m,
                 double factor) { return PrimarySmall{m.kernel.scaled(factor)}; },
    .parameters = primary_small_parameters};

}  // namespace wander
