#include "lab/estimate.h"

#include <array>
#include <stdexcept>

#include "lab/drive.h"
#include "lab/sample_film.h"

namespace wander {

namespace {

constexpr TechniqueSet from_sensor{.most_light = 1, .fewest_sensor = 1};
constexpr TechniqueSet from_light{.fewest_light = 1, .most_sensor = 1};
constexpr TechniqueSet only_from_sensor{.most_light = 0};
constexpr TechniqueSet only_from_light{.most_sensor = 0};

const char* name_of(MethodId id) { return method_of(id).name.data(); }

}  // namespace

std::span<const Estimator> estimators() {
  static const std::array known{
      Estimator{name_of(MethodId::pt), from_sensor, Roulette::by_albedo, Heuristic::power},
      Estimator{name_of(MethodId::lt), from_light, Roulette::by_albedo, Heuristic::power},
      Estimator{name_of(MethodId::bdpt), all_techniques, Roulette::by_albedo, Heuristic::power},
      Estimator{name_of(MethodId::pt_naive), only_from_sensor, Roulette::off, Heuristic::balance},
      Estimator{name_of(MethodId::lt_naive), only_from_light, Roulette::off, Heuristic::balance}};
  return known;
}

const Estimator& estimator_of(const Method& method) {
  for (const Estimator& estimator : estimators())
    if (method.name == estimator.name) return estimator;
  throw std::logic_error("a method without independent samples");
}

template <World W>
std::unique_ptr<LiveRun> make_estimate(const Scene<W>& scene, const Estimator& estimator,
                                       const FilmLayout& layout, const Run& execution) {
  using Space = Transport<W>;
  const auto transport = std::make_shared<const Space>(scene, estimator.roulette);
  const auto make = [&]() -> FilmSampler {
    return [transport,
            sampler = PathSampler<Space>(*transport, estimator.techniques, estimator.heuristic)](
               Rng& rng, Contributions& found) mutable {
      sampler.sample(rng, [&](const Path<W>& path, int s, double weighted) {
        found.push_back({path.size(), s, transport->bin(path), weighted});
      });
    };
  };
  return make_sample_run(estimator.name, scene.resolution(), scene.max_vertices(), layout,
                         execution, make);
}

template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session) {
  Run execution(session);
  return drive(*make_estimate(scene, estimator, {}, execution), execution);
}

template std::unique_ptr<LiveRun> make_estimate(const Scene<Flatland>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<Flatland>&, const Estimator&, const Session&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<FlatlandSingle>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<FlatlandSingle>&, const Estimator&, const Session&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<Spaceland>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<Spaceland>&, const Estimator&, const Session&);

}  // namespace wander
