// Throughput on one thread, and the share of ray casts in it: see docs/benchmarks.md.
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mlt/run/test_image.h"
#include "tests/benchmarks/alternation.h"
#include "tests/benchmarks/scaling.h"
#include "tests/benchmarks/workers.h"

namespace wander {

namespace {

constexpr std::array scenes{"slit", "article-3", "lens", "mirror-dish", "frosted"};
constexpr std::array scenes_in_space{"cornell", "cornell-glass"};
constexpr int workers_per_round = 32;

// ---- rays of bidirectional samples

template <World W>
RayLog<W> recorded_rays(Scene<W>& scene) {
  const Transport<W> transport(scene, Roulette::by_albedo);
  SampleWorker<W> worker(transport, 0);
  RayLog<W> log;
  scene.watch(&log);
  for (int turn = 0; turn < 16; ++turn) worker.take_turn();
  scene.watch(nullptr);
  return log;
}

template <World W>
void bench_closest(benchmark::State& state, const std::string& name) {
  const auto scene = bench_scene<W>(name);
  const auto log = recorded_rays(*scene);
  for (auto _ : state) benchmark::DoNotOptimize(cast_closest(*scene, log));
  const double rays = static_cast<double>(log.closest.size());
  state.counters["rays/s"] = {rays, benchmark::Counter::kIsIterationInvariantRate};
}

template <World W>
void bench_any(benchmark::State& state, const std::string& name) {
  const auto scene = bench_scene<W>(name);
  const auto log = recorded_rays(*scene);
  for (auto _ : state) benchmark::DoNotOptimize(cast_any(*scene, log));
  const double rays = static_cast<double>(log.any.size());
  state.counters["rays/s"] = {rays, benchmark::Counter::kIsIterationInvariantRate};
  state.counters["occluded"] = cast_any(*scene, log) / rays;
}

// ---- samples and mutations

template <World W>
void bench_samples(benchmark::State& state, const std::string& name) {
  const auto scene = bench_scene<W>(name);
  const Transport<W> transport(*scene, Roulette::by_albedo);
  std::vector<SampleWorker<W>> workers;
  workers.reserve(workers_per_round);
  for (int k = 0; k < workers_per_round; ++k)
    workers.emplace_back(transport, std::uint64_t{1} << 24 | static_cast<std::uint64_t>(k) << 32);
  alternate(state, *scene, workers, "samples/s");
}

// As a run of `mlt` makes them: of an image the target is even.
template <World W>
void bench_seeds(benchmark::State& state, const std::string& name) {
  const auto scene = bench_scene<W>(name);
  const Transport<W> light(*scene, Roulette::off);
  const auto importance = importance_of_test_image(light, [] { return false; });
  const Transport<W> transport = importance ? light.measuring(*importance) : light;
  std::vector<SeedWorker<W>> workers;
  workers.reserve(workers_per_round);
  for (int k = 0; k < workers_per_round; ++k) workers.emplace_back(transport, k);
  alternate(state, *scene, workers, "samples/s");
}

// `choose` makes the kernel of the mixture of all.
template <World W>
void bench_mutations(benchmark::State& state, const std::string& name,
                     const std::function<Family(const Family&)>& choose) {
  const auto scene = bench_scene<W>(name);
  const Transport<W> transport(*scene, Roulette::off);
  Family family = choose(make_family({}, scene->max_vertices()));
  SeedSlice<Transport<W>> slice(transport, 1, 0, workers_per_round);
  slice.run(1 << 12);
  if (!slice.found_light()) return state.SkipWithError("no seed path was found");
  family.learn(slice.tally());
  std::vector<ChainWorker<W>> workers;
  workers.reserve(workers_per_round);
  for (int k = 0; k < workers_per_round; ++k)
    workers.emplace_back(transport, family, slice.replay(slice.seed(k), scene->max_vertices()),
                         static_cast<std::uint32_t>(k));
  alternate(state, *scene, workers, "mutations/s");
}

template <World W>
void register_all(std::span<const char* const> names) {
  for (const std::string name : names) {
    const auto add = [&](const std::string& kind, double seconds, auto run) {
      return benchmark::RegisterBenchmark((kind + "/" + name).c_str(), run)
          ->MinTime(seconds)
          ->Unit(benchmark::kMicrosecond);
    };
    add("closest", 0.1, [name](benchmark::State& state) { bench_closest<W>(state, name); });
    add("any", 0.1, [name](benchmark::State& state) { bench_any<W>(state, name); });
    add("bdpt", 0.3, [name](benchmark::State& state) {
      bench_samples<W>(state, name);
    })->UseManualTime();
    add("seeds", 0.3, [name](benchmark::State& state) {
      bench_seeds<W>(state, name);
    })->UseManualTime();
    for (std::size_t i = 0; i < Family::count; ++i)
      add(std::string(Family::names[i]), 0.3, [name, i](benchmark::State& state) {
        bench_mutations<W>(state, name, [i](const Family& all) { return all.only(i); });
      })->UseManualTime();
    add("mixture", 0.3, [name](benchmark::State& state) {
      bench_mutations<W>(state, name, [](const Family& all) { return all; });
    })->UseManualTime();
  }
}

}  // namespace

}  // namespace wander

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  wander::register_all<wander::Flatland>(wander::scenes);
  wander::register_all<wander::SpacelandColour>(wander::scenes_in_space);
  wander::register_scaling();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
