// The toss: each sample is one of path tracing or one of light tracing, as a coin falls.  Each of
// the two has the film as its expectation, and so has the toss.
#pragma once

#include "lab/estimate.h"
#include "lab/sample_film.h"
#include "lab/stage.h"

namespace wander {

struct Toss {
  static constexpr const char* name = "toss";

  template <World W>
  static std::unique_ptr<LiveRun> make(const Stage<W>& stage) {
    using Space = Transport<W>;
    const auto space = std::make_shared<const Space>(stage.scene, Roulette::by_albedo);
    const auto sampler_of = [&](const Estimator& method) {
      return PathSampler<Space>(*space, method.techniques, method.heuristic);
    };
    const auto make_sampler = [&]() -> FilmSampler {
      return [space, from_sensor = sampler_of(path_tracing),
              from_light = sampler_of(light_tracing)](Rng& rng, Contributions& found) mutable {
        PathSampler<Space>& sampler = rng.uniform() < 0.5 ? from_sensor : from_light;
        sampler.sample(rng, [&](const Path<W>& path, int s, double weighted) {
          found.push_back({path.size(), s, space->bin(path), weighted});
        });
      };
    };
    return make_sample_run(name, stage.scene.resolution(), stage.scene.max_vertices(),
                           stage.job.dials().film, stage.execution, make_sampler);
  }
};

}  // namespace wander
