#include "tests/benchmarks/scaling.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "mlt/primary/single_technique.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/workers.h"

namespace wander {

namespace {

using W = Flatland;
using Point = W::Point;

constexpr int no_pillar = 0;

void add_segment(SceneParts<W>& parts, Point from, Point to) {
  parts.parts.push_back({Segment<W>(from, to), 0});
}

// A room of which everything is nearly white, so that paths may be long: a lamp at its ceiling, a
// sensor on its floor, and in between a pillar with so many sides.
std::unique_ptr<Scene<W>> room(int sides, int max_vertices) {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.999}};
  parts.resolution = {64};
  parts.max_vertices = max_vertices;
  const std::array<Point, 4> corners{Point(0, 0), Point(4, 0), Point(4, 3), Point(0, 3)};
  for (std::size_t i = 0; i < 4; ++i) add_segment(parts, corners[i], corners[(i + 1) % 4]);
  parts.parts.push_back({Segment<W>(Point(2.5, 2.9), Point(1.5, 2.9)), 0, 1.0});
  parts.parts.push_back({Segment<W>(Point(1.5, 0.1), Point(2.5, 0.1)), 0, 0.0, true});
  const auto corner = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    return Point(2 + 0.8 * std::cos(angle), 1.5 + 0.8 * std::sin(angle));
  };
  for (int i = 0; i < sides; ++i) add_segment(parts, corner(i), corner(i + 1));
  return std::make_unique<Scene<W>>(std::move(parts));
}

Family mixture_of(const Scene<W>& scene) {
  FamilySettings settings;
  settings.weights = {{"bidirectional", 0.5, {}}, {"lens", 1, {}}, {"primary", 1.5, {}}};
  return make_family(settings, scene.max_vertices());
}

// By one technique, with as many vertices from the lamp as from the sensor.
Path<W> path_of(const Transport<W>& transport, int vertices) {
  Path<W> path(transport.max_vertices());
  Rng random(1, Purpose::test, 0);
  for (std::uint64_t i = 0;; ++i) {
    random.start(i);
    if (sample_technique(transport, path, vertices, vertices / 2, random) == Reason::none)
      return path;
  }
}

void report(benchmark::State& state, double items, const char* item) {
  state.counters[item] = {
      items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

// ---- each by a mutation alone, or by all (Family::count)

void steps_of_length(benchmark::State& state, std::size_t mutation) {
  const auto vertices = static_cast<int>(state.range(0));
  const auto scene = room(no_pillar, vertices + 16);
  const Transport<W> transport(*scene, Roulette::off);
  const Family all = mixture_of(*scene);
  const Family family = mutation < Family::count ? all.only(mutation) : all;
  ChainWorker<W> worker(transport, family, path_of(transport, vertices), 0);
  for (auto _ : state) worker.take_turn();
  report(state, ChainWorker<W>::items_per_turn, "mutation");
}

void weights_of_length(benchmark::State& state) {
  const auto vertices = static_cast<int>(state.range(0));
  const auto scene = room(no_pillar, vertices);
  const Transport<W> transport(*scene, Roulette::off);
  Path<W> path = path_of(transport, vertices);
  for (auto _ : state) {
    weigh(transport, path);
    benchmark::DoNotOptimize(path.weights().data());
  }
  report(state, vertices, "vertex");
}

// ---- a scene of so many shapes

void steps_among_shapes(benchmark::State& state) {
  const auto scene = room(static_cast<int>(state.range(0)), 8);
  const Transport<W> transport(*scene, Roulette::off);
  const Family family = mixture_of(*scene);
  ChainWorker<W> worker(transport, family, path_of(transport, 4), 0);
  for (auto _ : state) worker.take_turn();
  report(state, ChainWorker<W>::items_per_turn, "mutation");
}

void samples_among_shapes(benchmark::State& state) {
  const auto scene = room(static_cast<int>(state.range(0)), 8);
  SampleWorker<W> worker(Transport<W>(*scene, Roulette::off), 0);
  for (auto _ : state) worker.take_turn();
  report(state, SampleWorker<W>::items_per_turn, "sample");
}

// ---- so many chains, which take turns

void steps_of_chains(benchmark::State& state) {
  const auto scene = room(8, 8);
  const Transport<W> transport(*scene, Roulette::off);
  const Family family = mixture_of(*scene);
  std::vector<std::unique_ptr<ChainWorker<W>>> workers;
  for (std::int64_t k = 0; k < state.range(0); ++k)
    workers.push_back(std::make_unique<ChainWorker<W>>(transport, family, path_of(transport, 4),
                                                       static_cast<std::uint32_t>(k)));
  for (auto _ : state)
    for (auto& worker : workers) worker->take_turn();
  report(state, ChainWorker<W>::items_per_turn * static_cast<double>(workers.size()), "mutation");
}

}  // namespace

void register_scaling() {
  const auto add = [](const std::string& name, auto run) {
    return benchmark::RegisterBenchmark(name.c_str(), run)->MinTime(0.2);
  };
  const std::vector<std::int64_t> lengths{4, 10, 30, 100, 300, 1000};
  for (std::size_t i = 0; i <= Family::count; ++i) {
    const std::string name(i < Family::count ? Family::names[i] : "mixture");
    if (name == "caustic" || name == "multichain") continue;  // without mirrors there are none
    add("length/" + name, [i](benchmark::State& state) {
      steps_of_length(state, i);
    })->ArgsProduct({lengths});
  }
  add("length/weights", weights_of_length)->ArgsProduct({lengths});
  const std::vector<std::int64_t> shapes{0, 10, 100, 1000, 10'000, 100'000, 1'000'000};
  add("shapes/mixture", steps_among_shapes)->ArgsProduct({shapes});
  add("shapes/bdpt", samples_among_shapes)->ArgsProduct({shapes});
  add("chains/mixture", steps_of_chains)->ArgsProduct({{1, 16, 256, 4096}});
}

}  // namespace wander
