#include "lab/estimate.h"

#include <vector>

#include "core/bins_of_sample.h"
#include "lab/drive.h"
#include "lab/sample_film.h"

namespace wander {

std::span<const Estimator> estimators() {
  static const auto known = [] {
    std::vector<Estimator> found;
    for (const Method& method : methods())
      if (method.estimator != nullptr) found.push_back(*method.estimator);
    return found;
  }();
  return known;
}

template <World W>
std::unique_ptr<LiveRun> IndependentSamples::make(const Stage<W>& stage) {
  return make_estimate(stage.scene, *stage.job.method().estimator, stage.job.dials().film,
                       stage.execution);
}

template <World W>
std::unique_ptr<LiveRun> make_estimate(const Scene<W>& scene, const Estimator& estimator,
                                       const FilmLayout& layout, const Run& execution) {
  using Space = Transport<W>;
  const auto transport = std::make_shared<const Space>(scene, estimator.roulette);
  const auto make = [&]() -> FilmSampler {
    return [transport, bins = BinsOfSample<Space>(*transport),
            sampler = PathSampler<Space>(*transport, estimator.techniques, estimator.heuristic)](
               Rng& rng, Contributions& found) mutable {
      bins.begin();
      sampler.sample(rng, [&](const JoinedPath<W>& path, int s, double weighted) {
        found.push_back({path.size(), s, bins(path, s), weighted});
        if constexpr (W::channels > 1) found.back().tint = path.colour().colour;
      });
    };
  };
  return make_sample_run({estimator.name, found_by_chance(scene, estimator.must_meet)},
                         scene.film_shape(), scene.max_vertices(), layout, execution, make);
}

template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session) {
  Run execution(session);
  return drive(*make_estimate(scene, estimator, {}, execution), execution);
}

template std::unique_ptr<LiveRun> IndependentSamples::make(const Stage<Flatland>&);
template std::unique_ptr<LiveRun> IndependentSamples::make(const Stage<FlatlandSingle>&);
template std::unique_ptr<LiveRun> IndependentSamples::make(const Stage<Spaceland>&);
template std::unique_ptr<LiveRun> IndependentSamples::make(const Stage<SpacelandColour>&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<Flatland>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<Flatland>&, const Estimator&, const Session&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<FlatlandSingle>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<FlatlandSingle>&, const Estimator&, const Session&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<Spaceland>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<Spaceland>&, const Estimator&, const Session&);
template std::unique_ptr<LiveRun> make_estimate(const Scene<SpacelandColour>&, const Estimator&,
                                                const FilmLayout&, const Run&);
template Rendering estimate(const Scene<SpacelandColour>&, const Estimator&, const Session&);

}  // namespace wander
