// The test image of two-stage Metropolis light transport [Veach and Guibas 1997], and the importance map of the second
// stage (importance_map.h).
//
// A chain whose target is f comes to a pixel as often as it is bright, so what it knows of dark ones is little; and a
// picture is looked at pixel by pixel.  With the target f v,
//   v ∝ 1 / (I + ε Ī),
// it comes about as often to all of which light is worth speaking.  I is that of blocks of the image, as few independent
// samples know it; where it errs, chains spend more or less time there, and nothing is biased.
//
// The map must not depend on what it weighs, and runs that are merged must measure alike: its samples have random
// numbers of their own, the same in all runs of a scene, and are as many.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/importance_map.h"
#include "core/path_sampler.h"

namespace wander {

class TestImage {
 public:
  explicit TestImage(std::span<const int> resolution);

  // A path that a sample found: w f/p.
  void add(int bin, double light) { found_.push_back({raster_.cell(bin), light}); }
  // Once all samples are made; such that E_π[v] over the test image is one.  None where all is dark.
  std::optional<ImportanceMap> importance(std::uint64_t samples) const;

 private:
  struct Found {
    std::size_t cell;
    double light;
  };
  static constexpr std::size_t most_blocks = 1 << 10;
  static constexpr double darkest = 0.05;  // ε
  // A path counts no more than so many times what a sample does in the mean: one that is brighter says more of itself
  // than of the block.
  static constexpr double brightest = 16;

  std::vector<double> light_of_blocks(std::uint64_t samples) const;

  Raster raster_;
  std::vector<Found> found_;
};

// How many samples, or as many as take so many rays.
inline constexpr std::uint64_t samples_of_test_image = 1 << 15, rays_of_test_image = 1 << 19;

// Of an image, as a space without a map sees it; of a curve none.  `is_interrupted` is asked now and then,
// and if it says so there is none.
template <class Space, class Interrupted>
std::optional<ImportanceMap> importance_of_test_image(const Space& space,
                                                      Interrupted&& is_interrupted) {
  const auto resolution = space.scene().resolution();
  if (resolution.size() < 2) return std::nullopt;
  PathSampler<Space> sampler(space.with(Roulette::by_albedo), all_techniques, Heuristic::balance);
  Rng random(0, Purpose::test_image, 0);
  TestImage image(resolution);
  std::uint64_t samples = 0;
  for (; samples < samples_of_test_image && sampler.rays() < rays_of_test_image; ++samples) {
    if (samples % 256 == 0 && is_interrupted()) return std::nullopt;
    random.start(samples);
    sampler.sample(
        random, [&](const auto& x, int, double light) { image.add(space.bin(x.ends()), light); });
  }
  return image.importance(samples);
}

}  // namespace wander
