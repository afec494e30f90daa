// Wrong twins of the mutations, which the engines must catch, and of each the right one
// (`Flaw::none`) that must pass: what is caught is the flaw, not the twin.
#pragma once

#include "mlt/chain.h"
#include "mutations/bidirectional.h"
#include "mutations/primary_large.h"
#include "mutations/primary_small.h"

namespace wander::test {

// ---- around any mutation

enum class RatioFlaw {
  none,
  symmetric,  // Metropolis' ratio where Hastings' is needed
  inverted,   // forward and reverse exchanged
  threshold,  // acceptance below 1/2 counts as none
};

template <class M>
struct FlawedRatio {
  static constexpr std::string_view name = M::name;
  M mutation;
  RatioFlaw flaw;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    Proposed proposed = mutation.propose(space, x, y, random);
    Proposal* p = std::get_if<Proposal>(&proposed);
    if (!p) return proposed;
    switch (flaw) {
      case RatioFlaw::none:
        return proposed;
      case RatioFlaw::symmetric:
        return Proposal{1, 1};
      case RatioFlaw::inverted:
        return Proposal{p->reverse, p->forward};
      case RatioFlaw::threshold:
        break;
    }
    const double a = acceptance(x.contribution, p->forward, contribution(y), p->reverse);
    return a < 0.5 ? Proposed(Failure{Reason::metropolis}) : proposed;
  }
};

// ---- the bidirectional mutation

enum class BidirectionalFlaw {
  no_geometry,   // densities of projected angle taken for densities of area
  one_cosine,    // only one of the two cosines of G
  no_deletion,   // the probability of deleting so many vertices left out
  no_addition,   // the probability of adding so many left out
  single_split,  // one split that makes the path, instead of the sum over all
  no_split,      // the probability of a split left out
};

// What was kept is read off the two paths.
template <class W>
Bidirectional::Kept kept_vertices(const Path<W>& x, const Path<W>& y) {
  const int shorter = std::min(x.size(), y.size());
  Bidirectional::Kept kept{0, 0};
  const auto same = [&](int i, int j) { return x[i].place.position == y[j].place.position; };
  while (kept.light < shorter && same(kept.light, kept.light)) ++kept.light;
  while (kept.light + kept.sensor < shorter &&
         same(x.size() - 1 - kept.sensor, y.size() - 1 - kept.sensor))
    ++kept.sensor;
  return kept;
}

struct FlawedBidirectional {
  static constexpr std::string_view name = Bidirectional::name;
  using B = Bidirectional;
  using Kept = B::Kept;
  BidirectionalFlaw flaw;

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    Proposed proposed = B{}.propose(space, x, y, random);
    Proposal* p = std::get_if<Proposal>(&proposed);
    const Kept kept = kept_vertices(x, y);
    const int common = kept.light + kept.sensor, d = x.size() - common, a = y.size() - common;
    if (!p || (d == 0 && a == 0)) return proposed;
    p->forward *= wrong_factor(space, y, kept, x.size(), d, a);
    p->reverse *= wrong_factor(space, x, kept, y.size(), a, d);
    return proposed;
  }

 private:
  // By what the flaw multiplies the density of making z, by adding a vertices to a path of n that
  // has lost d.
  template <class Space>
  Scaled wrong_factor(const Space& space, const Path<typename Space::Universe>& z, Kept kept, int n,
                      int d, int a) const {
    switch (flaw) {
      case BidirectionalFlaw::no_deletion:
        return 1 / length_pmfs.deletion(n)[d];
      case BidirectionalFlaw::no_addition:
        return 1 / B::add_probability(kept, d, a, space.max_vertices());
      case BidirectionalFlaw::no_split:
        return B::split_range(space, z, kept, a).count();
      default:
        return wrong_density(space, z, kept, a) / B::added_density(space, z, kept, a);
    }
  }
  // As Bidirectional::added_density, but for the flaw.
  template <class Space>
  Scaled wrong_density(const Space& space, const Path<typename Space::Universe>& z, Kept kept,
                       int added) const {
    const B::SplitRange splits = B::split_range(space, z, kept, added);
    Scaled sum;
    for (int l = splits.first; l <= splits.last; ++l) {
      const int s = kept.light + l;
      if (!can_sample(space, z, s, all_techniques)) continue;
      Scaled p = 1;
      for (int i = kept.light; i < kept.light + added; ++i) p *= vertex_density(z, i, s);
      if (flaw == BidirectionalFlaw::single_split) return p / Scaled(splits.count());
      sum += p;
    }
    return sum / Scaled(splits.count());
  }
  template <class W>
  double vertex_density(const Path<W>& z, int i, int s) const {
    const double p = i < s ? z[i].from_light : z[i].from_sensor;
    if (flaw == BidirectionalFlaw::single_split) return p;
    if (i == 0 && s > 0) return p;              // sampled as a point of a light
    if (i == z.size() - 1 && s <= i) return p;  // or of the sensor
    const Vertex<W>& edge = z[i < s ? i - 1 : i];
    if (flaw == BidirectionalFlaw::no_geometry) return p / edge.geometry;
    return p / std::abs(glm::dot(edge.place.to_sensor, z[i].place.normal));
  }
};

