// One film from independent samples and chains: a partition of path space.
//
// A bidirectional sample finds paths with intensity p̄(z) = Σ_{s,t} p_{s,t}(z).  With l = f/p̄ and any
// c > 0 that does not depend on what it weighs, the light on a bin is
//
//   I_j = ∫_j f w_B + ∫_j f w_M,   w_B = c / (l + c),   w_M = l / (l + c).
//
// The first part is left to the samples: a path that one finds deposits l w_B < c, so that no sample
// is a firefly.  The second is left to the chains, whose deposits count w_M times.  c → ∞ is
// bidirectional path tracing, c → 0 the film of the chains alone.  docs/pooled-film.md derives it.
//
// On an image the chains' part may have an end C, too,
//   w_M = l / (l + c) · C / (l + C):
// where chains are caught wherever they come beyond it they know of that light what their seeds did, and samples
// know it better.
//
// Relatives: Kelemen's weights of large steps (primary_estimator.h); selectively metropolised light
// transport [Bitterli and Jarosz 2019]; the balance heuristic [Veach and Guibas 1995].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mlt/seeds/ratio_histogram.h"

namespace wander {

struct Partition {
  double c = 0;
  double end = std::numeric_limits<double>::infinity();  // C

  bool has_end() const { return std::isfinite(end); }
  double of_samples(double l) const {
    return has_end() ? 1 - of_chains(l) : c > 0 ? c / (l + c) : 0;
  }
  double of_chains(double l) const {
    const double beyond = c > 0 ? l / (l + c) : 1;
    return has_end() ? beyond * (end / (l + end)) : beyond;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(c, end);
  }
};

// Which paths samples take, and how many samples there are.
struct Pooling {
  Partition partition{};
  double samples_per_step = 0;
  double steps_per_draw = 0;  // τ
  double cost_of_sample = 0;  // in steps

  template <class Archive>
  void serialize(Archive& archive) {
    archive(partition, samples_per_step, steps_per_draw, cost_of_sample);
  }
};

// τ where no chains have told it.
inline constexpr double usual_steps_per_draw = 16;
// How many rays of samples are taken to cost as much as a step: in the plane; in space, where by the seed
// passes of ten scenes it was 2.4 to 4.1, and samples beside the chains cost somewhat less.
inline constexpr double rays_per_step = 5, rays_per_step_in_space = 4;

// What a pilot knows (pilot.h): a small run that is no part of the film.
struct Pilot {
  // Of its samples, l of what they found, and how many rays they took.
  RatioHistogram found{};
  double samples = 0, rays = 0;
  // The same, but for the path that has most, of an image: each as often as its bin is worth (bin_worth.h).
  std::optional<RatioHistogram> weighed{};
  // Of each of its chains, l of the states, weighed in the same way; and how many steps it has made.
  std::vector<RatioHistogram> chains{};
  double steps_per_chain = 0;
  double steps_in_all = 0;  // of each chain, when the pilot ends
  double rays_per_step = wander::rays_per_step;
  // Of the run, its steps for each sample of its seed pass.  None: all samples are of it, one for each 1/ρ steps.
  std::optional<double> steps_per_seed = 0;
  // Of the run, as many samples for each step as it has in its seed pass at least.
  double seeds_per_step = 0;
  // With a border, how many steps tell as much as one independent draw: of where the chains' part of the
  // light lies on the film; and of how large it is in all, which unknown moves b.
  struct Border {
    double c;
    double end = std::numeric_limits<double>::infinity();
    double steps_per_draw = usual_steps_per_draw, steps_per_draw_of_total = usual_steps_per_draw;
    double unvisited = 0;  // light of the chains' part that chains do not come to, over b
    double together = 1;   // χ, how much more samples vary than their paths alone
    // How evenly chains share what they know of that light, and how much they differ, whichever is more
    // (deposit_spread.h): where few came to it, and only these differ, it is they who speak.
    double evenness = 1;

    Partition side() const { return {c, end}; }
  };
  std::vector<Border> borders{};

