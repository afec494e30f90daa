// What the mutations did: an observer of steps, one per group of chains, merged in order.  Of each
// mutation it counts the outcomes, of all paths, by number of vertices, by class of the current
// path, and by place on the film; and measures how far it moves on the film, E[a |film(y) -
// film(x)|²] (the expected squared jump [Pasarica and Gelman 2010]), and what it costs.
#pragma once

#include <array>
#include <chrono>
#include <span>
#include <string_view>

#include "core/path_class.h"
#include "mlt/chain.h"
#include "mlt/watch/chains_record.h"
#include "mlt/watch/place_tallies.h"
#include "statistics/sum.h"

namespace wander {

// What statistics ask of a state of a chain.
struct Features {
  std::array<double, 2> film{};  // in [0,1)², or in [0,1) and 0
  int bin = 0, vertices = 0;
  PathClass path_class = other_class;

  bool is_dark() const { return vertices == 0; }  // a state that carries no light

  template <class Archive>
  void serialize(Archive& archive) {
    archive(film, bin, vertices, path_class);
  }
};

template <class Space>
std::array<double, 2> film_position(const Space& space, const Path<typename Space::Universe>& x) {
  std::array<double, 2> position{};
  const auto film = space.film_position(x);
  for (std::size_t axis = 0; axis < film.size(); ++axis)
    position[axis] = static_cast<double>(film[axis]);
  return position;
}

template <class Space>
Features features(const Space& space, const Path<typename Space::Universe>& x) {
  return {film_position(space, x), space.bin(x), x.size(), path_class_of(x)};
}

inline double squared_jump(const Features& x, const Features& y) {
  const double dx = y.film[0] - x.film[0], dy = y.film[1] - x.film[1];
  return dx * dx + dy * dy;
}

// One step of any chain, in the terms of the statistics.
struct Observation {
  int mutation = 0;
  Reason reason = Reason::none;
  double acceptance = 0;    // a(x→y)
  Features current{};       // of x
  double squared_jump = 0;  // a |film(y) - film(x)|²
};

template <class Space>
Observation observation(const Space& space, const Step<typename Space::Universe>& step,
                        const Features& current) {
  Observation seen{step.mutation, step.reason, step.acceptance, current};
  if (step.acceptance > 0)
    seen.squared_jump =
        step.acceptance * squared_jump(current, {.film = film_position(space, step.proposed)});
  return seen;
}

// How many refusals one chain has met in a row.
struct RejectionRuns {
  explicit RejectionRuns(std::size_t mutations) : of_mutation(mutations) {}
  std::uint64_t whole = 0;                 // steps since the state moved
  std::vector<std::uint64_t> of_mutation;  // proposals of each since one of its own was accepted

  template <class Archive>
  void serialize(Archive& archive) {
    archive(whole, of_mutation);
  }
};

class MutationStatistics {
 public:
  // A clock costs as much as a small mutation: one step in so many is measured.
  static constexpr std::uint64_t steps_per_measurement = 64;
  // Longer paths share the last entry of the outcomes by number of vertices.
  static constexpr int most_vertices = 65;

  // `places`: the cells of the film that are told apart; of none, what is counted by bin is not.
  MutationStatistics(std::span<const std::string_view> names, const Raster& places,
                     int max_vertices);

  // So that the next steps, this many, allocate nothing.
  void expect(std::uint64_t steps) { places_.expect(steps); }
  void observe(const Observation& seen, RejectionRuns& runs);

  // Makes a step of a chain, whose number it is; work() returns the index of the mutation.
  template <class Work>
  void timed(std::uint64_t step, Work&& work) {
    using Clock = std::chrono::steady_clock;
    const bool measured = step % steps_per_measurement == 0;
    const Clock::time_point start = measured ? Clock::now() : Clock::time_point{};
    const auto mutation = static_cast<std::size_t>(work());
    if (!measured) return;
    tallies_[mutation].measured_seconds +=
        std::chrono::duration<double>(Clock::now() - start).count();
    ++tallies_[mutation].measured;
  }

  void merge(const MutationStatistics& other);
  std::vector<MutationRecord> records() const;
  std::uint64_t steps() const;
  std::uint64_t steps(Reason reason) const;
  std::uint64_t longest_rejection_run() const { return longest_run_; }

  // Where the chains were: steps made from paths of a class, and how many groups ever met it.
  struct Visits {
    PathClass path_class = other_class;
    std::uint64_t steps = 0;
    int groups = 0;
  };
  std::vector<Visits> visits() const;

  // Into statistics of the same mutations.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(tallies_, places_, lengths_, classes_, by_length_, by_class_, groups_of_class_,
            longest_run_);
  }

 private:
  struct Outcomes {
    std::array<std::uint64_t, reason_names.size()> reasons{};
    Sum acceptance;

    void add(const Observation& seen);
    void merge(const Outcomes& other);
    std::uint64_t proposed() const;
    PathsRecord record() const;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(reasons, acceptance);
    }
  };
  struct Tally {
    std::string_view name;
    Sum squared_jump;
    std::uint64_t longest_run = 0;
    double measured_seconds = 0;
    std::uint64_t measured = 0;

    // All but the name.
    template <class Archive>
    void serialize(Archive& archive) {
      archive(squared_jump, longest_run, measured_seconds, measured);
    }
  };
  Outcomes& by_length(std::size_t length, std::size_t mutation) {
    return by_length_[length * tallies_.size() + mutation];
  }
  Outcomes& by_class(std::size_t index, std::size_t mutation) {
    return entries_of(by_class_, index, tallies_.size())[mutation];
  }
  Outcomes total(std::size_t mutation) const;
  std::size_t lengths() const { return lengths_; }
  MutationRecord record(std::size_t mutation) const;
  std::vector<PathsRecord> records_by_length(std::size_t mutation) const;
  std::vector<PathsRecord> records_by_class(std::size_t mutation) const;

  std::vector<Tally> tallies_;
  PlaceTallies places_;
  std::size_t lengths_;
  ClassTable classes_;
  std::vector<Outcomes> by_length_, by_class_;  // [length or class][mutation]
  std::vector<int> groups_of_class_;            // of those merged
  std::uint64_t longest_run_ = 0;
};

inline void MutationStatistics::Outcomes::add(const Observation& seen) {
  ++reasons[static_cast<std::size_t>(seen.reason)];
  if (seen.acceptance > 0) acceptance += seen.acceptance;
}

inline void MutationStatistics::observe(const Observation& seen, RejectionRuns& runs) {
  const auto m = static_cast<std::size_t>(seen.mutation);
  const auto length = static_cast<std::size_t>(std::max(seen.current.vertices - 2, 0));
  Tally& tally = tallies_[m];
  by_length(std::min(length, lengths() - 1), m).add(seen);
  by_class(classes_.index(seen.current.path_class), m).add(seen);
  if (places_.has_places() && !seen.current.is_dark())
    places_.add(m, seen.current.bin, seen.acceptance > 0 ? seen.acceptance : 0);
  std::uint64_t& run = runs.of_mutation[m];
  if (seen.reason == Reason::none) {
    run = runs.whole = 0;
  } else {
    tally.longest_run = std::max(tally.longest_run, ++run);
    longest_run_ = std::max(longest_run_, ++runs.whole);
  }
  if (!(seen.acceptance > 0) || seen.current.is_dark()) return;
  tally.squared_jump += seen.squared_jump;
}

}  // namespace wander
