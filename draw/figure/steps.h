// The part of a trajectory that a figure is about: some chains, a range of draws, and of those the
// steps of one mutation or the steps from and to paths of one class.
//
// A trajectory records the state after a decision.  The state before it is the same path where the
// proposal was rejected; else it is the draw before where every step was recorded, and the start of
// the chain before the first draw.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "draw/figure/svg.h"
#include "records/trajectory.h"

namespace wander::figure {

// Where the vertices of a line are drawn, given their coordinates one after the other; a vertex that
// is no number parts what does not hang together.
using Projection = std::function<std::vector<Vector>(std::span<const double> coordinates)>;

struct StepFilter {
  std::vector<int> chains;  // empty: all
  int first = 0;            // draws [first, end)
  int end = std::numeric_limits<int>::max();
  std::optional<int> mutation;             // index
  std::optional<std::int32_t> path_class;  // index
};

struct Step {
  int chain = 0, draw = 0;
  std::size_t index = 0;  // into the columns
};

class Steps {
 public:
  // The trajectory outlives this; what the filter names exists.  Without a projection lines lie in
  // the plane of their first two coordinates.
  Steps(const Trajectory& trajectory, const StepFilter& filter, Projection projection = {});

  const Trajectory& trajectory() const { return *trajectory_; }
  const StepFilter& filter() const { return filter_; }
  std::span<const int> chains() const { return chains_; }
  int first() const { return first_; }
  int draws() const { return end_ - first_; }
  std::size_t index(int chain, int draw) const {
    return static_cast<std::size_t>(chain) * static_cast<std::size_t>(trajectory_->draws) +
           static_cast<std::size_t>(draw);
  }
  // Number of the step of its chain that a draw is.
  double number(int draw) const {
    return static_cast<double>(trajectory_->first_step) +
           static_cast<double>(draw) * static_cast<double>(trajectory_->every);
  }

  // Chain by chain, in order.
  template <class Visitor>
  void each(Visitor&& visit) const {
    for (const int chain : chains_)
      for (int draw = first_; draw < end_; ++draw)
        if (const Step step{chain, draw, index(chain, draw)}; is_chosen(step)) visit(step);
  }

  bool accepted(const Step& step) const { return trajectory_->accepted[step.index] != 0; }
  std::string_view mutation(const Step& step) const;
  std::string_view reason(const Step& step) const;
  // The state before the step, where it is recorded.
  struct State {
    const RecordedPaths* paths;
    std::size_t index;

    std::int32_t path_class() const { return paths->path_class[index]; }
  };
  std::optional<State> before(const Step& step) const;
  // What there is of a proposal that failed, as lines, and where it failed.
  std::vector<std::vector<Vector>> attempt(const Step& step) const;
  std::optional<Vector> failure(const Step& step) const;
  // Light first; empty where there is no path.
  std::vector<Vector> path(const RecordedPaths& paths, std::size_t index) const;
  std::string_view path_class(const RecordedPaths& paths, std::size_t index) const;

 private:
  bool is_chosen(const Step& step) const;
  std::vector<Vector> drawn(std::span<const double> coordinates) const;

  const Trajectory* trajectory_;
  StepFilter filter_;
  Projection projection_;
  std::vector<int> chains_;
  int first_, end_;
};

// What was chosen, for headings: "chain 0, draws 0 to 99, mutation lens".
std::string in_words(const Steps& steps);

}  // namespace wander::figure
