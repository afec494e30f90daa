// A run is a value that goes on: it can be asked for more at any time, looked at, and kept in a
// file.  Budgets, the clock, interruption and checkpoints are no part of it (drive.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>

#include "lab/findings.h"
#include "mlt/run/chain_settings.h"
#include "records/rendering.h"

namespace cereal {
class BinaryInputArchive;
class BinaryOutputArchive;
}  // namespace cereal

namespace wander {

// What the seed pass of a run has found so far.
struct SeedPass {
  std::uint64_t slices = 1;   // each has as many samples as the others
  std::uint64_t samples = 0;  // of all slices
  std::uint64_t rays = 0;     // that they took
  bool found_light = false;
  double relative_error = 0;  // of the constant; of use if light was found

  std::uint64_t of_each() const { return samples / slices; }
  // How much has been made of what is worth its cost where no share of the budget asks for more.
  double fraction_of_costs() const {
    constexpr double fewest_of_slice = 8;
    return std::min(static_cast<double>(rays) / static_cast<double>(ChainSettings::most_rays),
                    static_cast<double>(of_each()) / fewest_of_slice);
  }
  bool is_costly() const { return fraction_of_costs() >= 1; }
};

class LiveRun {
 public:
  virtual ~LiveRun() = default;

  // Independent samples have no seed pass: these are for chains, until start().
  virtual bool takes_seeds() const { return false; }
  virtual ChainSettings settings() const { return {}; }
  // Before the first sample: decides what the pilot of a run decides.
  virtual void prepare() {}
  // Of the seed pass, as --seed-share says, or as it was decided.
  virtual double seed_share() const { return 0; }
  virtual SeedPass seeds() const { return {}; }
  virtual void seed(std::uint64_t /*of each slice*/) {}
  virtual std::uint64_t seed_stride() const {
    return 1;
  }  // of each slice, worth the trouble of one seed()
  // Ends the seed pass; throws NoLightFound.
  virtual void start(int /*chains of each group*/) {}

  // So many more samples, or fewer if the run is interrupted.  Independent samples give the same
  // bits in whatever strides they are made; chains if the strides are the same, for they share the
  // sums of their group and take turns.
  virtual void advance(std::uint64_t samples) = 0;
  // The same for a budget of time: all threads end together, and where the strides and parts end
  // shows in the last bits.
  virtual void advance_freely(std::uint64_t samples) { advance(samples); }
  virtual std::uint64_t samples() const = 0;

  virtual std::uint64_t stride() const = 0;      // samples worth the trouble of one advance()
  virtual std::uint64_t first_look() const = 0;  // samples, if the budget is an error
  // No fewer samples, at which it is best to rest.
  virtual std::uint64_t rest(std::uint64_t samples) const { return samples; }

  // No more independent samples are made, and what these left unknown may be more than so much of the film.
  virtual bool lacks_samples(double /*relative error*/) const { return false; }

  // The film as it is, at little cost.
  virtual FilmEstimate preview() const = 0;
  // All that has come out, but for facts of the execution.
  virtual Rendering findings() const = 0;
  // About how long that takes: what a seed pass leaves of a budget of time, before it can be rehearsed.
  virtual double seconds_of_findings() const { return 0; }
  // The same, to be made of several runs: an empty value, and what this run adds to it.
  virtual std::unique_ptr<Findings> no_findings() const = 0;
  virtual void add_to(Findings& all) const = 0;  // of runs of the same job

  // Before load(), which cannot tell a want of memory from a state that is damaged: what the run takes, whatever its state is.
  virtual void make_room() {}
  // The whole state, into a run that was made of the same scene, method, dials and seed.
  virtual void save(cereal::BinaryOutputArchive& archive) const = 0;
  virtual void load(cereal::BinaryInputArchive& archive) = 0;

  // `watch` is told samples() now and then in a long advance(), by one thread at a time.
  void watch(std::function<void(std::uint64_t)> watcher) { watcher_ = std::move(watcher); }

 protected:
  void tell(std::uint64_t samples) const {
    if (watcher_) watcher_(samples);
  }

 private:
  std::function<void(std::uint64_t)> watcher_;
};

}  // namespace wander
