// The bidirectional mutation [Veach and Guibas 1997, 5.3.1; Veach 1997, 11.4].
//
// Keeps L vertices at the light's end and M at the sensor's, deletes the d between them, samples
// l' + m' = a new ones from the two kept ends and connects.  The label (L, M, a) is part of the
// transition, the split (l', m') is not: the density sums over every split that makes the same
// path,
//   T(x→y) = p_delete(L, M | n) p_add(a | d) Σ_{l'} p_split(l' | a) Π_{i new} from_light_i or
//   from_sensor_i.
// The way back keeps the same ends, deletes a and adds d.  Measure: area product.
#pragma once

#include <algorithm>
#include <array>

#include "core/techniques.h"
#include "mlt/join.h"
#include "mlt/mutation.h"
#include "mlt/traits.h"
#include "mutations/length_pmfs.h"

namespace wander {

struct Bidirectional {
  static constexpr std::string_view name = "bidirectional";
  // Probability that what is deleted lies at the sensor's end.
  static constexpr double sensor_end = 0.5;

  struct Kept {
    int light, sensor;  // L, M
  };

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = x.size();
    const int d = random.choose(length_pmfs.deletion(n).span());
    const Kept kept = choose_kept(n, d, random);
    if (split_count(space, x, kept, d) == 0) return Failure{Reason::not_reversible};

    const int longest = space.max_vertices();
    const int a = random.choose(addition_pmf(kept, d, longest).span());
    const SplitRange splits = split_range(space, x, kept, a);
    if (splits.count() == 0) return Failure{Reason::changed_class};
    const int l = splits.first + random.choose(splits.count());

    const Reason flaw = build(space, x, y, kept, a, l, random);
    if (flaw != Reason::none) return Failure{flaw};
    return Proposal{
        Scaled(delete_probability(n, d, kept) * add_probability(kept, d, a, longest)) *
            added_density(space, y, kept, a),
        Scaled(delete_probability(n - d + a, a, kept) * add_probability(kept, a, d, longest)) *
            added_density(space, x, kept, d)};
  }

  // ---- the discrete choices

  // Where d of n vertices are deleted.  Deleting none needs an edge, with a vertex kept on either
  // side.  Otherwise the sensor's end, where the film is, is as likely as all other places
  // together.
  static double placement_probability(int n, int d, Kept kept) {
    if (d == 0) return 1.0 / (n - 1);
    if (d == n) return 1;
    return kept.sensor == 0 ? sensor_end : (1 - sensor_end) / (n - d);
  }
  template <class Random>
  static Kept choose_kept(int n, int d, Random& random) {
    if (d == n) return {0, 0};
    if (d == 0) {
      const int light = 1 + random.choose(n - 1);
      return {light, n - light};
    }
    const std::array<double, 2> at_end{1 - sensor_end, sensor_end};
    const int light = random.choose(at_end) == 1 ? n - d : random.choose(n - d);
    return {light, n - d - light};
  }

  static const LengthPmf& addition_pmf(Kept kept, int deleted, int longest) {
    const int least = (kept.light == 0 ? 1 : 0) + (kept.sensor == 0 ? 1 : 0);
    return length_pmfs.addition(least, longest - kept.light - kept.sensor, deleted);
  }
  static double delete_probability(int n, int d, Kept kept) {
    return length_pmfs.deletion(n)[d] * placement_probability(n, d, kept);
  }
  static double add_probability(Kept kept, int deleted, int added, int longest) {
    return addition_pmf(kept, deleted, longest)[added];
  }

  // The splits l' = first … last of `added` new vertices that the kept ends allow: an end whose
  // direction is specular must grow before it can be connected.
  struct SplitRange {
    int first, last;
    int count() const { return std::max(0, last - first + 1); }
  };
  template <class Space>
  static SplitRange split_range(const Space& space, const Path<typename Space::Universe>& x,
                                Kept kept, int added) {
    const bool light_may_stay = kept.light == 0 || space.can_connect(x[kept.light - 1]);
    const bool sensor_may_stay =
        kept.sensor == 0 ? space.sensor_can_be_hit() : space.can_connect(x[x.size() - kept.sensor]);
    return {light_may_stay ? 0 : 1, sensor_may_stay ? added : added - 1};
  }
  template <class Space>
  static int split_count(const Space& space, const Path<typename Space::Universe>& x, Kept kept,
                         int added) {
    return split_range(space, x, kept, added).count();
  }

  // ---- the new vertices

  // Σ over splits of p_split Π densities of the vertices between the kept ends of z.
  template <class Space>
  static Scaled added_density(const Space& space, const Path<typename Space::Universe>& z,
                              Kept kept, int added) {
    const SplitRange splits = split_range(space, z, kept, added);
    Scaled sum;
    for (int l = splits.first; l <= splits.last; ++l) {
      const int s = kept.light + l;
      if (!can_sample(space, z, s, all_techniques)) continue;
      Scaled p = 1;
      for (int i = kept.light; i < kept.light + added; ++i)
        p *= double(i < s ? z[i].from_light : z[i].from_sensor);
      sum += p;
    }
    return sum / Scaled(splits.count());
  }

  // Writes y: the kept vertices of x, l new ones from the light's end, a - l from the sensor's; and
  // measures every vertex that has a new neighbour.
  template <class Space, class Random>
  static Reason build(const Space& space, const Path<typename Space::Universe>& x,
                      Path<typename Space::Universe>& y, Kept kept, int a, int l, Random& random) {
    const int n = kept.light + a + kept.sensor, s = kept.light + l;
    y.resize(n);
    y.copy(x, 0, kept.light, 0);
    y.copy(x, x.size() - kept.sensor, kept.sensor, n - kept.sensor);
    if (s > 0 && kept.light == 0) space.begin_light(y, 0, random);
    for (int i = std::max(kept.light, 1); i < s; ++i)
      if (!space.extend(y, i - 1, Toward::sensor, random)) return Reason::missed_scene;
    if (s < n && kept.sensor == 0) space.begin_sensor(y, n - 1, random);
    for (int i = n - 1 - std::max(kept.sensor, 1); i >= s; --i)
      if (!space.extend(y, i + 1, Toward::light, random)) return Reason::missed_scene;
    const Reason flaw = join(space, y, s);
    if (flaw != Reason::none) return flaw;
    return evaluate(space, y, std::max(0, kept.light - 1), std::min(n - 1, kept.light + a));
  }
};

// It is refused more often than the others, and moves less on the film.
template <>
inline constexpr Traits<Bidirectional> traits<Bidirectional>{.auto_weight = 0.5};

}  // namespace wander
