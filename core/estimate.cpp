#include "core/estimate.h"

#include <array>
#include <memory>

#include "core/film.h"
#include "core/run.h"

namespace wander {

namespace {

constexpr TechniqueSet from_sensor{.most_light = 1, .fewest_sensor = 1};
constexpr TechniqueSet from_light{.fewest_light = 1, .most_sensor = 1};
constexpr TechniqueSet only_from_sensor{.most_light = 0};
constexpr TechniqueSet only_from_light{.most_sensor = 0};

constexpr std::array<Estimator, 5> known_estimators{{
    {"pt", from_sensor, Roulette::by_albedo, Heuristic::power},
    {"lt", from_light, Roulette::by_albedo, Heuristic::power},
    {"bdpt", all_techniques, Roulette::by_albedo, Heuristic::power},
    {"pt-naive", only_from_sensor, Roulette::off, Heuristic::balance},
    {"lt-naive", only_from_light, Roulette::off, Heuristic::balance},
}};

// Samples per unit of work: enough to hide the cost of merging a film, whatever the threads.
std::uint64_t samples_per_unit(int bins) {
  return std::max<std::uint64_t>(4096, static_cast<std::uint64_t>(bins) / 4);
}

// What one unit works in.
template <World W>
struct Slot {
  PathSampler<Transport<W>> sampler;
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

}  // namespace

std::span<const Estimator> estimators() { return known_estimators; }

template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session) {
  Run run(session);
  const Limit limit(session.budget);
  const Transport<W> transport(scene, estimator.roulette);
  const std::uint64_t per_unit = samples_per_unit(scene.bins());
  SampleFilm film(scene.bins(), scene.max_vertices());
  std::vector<Slot<W>> slots;
  for (int i = 0; i < slots_of(run); ++i)
    slots.push_back({{transport, estimator.techniques, estimator.heuristic},
                     {scene.bins(), scene.max_vertices()}});

  const auto count_of = [&](std::uint64_t unit) {
    return std::min(per_unit, limit.samples - unit * per_unit);
  };
  const auto work = [&](std::uint64_t unit, int index) {
    Slot<W>& slot = slots[static_cast<std::size_t>(index)];
    slot.film.clear();
    Rng rng(session.seed, Purpose::estimate, 0);
    for (std::uint64_t i = 0; i < count_of(unit); ++i) {
      rng.start(unit * per_unit + i);
      slot.sampler.sample(rng, [&](const Path<W>& path, int s, double weighted) {
        slot.film.add(path.size(), s, transport.bin(path), weighted);
      });
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

  Rendering rendering{.method = estimator.name,
                      .samples = film.samples(),
                      .seed = session.seed,
                      .threads = run.threads(),
                      .seconds = run.seconds(),
                      .film = film.estimate(scene.resolution())};
  rendering.complete =
      std::isinf(limit.seconds) ? film.samples() == limit.samples : !run.is_interrupted();
  return rendering;
}

template Rendering estimate(const Scene<Flatland>&, const Estimator&, const Session&);
template Rendering estimate(const Scene<Spaceland>&, const Estimator&, const Session&);

}  // namespace wander