  // Of all chains.
  RatioHistogram states() const;
  // Without what one sample alone found.
  RatioHistogram light_of_samples() const;
  double b() const;
  // (Σ l)² / Σ l²: how many samples carry the estimate of b.
  double effective_samples() const;
};

// The borders that are tried; beyond the last there is no light, and all is left to samples.
std::vector<double> borders_around(double b);
// The same, and of an image those that have an end, after them.
enum class FilmKind { curve, image };
std::vector<Partition> partitions_around(double b, FilmKind film);

// With ρ samples per step, or those of a seed pass that is longer, the variance of the film, summed over all bins by
// what they are worth (bin_worth.h) and times the steps, is about
//   V(ρ, c) = A + b² (τ E_π[w_M²] + n u) + k b E_π[φ² l w_M²] + V_b(ρ),   A = χ b E_π[l w_B²] / ρ:
// the samples' part, whose paths come together, so that it is χ times that of single paths; the chains', who for the share u of light that they do not come to have one draw
// in the n steps of each; that of their seeds, for of what a chain deposits beyond a ratio l the share
// φ(l) = τ(l)/n lies where it began, with the τ of the border there, and of that light it knows what the
// samples of the seed pass do, one for each k steps; and that of b itself, which moves all bins.  b is
// that of the bridge (bridge.h), which chooses its own balance: V_b is the least of
//   b² (A + τ' b² Var_π(w_M)) / (bins (∫ f w_B)²)
// over all borders.  E_π is over all light, as what the pilot saw says of it (light_by_ratio.h).  Were
// the steps n_M = n_B / (ρ τ) independent draws, the best border would be that of the balance
// heuristic, c = b n_B / n_M = b ρ τ.  But τ depends on c: chains that know easy light well may be
// slow to come to the hard.
//
// Chains are known by few excursions of few of them, and where V errs it is too small: it knows nothing of what they have
// not met.  What samples leave unknown is known.  So of all ρ and c whose V (1 + ρ κ), with κ the cost of a sample in
// steps, is no more than a quarter above the least, those with the largest c are taken, up to 2¹⁰ b, or up to the
// border beyond all light if the least lies beyond 2¹⁰ b, where next to nothing is left to chains.  ρ is of the powers of
// two between these, but no more than with which samples take `most_cost` times as long as steps: little is lost where
// time is what is given, and who gives a number of steps does not wait for much more than these.
inline constexpr double fewest_samples_per_step = 1.0 / 16, most_samples_per_step = 64,
                        usual_most_cost = 32, most_cost_of_given_steps = 4;
Pooling best_pooling(const Pilot& pilot, std::size_t bins, double most_cost = usual_most_cost);

// Of a pilot whose chains were asked.  They may promise a multiple of what they keep: so all light that was seen is
// left to samples, if that takes no more than two and a half times the least work.  What was not seen is the chains',
// who may find it: the border is the least from 2¹⁰ b beyond which there is hardly any light (a thousandth), or else
// the largest before it, from 2¹⁰ b, with which it takes no more.  If there is none it is the best pooling.
//
// All this is said of borders without an end, beyond which chains may be caught.  With an end chains have next to nothing
// of what catches them, and keep what they promise: if what leaves all that was seen to samples takes a quarter more work than the
// best of these, or this no more than two and a half times the work of what does not, then of all with an end and no more
// than a quarter above the best that with the widest is taken, whose samples have the fewest fireflies.
Pooling cautious_pooling(const Pilot& pilot, std::size_t bins, double most_cost = usual_most_cost);
// Is all that lies below the largest border that is chosen without need the samples'?
bool is_left_to_samples(const Pooling& pooling, double b);

// What samples alone decide: with chains of which one step in sixteen told as much as a draw, nothing would take a
// twentieth less work than 2¹⁰ b does, which leaves nearly all to samples.  Of the ρ that with it are as good as the
// best, to a fiftieth, the smallest, for what is rare is the chains'.  None: chains have to be asked, or better samples.
std::optional<Pooling> pooling_of_easy_light(const Pilot& samples, std::size_t bins,
                                             double most_cost = usual_most_cost);

// The best c for so many samples per step; nothing is left to samples where the pilot found no light.
Pooling pooling(const Pilot& pilot, double samples_per_step, std::size_t bins);

// Did enough of its samples find light to choose by?  And to choose well?
bool is_telling(const Pilot& pilot);
bool tells_enough(const Pilot& pilot);
// Did hardly any of many?  A pilot whose samples are dear has few.
inline constexpr std::uint64_t most_samples_of_a_pilot = 1 << 15;
bool finds_rare_light(const Pilot& pilot);

// How many steps tell as much as one draw, if the means of chains of n steps have a variance of so
// many times that of one draw.  Where autocorrelation falls as e^(-2 i/τ) that is, with x = 2 n/τ,
//   R = 2 (x - 1 + e^(-x)) / x²,
// which is τ/n where chains are long, and 1 where they have not moved.  Between 1 and 4 n.
double steps_per_draw(double variance_ratio, double steps);

}  // namespace wander
