// The seed pass: independent bidirectional samples that estimate b and give every chain its first
// path [Veach 1997, 11.3.1; Veach and Guibas 1997].
//
// Chains come in independent groups, each with a slice of the samples of its own.  In a slice,
//   b_g = mean of Σ w f/p,   seeds drawn from its paths in proportion to w f / p,
// and b_g times the mean of what its chains deposit is unbiased for any length of the chains.  Seeds are found in one sweep by weighted reservoirs; only the sample's index
// is kept, and the path is made again from its random numbers.
//
// In a space with a map v (importance_map.h) seeds and the b_g of their chains are of f v; b, the film and the lengths are
// of light, f.  A sample is one of light, and v a factor of each of its paths, once its bin is known.
//
// When seeds are drawn samples may go on beside the chains: they are further evidence of b and of the
// film, but b_g stays that of the samples that the seeds came from.
#pragma once

#include <stdexcept>

#include "core/bins_of_sample.h"
#include "core/film_layout.h"
#include "core/path_class.h"
#include "core/path_sampler.h"
#include "mlt/primary/primary_numbers.h"
#include "mlt/seeds/ratio_histogram.h"
#include "mlt/seeds/seed_tally.h"
#include "mlt/seeds/seeds.h"
#include "statistics/sum.h"

namespace wander {

class SeedReplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What normalization asks of a slice beside its tally: the ratios l = f / p̄ of what it found, by
// stratum (seeds.h), where by the balance heuristic w f/p is l, each as often as it shows light; and of the samples with seeds, Σ w f/p
// of each cell of the film's raster and of each class.
struct SeedEvidence {
  std::vector<RatioHistogram> ratios;
  std::vector<Sum> film;
  ClassTable classes;
  std::vector<Sum> by_class = room_for_classes<Sum>();

  SeedEvidence(int strata, std::size_t cells)
      : ratios(static_cast<std::size_t>(strata)), film(cells) {}

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ratios, film, classes, by_class);
  }
};

// What watches samples: those of the seed pass that show nothing.
struct NoWatcher {
  template <class W>
  void found(const JoinedPath<W>&, const FoundPath&) {}
  // What is measured of all its paths.
  void end_sample(double) {}
};

// One group's slice of the seed pass.  `Seeds` is what it draws for the chains (seeds.h).
template <class Space, class Seeds = PathSeeds>
class SeedSlice {
 public:
  using W = typename Space::Universe;

  // `count`: how many seeds.
  SeedSlice(const Space& space, std::uint64_t seed, int group, int count,
            const FilmLayout& layout = {})
      : space_(&space),
        sampler_(measuring_light(space).with(Seeds::roulette), all_techniques, Heuristic::balance),
        bins_(space),
        samples_(seed, Purpose::seed_pass, static_cast<std::uint32_t>(group)),
        seeds_(Rng(seed, Purpose::resample, static_cast<std::uint32_t>(group)), count),
        tally_(space.max_vertices()),
        of_seeds_(space.max_vertices()),
        raster_(layout.raster(space.scene().film_shape())),
        evidence_(Seeds::strata(space.max_vertices()), raster_.cells()),
        by_length_(tally_.sum.size()) {}

  template <class Watcher = NoWatcher>
  void run(std::uint64_t count, Watcher&& watcher = {}) {
    for (std::uint64_t i = 0; i < count; ++i) add_sample(watcher);
  }
  // The seeds are drawn; samples after this are no candidates.
  void end_seeds() {
    if (!takes_seeds_) return;
    takes_seeds_ = false;
    of_seeds_ = tally_;
  }

  // Of all samples.
  const SeedTally& tally() const { return tally_; }
  // Of those that the seeds were drawn from.
  const SeedTally& seed_tally() const { return takes_seeds_ ? tally_ : of_seeds_; }
  const SeedEvidence& evidence() const { return evidence_; }
  bool found_light() const { return seed_tally().total.value() > 0; }
  const Seed& seed(int chain) const { return seeds_[chain]; }

