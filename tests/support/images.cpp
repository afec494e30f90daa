#include "tests/support/images.h"

#include <cmath>
#include <cstddef>

#include "core/rng.h"
#include "tests/support/generator.h"

namespace wander::test {

namespace {

constexpr const char* scene = R"({ "format": "wanderlight-scene/1", "dimension": 3, "name": "room",
  "camera": { "type": "perspective" } })";

// Standard normal.
double noise(Rng& random) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += random.uniform();
  return sum;
}

// Darker to the right, a lamp in the middle, each channel with its own tint.
double light_at(double x, double y, int channel) {
  const double lamp = std::exp(-40 * ((x - 0.5) * (x - 0.5) + (y - 0.4) * (y - 0.4)));
  return (1 - 0.8 * x) * (1 - 0.2 * channel) * (0.2 + 0.3 * y) + 3 * lamp;
}

}  // namespace

RunRecord image_run(int width, int height, int channels, std::uint64_t seed) {
  RunRecord run;
  run.provenance = {"room",  scene, {"abc123", {{"tri.obj", "f00d"}}}, 3, "wander render room.json",
                    "0.1.0", {}};
  Rendering& rendering = run.rendering;
  rendering.method = "bdpt";
  rendering.samples = 2'000'000;
  rendering.seed = seed;
  rendering.seconds = 3.25;
  FilmEstimate& film = rendering.film;
  film.shape = channels == 1 ? std::vector{height, width} : std::vector{height, width, channels};
  film.degrees_of_freedom = 2e6;
  Rng random(seed, Purpose::test, 77);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        const double light = light_at((x + 0.5) / width, (y + 0.5) / height, c);
        const double error = 0.03 * std::sqrt(light);
        film.value.push_back(light + error * noise(random));
        film.standard_error.push_back(error);
        film.reliable.push_back((x + y) % 50 != 0);
      }
  return run;
}

RunRecord chains_image_run(int width, int height, int channels) {
  RunRecord run = image_run(width, height, channels);
  Rendering& rendering = run.rendering;
  rendering.method = "mlt";
  rendering.chains = 64;
  rendering.groups = 32;
  rendering.normalization.emplace();
  rendering.normalization->value = 0.6;
  rendering.normalization->standard_error = 0.002;
  rendering.film.by_length[2] = rendering.film.value;
  rendering.film.by_length[5] = rendering.film.standard_error;
  rendering.pooling = {{{0.5}, 0.25, 16, 3}, 32'768, 0.25};
  rendering.chains_film.emplace();
  rendering.chains_film->shape = rendering.film.shape;
  for (const double value : rendering.film.value)
    rendering.chains_film->value.push_back(1.5 * value);
  for (const double value : rendering.film.value)
    rendering.pooling->film_of_samples.push_back(0.25 * value);
  rendering.pooling->classes = {{"LDE", 0.75, 0.3}, {"LDSE", 0.25, 0.1}};
  MutationRecord& lens = rendering.mutations.emplace_back();
  lens.name = "lens";
  for (int i = 0; i < width * height; ++i) {
    lens.proposed_per_bin.push_back(i % 7 * 100);
    lens.acceptance_per_bin.push_back(i % 7 == 0 ? not_known : 1. / (1 + i % 7));
  }
  return run;
}

}  // namespace wander::test
