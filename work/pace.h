// How much to do before the clock is looked at again, where the budget is a time: so much that the
// looks cost nothing, and less and less as the end comes near, so that it is hardly overrun.
#pragma once

#include <algorithm>
#include <cstdint>

namespace wander {

// Work is counted in samples, or steps.
class Pace {
 public:
  // The work ends at `end` seconds; of one round `most` is enough.
  Pace(double begin, double end, std::uint64_t most)
      : last_(begin), end_(end), shortest_(shortest_part * end), most_(most) {}

  bool is_over(double now) const { return now >= end_; }
  // A part of the work is kept back for what comes after it.
  void end_at(double end) { end_ = end; }

  // What to do now, of which `done` is done.  At first a little; then half of the time that is
  // left, by the rate of the last round, and no more than `growth` times that round.
  std::uint64_t next(double now, std::uint64_t done) {
    const double passed = now - last_;
    const auto made = static_cast<double>(done - done_);
    if (passed > 0 && made > 0) {
      const double time = std::max((end_ - now) / 2, shortest_);
      const double enough = std::min(made / passed * time, growth * static_cast<double>(round_));
      round_ = static_cast<std::uint64_t>(enough);
    }
    last_ = now;
    done_ = done;
    return round_ = std::clamp(round_, first, std::max(first, most_));
  }

 private:
  static constexpr double shortest_part = 0.004, growth = 4;
  static constexpr std::uint64_t first = 64;

  double last_, end_, shortest_;
  std::uint64_t most_, round_ = first, done_ = 0;
};

}  // namespace wander