  // Between two samples.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(seeds_, tally_, takes_seeds_, of_seeds_, evidence_);
  }

  // The path of a seed, whose weight must come out as it was, bit for bit; measured as one of the
  // chains' space.
  Path<W> replay(const Seed& seed, int max_vertices) {
    Path<W> path(max_vertices);
    bool found = false;
    samples_.start(seed.sample);
    sampler_.sample_only(seed.technique, seed.vertices - seed.technique, samples_,
                         [&](const Path<W>& x, int, double light) {
                           if (light * importance(*space_, space_->bin(x)).v != seed.weight) return;
                           path = x;
                           found = true;
                         });
    if (!found) throw SeedReplayError("a seed path could not be replayed from its random numbers");
    for (int i = 0; i < path.size(); ++i) space_->evaluate(path, i);
    return path;
  }

  // The random numbers of a seed's sample, at their places; without roulette.
  PrimaryNumbers numbers(const Seed& seed, const PrimaryLayout<W>& layout) {
    PrimaryNumbers numbers(layout.of_samples());
    samples_.start(seed.sample);
    PrimarySource source(layout, [&](std::size_t k) {
      const double u = samples_.uniform();
      numbers.set(k, u);
      return u;
    });
    sampler_.draw(source);
    return numbers;
  }

 private:
  template <class Watcher>
  void add_sample(Watcher& watcher) {
    const std::uint64_t index = tally_.samples++;
    samples_.start(index);
    seeds_.start(index);
    bins_.begin();
    double measure = 0, light = 0;
    const std::uint64_t rays = sampler_.rays();
    sampler_.sample(samples_, [&](const JoinedPath<W>& x, int s, double of_path) {
      const int bin = bins_(x, s);
      const Importance of_bin = importance(*space_, bin);
      const FoundPath found{bin, s, of_path * of_bin.v, of_path};
      measure += found.measure;
      light += found.light;
      by_length_[static_cast<std::size_t>(x.size()) - 2] += found.light;
      if (x.size() > 2 && (s == 0 || s == x.size())) tally_.ends_met.add(found.light);
      if constexpr (Seeds::ratios == Ratios::of_paths)
        evidence_.ratios[Seeds::stratum(x.size())].add(found.measure, of_bin.light_of_measure);
      if (takes_seeds_) keep(x, found, index);
      watcher.found(x, found);
    });
    tally_.rays += sampler_.rays() - rays;
    watcher.end_sample(measure);
    if (measure == 0) return;
    if constexpr (Seeds::ratios == Ratios::of_samples) evidence_.ratios[0].add(measure);
    if (takes_seeds_) seeds_.offer_sample({.sample = index, .weight = measure});
    tally_.total += light;
    tally_.measure += measure;
    tally_.total_squares += light * light;
    for (std::size_t k = 0; k < by_length_.size(); ++k) {
      if (by_length_[k] == 0) continue;
      tally_.sum[k] += by_length_[k];
      tally_.squares[k] += by_length_[k] * by_length_[k];
      by_length_[k] = 0;
    }
  }

  // A path that may become a seed.
  void keep(const JoinedPath<W>& x, const FoundPath& found, std::uint64_t sample) {
    seeds_.offer_path({sample, x.size(), found.technique, found.measure});
    if (tally_.techniques.has(x.size()))
      tally_.techniques.row(x.size())[static_cast<std::size_t>(found.technique)] += found.measure;
    evidence_.film[raster_.cell(found.bin)] += found.light;
    *entries_of(evidence_.by_class, evidence_.classes.index(path_class_of(x))) += found.measure;
  }

  const Space* space_;
  PathSampler<Space> sampler_;
  BinsOfSample<Space> bins_;
  Rng samples_;
  Seeds seeds_;
  SeedTally tally_;
  bool takes_seeds_ = true;
  SeedTally of_seeds_;  // once they are drawn
  Raster raster_;
  SeedEvidence evidence_;
  std::vector<double> by_length_;  // of the sample under way
};

}  // namespace wander
