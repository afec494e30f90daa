// Work against its ray casts: how much of a sample is spent on rays?
//
// Workers do work in short turns.  In each round a copy of every worker takes its turn first and
// writes its rays down; then, by turns, a worker does the same work, with no log, and another
// worker's rays are cast alone.  Both clocks run within the same fraction of a millisecond of each
// other, so that what disturbs one disturbs both and their ratio stands; and thousands of rays lie
// between two casts of the same one, so that no branch predictor has learnt them by heart.
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "tests/benchmarks/bench_scene.h"
#include "work/clock.h"

namespace wander {

struct AlternationTotals {
  double work_seconds = 0, cast_seconds = 0;
  double items = 0, rays = 0;

  void report(benchmark::State& state, const char* rate) const {
    state.counters[rate] = items / work_seconds;
    state.counters["ns"] = work_seconds * 1e9 / items;
    state.counters["rays/item"] = rays / items;
    state.counters["rays/s"] = rays / cast_seconds;  // alone
    state.counters["ratio"] = work_seconds / cast_seconds;
    state.counters["share"] = cast_seconds / work_seconds;
  }
};

// A Worker has `static constexpr int items_per_turn`; a `take_turn()` that depends on nothing but
// the worker's own state; and copies that take the same turns.
template <World W, class Worker>
void alternate(benchmark::State& state, Scene<W>& scene, std::vector<Worker>& workers,
               const char* rate) {
  const auto now = [] { return system_clock().now().processor; };
  const std::size_t count = workers.size();
  std::vector<RayLog<W>> logs(count);
  AlternationTotals totals;
  for (auto _ : state) {
    for (std::size_t k = 0; k < count; ++k) {
      logs[k].closest.clear();
      logs[k].any.clear();
      scene.watch(&logs[k]);
      Worker(workers[k]).take_turn();
      scene.watch(nullptr);
    }
    double work = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto& log = logs[(k + count / 2) % count];
      const auto start = now();
      workers[k].take_turn();
      const auto middle = now();
      benchmark::DoNotOptimize(cast_closest(scene, log) + cast_any(scene, log));
      const auto end = now();
      work += middle - start;
      totals.cast_seconds += end - middle;
      totals.rays += static_cast<double>(log.closest.size() + log.any.size());
    }
    totals.work_seconds += work;
    totals.items += static_cast<double>(count) * Worker::items_per_turn;
    state.SetIterationTime(work);
  }
  totals.report(state, rate);
}

}  // namespace wander
