// What a trial's chains and samples found, item by item, so that afterwards it can be asked with any border
// and any worth of bins (bin_worth.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/joined_path.h"
#include "core/path.h"
#include "mlt/seeds/seeds.h"

namespace wander {

struct TrialLog {
  // A path of a sample: what of its light w f/p falls on a bin, and l, its own or that of the whole
  // sample (partition.h).  In a space with a map v all of f is of f v, here as of deposits and states.
  struct Found {
    std::uint32_t sample;
    int bin;
    double light, ratio;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(sample, bin, light, ratio);
    }
  };
  struct Deposit {
    int bin;
    double weight, ratio;
  };
  // Of a chain after a step.
  struct State {
    int bin;
    std::size_t stratum;
    double ratio;
  };
  std::uint32_t samples = 0;
  std::vector<Found> found{};  // sample by sample
  std::vector<Deposit> deposits{};
  std::vector<State> states{};
};

// Of one group: its log, and the light that a state of each stratum stands for.
struct TrialFindings {
  const TrialLog* log;
  double rays;  // of its samples
  std::vector<double> light_of_states{};
};

// Keeps what samples find.  `R` says what l is of: of a path, or of a whole sample.
template <class Space, Ratios R>
class SampleLogger {
 public:
  using W = typename Space::Universe;

  explicit SampleLogger(TrialLog& log) : log_(&log), begin_(log.found.size()) {}

  void found(const JoinedPath<W>&, const FoundPath& path) {
    log_->found.push_back({log_->samples, path.bin, path.measure, path.measure});
  }
  void end_sample(double total) {
    if constexpr (R == Ratios::of_samples)
      for (TrialLog::Found& path : std::span(log_->found).subspan(begin_)) path.ratio = total;
    begin_ = log_->found.size();
    ++log_->samples;
  }

 private:
  TrialLog* log_;
  std::size_t begin_;  // of the sample under way
};

}  // namespace wander
