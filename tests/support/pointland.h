// Pointland: the world for proof.  Places are the nodes of a finite graph with given geometry
// terms, walk probabilities, emission, scattering and importance; Graph offers the vocabulary of
// core/transport.h, so that mutations, mixtures and chains run in it unchanged.
//
//   f(x) = Le(x_0→x_1) Π f_s(x_{i-1}→x_i→x_{i+1}) We(x_{n-2}→x_{n-1}) Π G(x_i, x_{i+1})
// Measure: counting.  Every density is a probability: from_light and from_sensor are entries of the
// walk's pmfs, without G.  Every random choice is discrete and goes through random.choose(pmf), so
// all of them can be enumerated (enumeration.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/path.h"
#include "core/transport.h"
#include "tests/support/generator.h"

namespace wander::test {

struct Pointland {
  static constexpr int dimension = 0;
  using Real = double;
  using Tint = wander::Tint<1>;
  struct Place {
    int node = -1;
  };
};

using PointPath = Path<Pointland>;
using Nodes = std::vector<int>;  // of a path, light first

// What a specular node does with light: lobe k sends what comes from node a to involution[k][a],
// and what comes from there to a.  One lobe is a mirror; a second one transmits.
struct SpecularNode {
  int node;
  std::vector<Nodes> involution;
};

enum class SensorReach { can_be_hit, pinhole };

// A graph is made of its topology, and of random numbers between 1/4 and 4 for everything else.
struct GraphPlan {
  std::string name;
  std::uint64_t seed;
  int nodes, max_vertices;
  Nodes lights, sensors;
  SensorReach reach = SensorReach::can_be_hit;  // a pinhole is met by no walk, and scatters nothing
  std::vector<SpecularNode> specular{};
  Nodes black{};                                   // these absorb
  std::vector<std::pair<int, int>> blocked{};      // V = 0, both ways
  std::vector<std::array<int, 2>> dark{};          // Le(a→b) = 0
  std::vector<std::array<int, 2>> deaf{};          // We(a→b) = 0
  std::vector<std::array<int, 3>> one_way{};       // f_s(a→m→b) = 0, but not f_s(b→m→a)
  std::vector<std::array<int, 3>> never_walked{};  // coming from a, m never walks on to b
  double escape = 0.1;                             // share of walks that leave the scene
};

inline std::ostream& operator<<(std::ostream& out, const GraphPlan& plan) {
  return out << plan.name;
}

class Graph {
 public:
  using Universe = Pointland;

  explicit Graph(const GraphPlan& plan);

  const std::string& name() const { return plan_.name; }
  int max_vertices() const { return plan_.max_vertices; }
  int nodes() const { return plan_.nodes; }
  int bin(const PointPath& x) const { return x[x.size() - 1].place.node; }

  template <class Random>
  void begin_light(PointPath& x, int i, Random& random) const {
    x[i].place.node = random.choose(std::span<const double>(light_pmf_));
    x[i].event = Event::emission;
  }
  template <class Random>
  void begin_sensor(PointPath& x, int i, Random& random) const {
    x[i].place.node = random.choose(std::span<const double>(sensor_pmf_));
    x[i].event = Event::detection;
  }
  template <class Random>
  bool extend(PointPath& x, int i, Toward toward, Random& random) const {
    const int j = toward == Toward::sensor ? i + 1 : i - 1;
    const int known = is_end(x[i]) ? no_node : x[2 * i - j].place.node;
    const int choice = random.choose(walk(x[i], known));
    const int next = arrive(x[i], known, choice);
    if (next == no_node) return false;
    x[j].place.node = next;
    x[j].event = is_specular(next) ? Event::reflection : Event::scattering;
    Vertex<Pointland>& lower = x[std::min(i, j)];
    lower.geometry = geometry(x[i].place.node, next);
    return lower.geometry > 0;
  }
  double survival(const Vertex<Pointland>&) const { return 1; }
  double albedo(const Vertex<Pointland>&) const { return 1; }
  const auto& with(Roulette) const { return *this; }

  bool may_connect(const PointPath&, int, const PointPath&, int) const { return true; }
  Connection connect(PointPath& x, int i) const;
  void evaluate(PointPath& x, int i) const;

  bool can_connect(const Vertex<Pointland>& v) const {
    if (v.event != Event::scattering) return !wander::is_specular(v.event);
    return !is_black(v.place.node);
  }
  bool is_light(const Vertex<Pointland>& v) const { return light_pmf_[index(v.place.node)] > 0; }
  bool is_sensor(const Vertex<Pointland>& v) const {
    return plan_.reach == SensorReach::can_be_hit && sensor_pmf_[index(v.place.node)] > 0;
  }
  bool sensor_can_be_hit() const { return plan_.reach == SensorReach::can_be_hit; }

  // ---- the same measurements without the vocabulary, to check it --------------------------------

  // f of a sequence of nodes, straight from the tables; 0 where it is no light path.
  double target(const Nodes& x) const;
  // All sequences with f > 0, of 2 … max_vertices nodes.
  std::vector<Nodes> light_paths() const;
  // The path of a sequence, with everything measured anew.
  PointPath path(const Nodes& x) const;

 private:
  static constexpr int no_node = -1;
  // Densities that no sampler can realise, such as that of hitting a pinhole, hold this number: it
  // spoils whatever takes it for a probability.
  static constexpr double unreal_density = 0.37;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static bool is_end(const Vertex<Pointland>& v) {
    return v.event == Event::emission || v.event == Event::detection;
  }
  std::size_t pair(int a, int b) const { return index(a) * index(plan_.nodes) + index(b); }
  std::size_t triple(int a, int m, int b) const {
    return pair(a, m) * index(plan_.nodes) + index(b);
  }

  void fill_walks(Generator& random);
  const SpecularNode* specular(int node) const;
  bool is_specular(int node) const { return specular(node) != nullptr; }
  bool is_black(int node) const;
  bool is_pinhole(int node) const;
  double geometry(int a, int b) const { return geometry_[pair(a, b)]; }
  // The lobe of a specular node that leads from a to b, or -1.
  static int lobe(const SpecularNode& s, int a, int b);

  // The pmf of what follows v, coming from `known`: an entry per node (per lobe where v is
  // specular) and, last, one for leaving the scene.
  std::span<const double> walk(const Vertex<Pointland>& v, int known) const;
  // The node that a choice from walk() leads to; at a specular node it decides the event.
  int arrive(Vertex<Pointland>& v, int known, int choice) const;
  double walk_probability(const Vertex<Pointland>& v, int known, int next) const;
  double scattering(const Vertex<Pointland>& v, int a, int b) const;

  GraphPlan plan_;
  std::vector<double> light_pmf_, sensor_pmf_;                 // by node
  std::vector<double> geometry_;                               // G V, by pair
  std::vector<double> emission_, importance_;                  // Le(a→b), We(a→b): by pair
  std::vector<double> scattering_;                             // by triple
  std::vector<std::vector<double>> light_walk_, sensor_walk_;  // by node
  std::vector<std::vector<double>> walk_;                      // by pair (known, node)
};

static_assert(PathSpace<Graph>);

// The graphs of the proof: diffuse; mirror; glass; two lights and two sensors; a pinhole; sides
// that are dark one way.  Four or five nodes, up to five vertices, at most some hundreds of light
// paths.
std::vector<GraphPlan> proof_plans();
// One of them, perhaps with shorter paths.
GraphPlan proof_plan(const std::string& name, int max_vertices = 5);

}  // namespace wander::test
