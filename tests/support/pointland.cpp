#include "tests/support/pointland.h"

#include <cmath>
#include <stdexcept>

#include "core/techniques.h"

namespace wander::test {

namespace {

double random_value(Generator& random) { return std::exp2(4 * random.uniform() - 2); }

bool holds(const Nodes& nodes, int node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

std::vector<double> random_values(Generator& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = random_value(random);
  return values;
}

// A pmf over those of n indices that are possible; all zero if none is.
template <class Possible>
std::vector<double> random_pmf(Generator& random, int n, const Possible& possible) {
  std::vector<double> pmf = random_values(random, static_cast<std::size_t>(n));
  double total = 0;
  for (int i = 0; i < n; ++i) {
    double& p = pmf[static_cast<std::size_t>(i)];
    if (!possible(i)) p = 0;
    total += p;
  }
  if (total > 0)
    for (double& p : pmf) p /= total;
  return pmf;
}

}  // namespace

const SpecularNode* Graph::specular(int node) const {
  for (const SpecularNode& s : plan_.specular)
    if (s.node == node) return &s;
  return nullptr;
}

bool Graph::is_pinhole(int node) const {
  return plan_.reach == SensorReach::pinhole && holds(plan_.sensors, node);
}

bool Graph::is_black(int node) const { return holds(plan_.black, node) || is_pinhole(node); }

int Graph::lobe(const SpecularNode& s, int a, int b) {
  for (std::size_t k = 0; k < s.involution.size(); ++k)
    if (s.involution[k][index(a)] == b) return static_cast<int>(k);
  return -1;
}

Graph::Graph(const GraphPlan& plan) : plan_(plan) {
  const int n = plan.nodes;
  Generator random(plan.seed);
  light_pmf_ = random_pmf(random, n, [&](int i) { return holds(plan.lights, i); });
  sensor_pmf_ = random_pmf(random, n, [&](int i) { return holds(plan.sensors, i); });
  geometry_ = random_values(random, pair(n, 0));
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) geometry_[pair(a, b)] = geometry_[pair(b, a)];
  for (int a = 0; a < n; ++a) geometry_[pair(a, a)] = 0;
  for (const auto& [a, b] : plan.blocked) geometry_[pair(a, b)] = geometry_[pair(b, a)] = 0;

