#include "core/sample_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/run.h"

namespace wander {

namespace {

// Samples per unit of work: enough to hide the cost of merging a film, whatever the threads.
std::uint64_t samples_per_unit(int bins) {
  return std::max<std::uint64_t>(4096, static_cast<std::uint64_t>(bins) / 4);
}

// What one unit works in.
struct Slot {
  FilmSampler sample;
  SampleFilm film;
};

struct Limit {
  std::uint64_t samples;
  double seconds;

  explicit Limit(const Budget& budget)
      : samples(std::numeric_limits<std::uint64_t>::max()),
        seconds(std::numeric_limits<double>::infinity()) {
    if (const auto* count = std::get_if<SampleBudget>(&budget)) samples = count->samples;
    if (const auto* time = std::get_if<TimeBudget>(&budget)) seconds = time->seconds;
  }
  double fraction(std::uint64_t done, double elapsed) const {
    return std::max(static_cast<double>(done) / static_cast<double>(samples), elapsed / seconds);
  }
};

int bins_of(std::span<const int> shape) {
  int bins = 1;
  for (const int extent : shape) bins *= extent;
  return bins;
}

}  // namespace

Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make) {
  Run run(session);
  const Limit limit(session.budget);
  const int bins = bins_of(shape);
  const std::uint64_t per_unit = samples_per_unit(bins);
  SampleFilm film(bins, max_vertices);
  std::vector<Slot> slots;
  for (int i = 0; i < slots_of(run); ++i) slots.push_back({make(), {bins, max_vertices}});

  const auto count_of = [&](std::uint64_t unit) {
    return std::min(per_unit, limit.samples - unit * per_unit);
  };
  const auto work = [&](std::uint64_t unit, int index) {
    Slot& slot = slots[static_cast<std::size_t>(index)];
    slot.film.clear();
    Rng rng(session.seed, Purpose::estimate, 0);
    for (std::uint64_t i = 0; i < count_of(unit); ++i) {
      rng.start(unit * per_unit + i);
      slot.sample(rng, slot.film);
      slot.film.end_sample();
    }
  };
  const auto merge = [&](std::uint64_t, int index) {
    film.merge(slots[static_cast<std::size_t>(index)].film);
    run.report(
        {limit.fraction(film.samples(), run.seconds()), film.samples(), run.seconds(), "sampling"});
  };
  const auto more = [&](std::uint64_t unit) {
    return !run.is_interrupted() && (unit == 0 || run.seconds() < limit.seconds);
  };
  const std::uint64_t units = (limit.samples - 1) / per_unit + 1;
  run_in_order(run, {units, more, work, merge});

  Rendering rendering{.method = method,
                      .samples = film.samples(),
                      .seed = session.seed,
                      .threads = run.threads(),
                      .seconds = run.seconds(),
                      .film = film.estimate(shape)};
  rendering.complete =
      std::isinf(limit.seconds) ? film.samples() == limit.samples : !run.is_interrupted();
  return rendering;
}

}  // namespace wander
