// The test image of two-stage Metropolis light transport [Veach and Guibas 1997], and the importance map of the second
// stage (importance_map.h).
//
// A chain whose target is f comes to a pixel as often as it is bright, so what it knows of dark ones is little; and a
// picture is looked at pixel by pixel.  With the target f v,
//   v ∝ 1 / (I + ε Ī),
// it comes about as often to all of which light is worth speaking.  I is what few independent samples know of the image;
// where it errs, chains spend more or less time there, and nothing is biased.
//
// Few samples find a path or none on most pixels, so blocks of them are asked, too, from the whole image down to blocks
// of which there are as many as a map has cells.  What is found on a block is taken to be a Poisson number of paths of a
// each, the light of a typical one, and what its parent says to be a prior that knows as much as m of these: a gamma
// distribution, with the mean of the posterior
//   I = (S + m a) / (1 + m a / I_parent),   a = Σ w² / Σ w,
// of all the light S = Σ w that was found there.  A block with many paths speaks for itself, and so does one with
// none where there should have been many; of others it is the neighbourhood.
//
// The map must not depend on what it weighs, and runs that are merged must measure alike: its samples have random
// numbers of their own, the same in all runs of a scene, and are as many.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/bins_of_sample.h"
#include "core/importance_map.h"
#include "core/path_sampler.h"

namespace wander {

class TestImage {
 public:
  explicit TestImage(std::span<const int> resolution);

  // A path that a sample found: w f/p.
  void add(int bin, double light) { found_.push_back({raster_.cell(bin), light}); }
  std::uint64_t paths() const { return found_.size(); }
  // Once all samples are made; such that E_π[v] over the test image is one.  None where all is dark.
  std::optional<ImportanceMap> importance(std::uint64_t samples) const;

 private:
  struct Found {
    std::size_t cell;
    double light;
  };
  static constexpr std::size_t most_cells = 1 << 14;
  static constexpr double darkest = 0.2;       // ε
  static constexpr double paths_of_prior = 8;  // m
  // A path counts no more than so many times what a sample does in the mean: one that is brighter says more of itself
  // than of the cell.
  static constexpr double brightest = 64;

  // Of the cells, what was found, over what a sample finds in the mean.
  struct Light {
    std::vector<double> of_cells;
    double of_path = 0;  // a
  };
  Light found(std::uint64_t samples) const;
  // Of the cells, what is believed, for each of their pixels.
  std::vector<double> believed(const Light& found) const;

  Raster raster_;
  std::vector<double> pixels_;  // of each cell, so many
  std::vector<Found> found_;
};

// How many paths, or as many as so many samples find, or so many rays.
struct LengthOfTestImage {
  static constexpr std::uint64_t paths = 1 << 16, samples = 1 << 17, rays = 1 << 20;
};

// Of an image, as a space without a map sees it; of a curve none.  `is_interrupted` is asked now and then,
// and if it says so there is none.
template <class Space, class Interrupted>
std::optional<ImportanceMap> importance_of_test_image(const Space& space,
                                                      Interrupted&& is_interrupted) {
  const auto resolution = space.scene().resolution();
  if (resolution.size() < 2) return std::nullopt;
  PathSampler<Space> sampler(space.with(Roulette::by_albedo), all_techniques, Heuristic::balance);
  Rng random(0, Purpose::test_image, 0);
  BinsOfSample<Space> bins(space);
  TestImage image(resolution);
  std::uint64_t samples = 0;
  const auto is_enough = [&] {
    using Enough = LengthOfTestImage;
    return image.paths() >= Enough::paths || samples >= Enough::samples ||
           sampler.rays() >= Enough::rays;
  };
  for (; !is_enough(); ++samples) {
    if (samples % 256 == 0 && is_interrupted()) return std::nullopt;
    random.start(samples);
    bins.begin();
    sampler.sample(random,
                   [&](const auto& x, int s, double light) { image.add(bins(x, s), light); });
  }
  return image.importance(samples);
}

}  // namespace wander
