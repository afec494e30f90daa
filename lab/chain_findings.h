// What the groups of chains of a run found, or of several runs, and what is made of it: the film
// with its error bars, the normalization, statistics, diagnostics and doubts.
//
// The groups of several runs are groups of one.  If the runs are of different sizes, a group counts
// as its run's share of
//   1 / (1/steps + share/seeds)    [seeds: its independent samples, share: --seed-share]
// for the variance of a film falls as 1/steps of the chains and as 1/seeds, and both parts are taken
// to be equal where the seed pass has its usual length; of a pooled film as its share of
//   steps + κ seeds                [κ: what a sample costs in steps, by its pilot]
// for how many samples are made for each step is chosen so that the same work bears the same variance.
// What a group found has no part in it.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "lab/findings.h"
#include "lab/sample_doubts.h"
#include "mlt/run/adaptation.h"
#include "mlt/run/chain_settings.h"
#include "mlt/run/group_findings.h"
#include "mlt/run/large_film.h"
#include "mlt/run/normalization.h"
#include "mlt/run/pooled_film.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"

namespace wander {

class ChainFindings final : public Findings {
 public:
  // `none`: statistics of no steps, of the mutations that the chains have.  `must_meet`: what the samples of the method have to,
  // and its chains hardly do better.
  ChainFindings(std::string method, std::vector<int> shape, MutationStatistics none,
                const FoundByChance& must_meet);

  // The groups of one more run, in their order.
  template <class Groups>
  void add(const Groups& groups, const ChainSettings& settings,
           const std::optional<Adaptation>& adaptation) {
    Part part{settings, adaptation, GroupsFilm(settings.film.raster(shape_).shape()),
              groups.shared_light()};
    const std::uint64_t before = statistics_.steps();
    for (const auto& group : groups) {
      group->deliver(part.unbiased, statistics_, part.draws);
      part.chains += group->chains();
      part.seeds += group->tally().samples;
      groups_.push_back(group->findings());
    }
    if (is_pooled()) part.cost_of_sample = groups_.back().parts.front().pooling().cost_of_sample;
    part.steps = statistics_.steps() - before;
    parts_.push_back(std::move(part));
  }

  void keep() override;
  Rendering rendering() const override;

 private:
  // What of a run is not of its single groups.
  struct Part {
    ChainSettings settings;
    std::optional<Adaptation> adaptation;
    GroupsFilm unbiased;  // the mean of what each group says by its own slice; of a large film,
    std::optional<SharedLight> shared;  // whose pixels are here, on its raster
    int chains = 0;
    std::uint64_t seeds = 0, steps = 0;
    std::optional<double> cost_of_sample{};  // of a pooled film
    ChainDraws draws{};

    double size() const;
    double steps_per_chain() const;
  };

  std::vector<GroupFindings> weighed_groups() const;
  FilmEstimate unbiased() const;
  FilmEstimate unbiased(const Part& part) const;
  bool is_pooled() const { return !groups_.front().parts.empty(); }
  bool is_large() const { return parts_.front().shared.has_value(); }
  std::vector<SharedLight> shared_light() const;
  std::vector<int> groups_of_runs() const;
  FilmEstimate chains_film(NormalizationMethod method, const Constant& b,
                           std::span<const GroupFindings> groups) const;
  PooledFilm pooled_film(const Constant& b, std::span<const GroupFindings> groups) const;
  double relative_size(const Part& part) const;
  void normalize(Rendering& r) const;
  void judge(Rendering& r) const;
  std::vector<const Part*> long_enough() const;

  std::string method_;
  std::vector<int> shape_;
  MutationStatistics statistics_;
  FoundByChance must_meet_;
  std::vector<Part> parts_;
  std::vector<GroupFindings> groups_;  // of all parts, in their order
  std::deque<KeptFindings> kept_;      // what the first of them refer to
  std::deque<SharedFilms> kept_films_;
  std::deque<LargeSampleFilm> kept_samples_;
  std::deque<TotalFilm> kept_totals_;
};

}  // namespace wander