// ---- the primary steps

// Numbers that leave [0,1) are put at its ends instead of around the circle.
struct ClampedKelemen {
  template <class Random>
  Kelemen::Move move(double u, Random& random) const {
    const Kelemen kernel;
    const Kelemen::Move moved = kernel.move(u, random);
    if (std::abs(moved.u - u) < 0.5) return moved;
    return {moved.u < u ? std::nextafter(1.0, 0.0) : 0.0, moved.density};
  }
};

enum class SmallStepFlaw {
  none,
  no_weights,  // the MIS weights with which the technique is chosen left out
};

template <class Kernel>
struct FlawedSmallStep {
  static constexpr std::string_view name = PrimarySmall::name;
  Kernel kernel;
  SmallStepFlaw flaw;

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = x.size(), s = random.choose(x.weights());
    y.resize(n);
    Scaled moves = 1;
    if (!walk(space, x, y, Toward::sensor, s, moves, random) ||
        !walk(space, x, y, Toward::light, n - s, moves, random))
      return Failure{Reason::missed_scene};
    Reason reason = join(space, y, s);
    if (reason == Reason::none) reason = evaluate(space, y, 0, n - 1);
    if (reason != Reason::none) return Failure{reason};
    weigh(space, y);
    const auto label = static_cast<std::size_t>(s);
    const bool weighted = flaw != SmallStepFlaw::no_weights;
    return Proposal{Scaled(weighted ? x.weights()[label] : 1) * moves * technique_density(y, s),
                    Scaled(weighted ? y.weights()[label] : 1) * moves * technique_density(x, s)};
  }

 private:
  template <class Space, class Random>
  bool walk(const Space& space, const Path<typename Space::Universe>& x,
            Path<typename Space::Universe>& y, Toward toward, int count, Scaled& moves,
            Random& random) const {
    if (count == 0) return true;
    const bool from_light = toward == Toward::sensor;
    const int end = from_light ? 0 : x.size() - 1, step = from_light ? 1 : -1;
    auto point = space.invert_begin(x, end, random);
    if (space.chooses_light(x[end])) moves *= move(point.light, random);
    for (auto& u : point.position) moves *= move(u, random);
    if (from_light)
      space.begin_light(y, end, point);
    else
      space.begin_sensor(y, end, point);
    for (int k = 0, i = end; k + 1 < count; ++k, i += step) {
      auto numbers = space.invert_extend(x, i, toward, random);
      for (auto& u : numbers.direction) moves *= move(u, random);
      if (space.chooses_lobe(x[i]))
        moves *= move(numbers.lobe, random);
      else if (space.chooses_lobe(y[i]))
        numbers.lobe = random.uniform();
      if (!space.extend(y, i, toward, numbers)) return false;
    }
    return true;
  }
  template <class Random>
  double move(double& u, Random& random) const {
    const auto [moved, density] = kernel.move(u, random);
    u = moved;
    return density;
  }
};

// Fresh paths, weighed as if all had the same density.
struct LargeStepWithoutIntensity {
  static constexpr std::string_view name = PrimaryLarge::name;
  PrimaryLarge large;

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    Proposed proposed = large.propose(space, x, y, random);
    if (Proposal* p = std::get_if<Proposal>(&proposed)) {
      p->forward /= y.intensity;
      p->reverse /= x.intensity;
    }
    return proposed;
  }
};

}  // namespace wander::test
