// Wrong twins of the lens, caustic and multi-chain perturbations.
//
// The mutations are templates of the space and of the random numbers, so that a flaw is a space
// that states a wrong density or goes a wrong way, or numbers that are not what they should be; the
// text that is tested is the program's.
#pragma once

#include <utility>
#include <vector>

#include "mutations/catalogue.h"

namespace wander::test {

// ---- flawed spaces

template <class Space>
struct Faithful : Space {
  explicit Faithful(const Space& space) : Space(space) {}
};

// The edge from x_i toward an end.
template <class W>
const Vertex<W>& lower_end(const Path<W>& x, int i, Toward toward) {
  return x[toward == Toward::sensor ? i : i - 1];
}

// The cosine at a turned direction left out: dω⊥ taken for dω.
template <class Space>
struct WithoutCosine : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double aim_density(const Path<W>& x, int i, Toward toward) const {
    if (this->is_camera(x[i])) return Space::aim_density(x, i, toward);
    return lower_end(x, i, toward).geometry;
  }
};

// The density of a direction taken for a density of area.
template <class Space>
struct WithoutGeometry : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double aim_density(const Path<W>& x, int i, Toward toward) const {
    return Space::aim_density(x, i, toward) / lower_end(x, i, toward).geometry;
  }
};

// The cosine by which a camera's film is seen left out.
template <class Space>
struct WithoutFilmSpread : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double aim_density(const Path<W>& x, int i, Toward toward) const {
    return this->is_camera(x[i]) ? lower_end(x, i, toward).geometry
                                 : Space::aim_density(x, i, toward);
  }
};

// 1/r^(D-2) in place of 1/r^(D-1).
template <class Space>
struct WithOneDistanceLess : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double aim_density(const Path<W>& x, int i, Toward toward) const {
    const int j = toward == Toward::sensor ? i + 1 : i - 1;
    return Space::aim_density(x, i, toward) *
           static_cast<double>(glm::length(x[j].place.position - x[i].place.position));
  }
};

// Refraction taken for a mirror: n^(D-1) left out.
template <class Space>
struct WithoutIndexSpread : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double follow_density(const Path<W>& x, int i, Toward toward) const {
    return lower_end(x, i, toward).geometry;
  }
};

// The size of the light or the sensor left out.
template <class Space>
struct WithoutEndDensity : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  double end_density(const Path<W>&, int) const {
    return 1;
  }
};

// Connects specular vertices as if they scattered.
template <class Space>
struct ConnectingAnything : Faithful<Space> {
  using Faithful<Space>::Faithful;
  template <class W>
  bool can_connect(const Vertex<W>&) const {
    return true;
  }
};

// ---- around a mutation

// The mutation in a flawed space.
template <class M, template <class> class Twin>
struct In {
  static constexpr std::string_view name = M::name;
  M mutation;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    return mutation.propose(Twin<Space>(space), x, y, random);
  }
};

// Follows reflections and transmissions as a biased coin decides, and not as the path did.  (With a
// fair coin this would be right: both lobes are then as likely there as back.)
template <class M>
struct WithLobesByCoin {
  static constexpr std::string_view name = M::name;
  M mutation;
  double reflection = 0.9;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const Event event = random.uniform() < reflection ? Event::reflection : Event::transmission;
    return mutation.propose(OneLobe<Space>(space, event), x, y, random);
  }

 private:
  template <class Space>
  struct OneLobe : Faithful<Space> {
    Event lobe;
    OneLobe(const Space& space, Event event) : Faithful<Space>(space), lobe(event) {}
    template <class W>
    bool follow(Path<W>& x, int i, Toward toward, Event event) const {
      return Space::follow(x, i, toward, lobe) || Space::follow(x, i, toward, event);
    }
  };
};

// Offsets that leave the film or a surface end at its edge.
template <class M>
struct Clamped {
  static constexpr std::string_view name = M::name;
  M mutation;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    return mutation.propose(Edged<Space>(space, x), x, y, random);
  }

 private:
  // Says that everything is in the middle, whence no offset of less than a half leads outside.
  template <class Space>
  struct Edged : Faithful<Space> {
    using W = typename Space::Universe;
    using Square = typename W::Square;
    const Path<W>* start;
    Edged(const Space& space, const Path<W>& x) : Faithful<Space>(space), start(&x) {}

    static Square middle() {
      Square u;
      u.fill(0.5);
      return u;
    }
    static Square from(Square real, Square offset) {
      for (std::size_t k = 0; k < real.size(); ++k)
        real[k] = std::clamp(real[k] + offset[k] - 0.5, 0.0, std::nextafter(1.0, 0.0));
      return real;
    }
    Square end_parameter(const Path<W>&, int) const { return middle(); }
    Square film_position(const Path<W>&) const { return middle(); }
    void move_end(Path<W>& y, int i, Square u) const {
      Space::move_end(y, i, from(Space::end_parameter(*start, i), u));
    }
    bool aim_film(Path<W>& y, int i, Square film) const {
      return Space::aim_film(y, i, from(Space::film_position(*start), film));
    }
  };
};

// A range of angles that is longer where the first moved edge is, as Veach scales it; y → x is
// possible only if the angle is in the range of y, too, and the twin does not ask.
template <class M>
struct RangeOfThePath {
  static constexpr std::string_view name = M::name;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return M{}.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = x.size();
    const auto edge = glm::length(x[n - 1].place.position - x[n - 2].place.position);
    const double largest = 0.5 * static_cast<double>(edge);
    M mutation;
    mutation.range = {.position{1e-3, 0.1}, .angle{largest / 8, largest}};
    return mutation.propose(space, x, y, random);
  }
};

// ---- flawed numbers: every move of the plane draws a distance and then a side

// Every move to one side half as likely as to the other.
template <class Random>
struct Lopsided {
  Random& random;
  bool side = false;

  double uniform() {
    const double u = random.uniform();
    side = !side;
    if (side) return u;
    return u < 1.0 / 3 ? 1.5 * u : 0.25 + 0.75 * u;
  }
};

// The same distance and side for every move.
template <class Random>
struct Repeated {
  Random& random;
  std::vector<double> drawn{};
  std::size_t next = 0;

  double uniform() {
    if (drawn.size() < 2) drawn.push_back(random.uniform());
    return drawn[next++ % 2];
  }
};

template <class M, template <class> class Numbers>
struct By {
  static constexpr std::string_view name = M::name;
  M mutation;

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    Numbers<Random> numbers{random};
    return mutation.propose(space, x, y, numbers);
  }
};

// ---- a flawed mixture

// A mixture that takes the selection probability of x for that of y.
template <class Kernel>
struct StaleSelection {
  Kernel mixture;

  template <class Space, class Random>
  typename Kernel::Selected propose(const Space& space, const Path<typename Space::Universe>& x,
                                    Path<typename Space::Universe>& y, Random& random) const {
    auto selected = mixture.propose(space, x, y, random);
    if (Proposal* p = std::get_if<Proposal>(&selected.proposed)) {
      const auto i = static_cast<std::size_t>(selected.mutation);
      p->reverse *= mixture.probabilities(space, x)[i] / mixture.probabilities(space, y)[i];
    }
    return selected;
  }
  template <class Space>
  auto probabilities(const Space& space, const Path<typename Space::Universe>& x) const {
    return mixture.probabilities(space, x);
  }
};

}  // namespace wander::test
