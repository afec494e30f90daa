#include "lab/estimate.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "lab/sample_film.h"

namespace wander {

namespace {

constexpr TechniqueSet from_sensor{.most_light = 1, .fewest_sensor = 1};
constexpr TechniqueSet from_light{.fewest_light = 1, .most_sensor = 1};
constexpr TechniqueSet only_from_sensor{.most_light = 0};
constexpr TechniqueSet only_from_light{.most_sensor = 0};

constexpr std::array<Estimator, 5> known_estimators{{
    {MethodId::pt, from_sensor, Roulette::by_albedo, Heuristic::power},
    {MethodId::lt, from_light, Roulette::by_albedo, Heuristic::power},
    {MethodId::bdpt, all_techniques, Roulette::by_albedo, Heuristic::power},
    {MethodId::pt_naive, only_from_sensor, Roulette::off, Heuristic::balance},
    {MethodId::lt_naive, only_from_light, Roulette::off, Heuristic::balance},
}};

}  // namespace

std::span<const Estimator> estimators() { return known_estimators; }

const Estimator& estimator_of(MethodId id) {
  const auto found = std::ranges::find(known_estimators, id, &Estimator::id);
  if (found == known_estimators.end())
    throw std::logic_error("a method without independent samples");
  return *found;
}

template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session) {
  const Transport<W> transport(scene, estimator.roulette);
  const auto make = [&]() -> FilmSampler {
    return [&, sampler =
                   PathSampler<Transport<W>>(transport, estimator.techniques, estimator.heuristic)](
               Rng& rng, SampleFilm& film) mutable {
      sampler.sample(rng, [&](const Path<W>& path, int s, double weighted) {
        film.add(path.size(), s, transport.bin(path), weighted);
      });
    };
  };
  return sample_film(estimator.name(), scene.resolution(), scene.max_vertices(), session, make);
}

template Rendering estimate(const Scene<Flatland>&, const Estimator&, const Session&);
template Rendering estimate(const Scene<FlatlandSingle>&, const Estimator&, const Session&);
template Rendering estimate(const Scene<Spaceland>&, const Estimator&, const Session&);

}  // namespace wander