  emission_ = random_values(random, pair(n, 0));
  for (const auto& [a, b] : plan.dark) emission_[pair(a, b)] = 0;
  importance_ = random_values(random, pair(n, 0));
  for (const auto& [a, b] : plan.deaf) importance_[pair(a, b)] = 0;
  scattering_ = random_values(random, pair(n, 0) * index(n));
  for (const auto& [a, m, b] : plan.one_way) scattering_[triple(a, m, b)] = 0;
  fill_walks(random);
}

void Graph::fill_walks(Generator& random) {
  const int n = plan_.nodes;
  const auto walk_over = [&](const auto& possible) {  // the last entry leaves the scene
    std::vector<double> pmf = random_pmf(random, n, possible);
    double stays = 0;
    for (double& p : pmf) stays += p *= 1 - plan_.escape;
    pmf.push_back(1 - stays);
    return pmf;
  };
  const auto leads = [&](int m, int b) { return geometry(m, b) > 0 && !is_pinhole(b); };
  const auto& never = plan_.never_walked;
  for (int m = 0; m < n; ++m) {
    light_walk_.push_back(walk_over([&](int b) { return leads(m, b); }));
    sensor_walk_.push_back(walk_over([&](int b) { return leads(m, b); }));
  }
  for (int a = 0; a < n; ++a)
    for (int m = 0; m < n; ++m) {
      const auto possible = [&](int b) {
        const bool forbidden =
            std::find(never.begin(), never.end(), std::array{a, m, b}) != never.end();
        return leads(m, b) && !is_black(m) && !forbidden;
      };
      const SpecularNode* s = specular(m);
      walk_.push_back(s ? random_pmf(random, static_cast<int>(s->involution.size()) + 1,
                                     [](int) { return true; })
                        : walk_over(possible));
    }
}

// ---- the vocabulary

std::span<const double> Graph::walk(const Vertex<Pointland>& v, int known) const {
  if (v.event == Event::emission) return light_walk_[index(v.place.node)];
  if (v.event == Event::detection) return sensor_walk_[index(v.place.node)];
  return walk_[pair(known, v.place.node)];
}

int Graph::arrive(Vertex<Pointland>& v, int known, int choice) const {
  const SpecularNode* s = is_end(v) ? nullptr : specular(v.place.node);
  const int outcomes = s ? static_cast<int>(s->involution.size()) : plan_.nodes;
  if (choice == outcomes) return no_node;
  if (!s) return choice;
  v.event = choice == 0 ? Event::reflection : Event::transmission;
  const int next = s->involution[index(choice)][index(known)];
  return is_pinhole(next) ? no_node : next;
}

double Graph::walk_probability(const Vertex<Pointland>& v, int known, int next) const {
  if (is_pinhole(next)) return unreal_density;
  const auto pmf = walk(v, known);
  if (!wander::is_specular(v.event)) return pmf[index(next)];
  const SpecularNode& s = *specular(v.place.node);
  const std::size_t lobe = v.event == Event::reflection ? 0 : 1;
  return s.involution[lobe][index(known)] == next ? pmf[lobe] : 0;
}

double Graph::scattering(const Vertex<Pointland>& v, int a, int b) const {
  if (is_black(v.place.node)) return 0;
  if (wander::is_specular(v.event)) {
    const std::size_t lobe = v.event == Event::reflection ? 0 : 1;
    if (specular(v.place.node)->involution[lobe][index(a)] != b) return 0;
  }
  return scattering_[triple(a, v.place.node, b)];
}

Connection Graph::connect(PointPath& x, int i) const {
  x[i].geometry = geometry(x[i].place.node, x[i + 1].place.node);
  if (x[i].place.node == x[i + 1].place.node) return Connection::facing_away;
  return x[i].geometry > 0 ? Connection::open : Connection::occluded;
}

void Graph::evaluate(PointPath& x, int i) const {
  Vertex<Pointland>& v = x[i];
  const int node = v.place.node;
  if (v.event == Event::emission) {
    const int next = x[1].place.node;
    v.value = emission_[pair(node, next)];
    v.from_light = light_pmf_[index(node)];
    x[1].from_light = walk_probability(v, no_node, next);
    return;
  }
  const int previous = x[i - 1].place.node;
  if (v.event == Event::detection) {
    v.value = importance_[pair(previous, node)];
    v.from_sensor = sensor_pmf_[index(node)];
    x[i - 1].from_sensor = walk_probability(v, no_node, previous);
    return;
  }
  const int next = x[i + 1].place.node;
  v.value = scattering(v, previous, next);
  x[i + 1].from_light = walk_probability(v, previous, next);
  x[i - 1].from_sensor = walk_probability(v, next, previous);
}

// ---- without the vocabulary

double Graph::target(const Nodes& x) const {
  const std::size_t n = x.size();
  if (!holds(plan_.lights, x.front()) || !holds(plan_.sensors, x.back())) return 0;
  double f = emission_[pair(x[0], x[1])] * importance_[pair(x[n - 2], x[n - 1])];
  for (std::size_t i = 0; i + 1 < n; ++i) f *= geometry(x[i], x[i + 1]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const SpecularNode* s = specular(x[i]);
    if (is_black(x[i]) || (s && lobe(*s, x[i - 1], x[i + 1]) < 0)) return 0;
    f *= scattering_[triple(x[i - 1], x[i], x[i + 1])];
  }
  return f;
}

std::vector<Nodes> Graph::light_paths() const {
  std::vector<Nodes> found, longest{{}};
  for (int count = 1; count <= plan_.max_vertices; ++count) {
    std::vector<Nodes> longer;
    for (const Nodes& x : longest)
      for (int node = 0; node < plan_.nodes; ++node) {
        longer.push_back(x);
        longer.back().push_back(node);
        if (count > 1 && target(longer.back()) > 0) found.push_back(longer.back());
      }
    longest = std::move(longer);
  }
  return found;
}

PointPath Graph::path(const Nodes& nodes) const {
  const int n = static_cast<int>(nodes.size());
  PointPath x(plan_.max_vertices);
  x.resize(n);
  for (int i = 0; i < n; ++i) {
    const std::size_t k = index(i);
    x[i].place.node = nodes[k];
    const SpecularNode* s = i == 0 || i == n - 1 ? nullptr : specular(nodes[k]);
    x[i].event = i == 0                                      ? Event::emission
                 : i == n - 1                                ? Event::detection
                 : !s                                        ? Event::scattering
                 : lobe(*s, nodes[k - 1], nodes[k + 1]) == 0 ? Event::reflection
                                                             : Event::transmission;
  }
  for (int i = 0; i + 1 < n; ++i) connect(x, i);
  for (int i = 0; i < n; ++i) evaluate(x, i);
  x.contribution = contribution(x);
  return x;
}

// ---- the graphs of the proof

std::vector<GraphPlan> proof_plans() {
  std::vector<GraphPlan> plans;
  plans.push_back(
      {.name = "diffuse", .seed = 1, .nodes = 5, .max_vertices = 5, .lights = {0}, .sensors = {1}});
  // Node 2 is a mirror: light from 0 goes to 1, light from 3 to 4.
  plans.push_back({.name = "mirror",
                   .seed = 2,
                   .nodes = 5,
                   .max_vertices = 5,
                   .lights = {0},
                   .sensors = {1},
                   .specular = {{2, {{1, 0, 2, 4, 3}}}}});
  // Glass (2) and a mirror (3) beside each other; the mirror itself emits.
  plans.push_back({.name = "glass",
                   .seed = 3,
                   .nodes = 5,
                   .max_vertices = 5,
                   .lights = {0, 3},
                   .sensors = {1},
                   .specular = {{2, {{1, 0, 2, 4, 3}, {4, 3, 2, 1, 0}}}, {3, {{2, 4, 0, 3, 1}}}}});
  plans.push_back({.name = "two lights, two sensors",
                   .seed = 4,
                   .nodes = 5,
                   .max_vertices = 5,
                   .lights = {0, 2},
                   .sensors = {1, 2}});
  // The sensor (4) is a pinhole, a mirror (2) hangs before it; one light is black.
  plans.push_back({.name = "pinhole",
                   .seed = 5,
                   .nodes = 5,
                   .max_vertices = 5,
                   .lights = {0, 1},
                   .sensors = {4},
                   .reach = SensorReach::pinhole,
                   .specular = {{2, {{4, 1, 2, 3, 0}}}},
                   .black = {0}});
  // Zeros in one direction only; a sensor that one light cannot see.
  plans.push_back({.name = "one-way",
                   .seed = 6,
                   .nodes = 5,
                   .max_vertices = 5,
                   .lights = {0, 3},
                   .sensors = {1},
                   .blocked = {{0, 1}},
                   .dark = {{0, 3}, {3, 2}},
                   .deaf = {{2, 1}},
                   .one_way = {{0, 2, 3}, {4, 3, 2}, {3, 2, 3}, {0, 4, 1}},
                   .never_walked = {{0, 2, 4}, {1, 3, 0}, {2, 3, 2}, {1, 4, 0}}});
  return plans;
}

GraphPlan proof_plan(const std::string& name, int max_vertices) {
  for (GraphPlan& plan : proof_plans())
    if (plan.name == name) {
      plan.max_vertices = max_vertices;
      return plan;
    }
  throw std::invalid_argument("no graph is named " + name);
}

}  // namespace wander::test
