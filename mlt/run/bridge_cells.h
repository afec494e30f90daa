// What the groups of a bridge (bridge.h) tell, by cells of l.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "mlt/run/bridge.h"
#include "mlt/run/unmet_light.h"

namespace wander {

// Paths whose l is about the same: of each side its mean l, in units of the direct estimate, and
// how many there are, per sample of the seed pass and as a share of all states.
struct Cell {
  double found_ratio, state_ratio;
  double found, states;
};

// The cells of all groups together, and what each group adds to them.  Octaves of l that chains have not met (unmet_light.h) are not
// among them: their light is what samples say, and states that one group has there count as none.
class Cells {
 public:
  explicit Cells(std::span<const BridgeGroup> groups) : groups_(groups) {
    RatioHistogram found, states;
    for (const BridgeGroup& g : groups) {
      samples_ += g.samples;
      found.add(*g.found, 1);
      states.add(*g.states, g.state_weight);
      state_count_ += g.states->count();
      all_states_ += g.state_weight * g.states->count();
    }
    double total = 0;
    for (int i = found.first(); i < found.end(); ++i) total += found[i].sum;
    direct_ = total / samples_;
    const int low = std::min(found.first(), states.first());
    for (int i = low; i < std::max(found.end(), states.end()); ++i)
      if (found[i].count + states[i].count > 0) bins_.push_back(i);
    leave_unmet_to_samples(found);
    count_states();
    for (const int i : bins_) {
      const RatioHistogram::Bin f = found[i], s = states[i];
      found_count_ += f.count;
      cells_.push_back({f.count > 0 ? f.sum / f.count / direct_ : 1,
                        s.count > 0 ? s.sum / s.count / direct_ : 1, f.count / samples_,
                        s.count / all_states_});
    }
  }

  double direct() const { return direct_; }
  // Of the octaves that are not among the cells, in units of the direct estimate.
  double light_of_samples() const { return light_of_samples_; }
  double light_of_samples_without(std::size_t group) const {
    const BridgeGroup& g = groups_[group];
    return std::max(0.0, light_of_samples_ * samples_ - light_in(g, unmet_) / direct_) /
           (samples_ - g.samples);
  }
  double samples() const { return samples_; }
  bool has_states() const { return all_states_ > 0; }
  bool has_found() const { return found_count_ > 0; }
  // Until the groups tell: few states know no more than as many samples.
  double balance_at_first() const { return std::min(1.0, state_count_ / samples_); }
  std::span<const Cell> all() const { return cells_; }

  // What is left of a side without a group, but for rounding.
  bool has_samples_without(std::size_t group) const { return samples_ > groups_[group].samples; }
  bool has_found_without(std::size_t group) const {
    return found_count_ > (1 + rounding) * paths_in(groups_[group], bins_);
  }
  bool has_states_without(std::size_t group) const {
    return all_states_ > (1 + rounding) * state_mass_[group];
  }
  // The direct estimate, of samples alone.
  double direct_without(std::size_t group) const {
    const BridgeGroup& g = groups_[group];
    double total = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      total += std::max(0.0, cells_[k].found * samples_ * cells_[k].found_ratio * direct_ -
                                 (*g.found)[bins_[k]].sum);
    return total / (samples_ - g.samples) + direct_ * light_of_samples_without(group);
  }
  // Where something is left of both sides.
  std::vector<Cell> without(std::size_t group) const {
    const BridgeGroup& g = groups_[group];
    const double samples = samples_ - g.samples, states = all_states_ - state_mass_[group];
    std::vector<Cell> cells(cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& c = cells_[k];
      const double their_states = g.state_weight * (*g.states)[bins_[k]].count;
      cells[k] = {c.found_ratio, c.state_ratio,
                  std::max(0.0, c.found * samples_ - (*g.found)[bins_[k]].count) / samples,
                  std::max(0.0, c.states * all_states_ - their_states) / states};
    }
    return cells;
  }

  // What a group's samples found in the octaves that are not among the cells, in units of the direct estimate.
  double unmet_light_of(std::size_t group) const {
    return light_in(groups_[group], unmet_) / direct_;
  }
  // Σ over cells of a group: found paths weighted by h, states by m.
  struct Sums {
    double paths = 0, states = 0, mass = 0;
  };
  template <class H, class M>
  Sums sums_of(std::size_t group, H&& h, M&& m) const {
    const BridgeGroup& g = groups_[group];
    Sums sums{.mass = state_mass_[group]};
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      sums.paths += (*g.found)[bins_[k]].count * h(cells_[k].found_ratio);
      sums.states += g.state_weight * (*g.states)[bins_[k]].count * m(cells_[k].state_ratio);
    }
    return sums;
  }
  std::size_t groups() const { return groups_.size(); }
  double samples_of(std::size_t group) const { return groups_[group].samples; }
  double state_mass() const { return all_states_; }
  // (Σ mass)² / Σ mass² of the groups' states: their number, where all have as many.
  double groups_with_states() const {
    double squares = 0;
    for (const double mass : state_mass_) squares += mass * mass;
    return all_states_ * all_states_ / squares;
  }

  // Of an octave of l: the light that samples found, in units of the direct estimate, and the mean of a function of l over
  // it; the share of the states; and the standard error of light / b - states, as the groups differ, but no less than were
  // all states independent.
  struct Octave {
    double light = 0, mean = 0, states = 0, error = 0;
  };
  // Of those where samples found anything; `b` in the same units.
  template <class M>
  std::vector<Octave> octaves(double b, M&& m) const {
    std::vector<Octave> octaves;
    for (std::size_t begin = 0, end = 0; begin < bins_.size(); begin = end) {
      end = end_of_octave(begin);
      Octave octave;
      for (std::size_t k = begin; k < end; ++k) {
        const double light = cells_[k].found * cells_[k].found_ratio;
        octave.light += light;
        octave.mean += light * m(cells_[k].found_ratio);
        octave.states += cells_[k].states;
      }
      if (octave.light == 0) continue;
      octave.mean /= octave.light;
      octave.error =
          std::max(error_of(octave, begin, end, b), std::sqrt(octave.light / b / state_count_));
      octaves.push_back(octave);
    }
    return octaves;
  }

 private:
  static constexpr double rounding = 1e-9;

  static double light_in(const BridgeGroup& g, std::span<const int> bins) {
    double light = 0;
    for (const int bin : bins) light += (*g.found)[bin].sum;
    return light;
  }
  static double paths_in(const BridgeGroup& g, std::span<const int> bins) {
    double paths = 0;
    for (const int bin : bins) paths += (*g.found)[bin].count;
    return paths;
  }
  // One past the last bin of the octave that begins at `begin`.
  std::size_t end_of_octave(std::size_t begin) const {
    const auto octave_of = [&](std::size_t k) {
      return bins_[k] >> RatioHistogram::bits_per_octave;
    };
    std::size_t end = begin;
    while (end < bins_.size() && octave_of(end) == octave_of(begin)) ++end;
    return end;
  }
  void leave_unmet_to_samples(const RatioHistogram& found) {
    if (groups() <= 2) return;  // one of two is no few
    const double states_of_each = state_count_ / static_cast<double>(groups());
    std::vector<int> met;
    for (std::size_t begin = 0, end = 0; begin < bins_.size(); begin = end) {
      end = end_of_octave(begin);
      const std::span<const int> octave = std::span(bins_).subspan(begin, end - begin);
      double light = 0;
      for (const int bin : octave) light += found[bin].sum / samples_ / direct_;
      const auto has_states = [&](const BridgeGroup& g) {
        return std::ranges::any_of(octave, [&](int bin) { return (*g.states)[bin].count > 0; });
      };
      const auto groups_there = static_cast<int>(std::ranges::count_if(groups_, has_states));
      const bool unmet = is_unmet(groups_there, light * states_of_each);
      (unmet ? unmet_ : met).insert((unmet ? unmet_ : met).end(), octave.begin(), octave.end());
      if (unmet) light_of_samples_ += light;
    }
    bins_ = std::move(met);
  }
  void count_states() {
    all_states_ = state_count_ = 0;
    for (const BridgeGroup& g : groups_) {
      double states = 0;
      for (const int bin : bins_) states += (*g.states)[bin].count;
      state_count_ += states;
      state_mass_.push_back(g.state_weight * states);
      all_states_ += state_mass_.back();
    }
  }

  double error_of(const Octave& octave, std::size_t begin, std::size_t end, double b) const {
    double squares = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      double light = -groups_[g].samples * octave.light, states = -state_mass_[g] * octave.states;
      for (std::size_t k = begin; k < end; ++k) {
        light += (*groups_[g].found)[bins_[k]].count * cells_[k].found_ratio;
        states += groups_[g].state_weight * (*groups_[g].states)[bins_[k]].count;
      }
      const double deviation = light / samples_ / b - states / all_states_;
      squares += deviation * deviation;
    }
    return std::sqrt(squares);
  }

  std::span<const BridgeGroup> groups_;
  double samples_ = 0, all_states_ = 0, direct_ = 0, found_count_ = 0, state_count_ = 0;
  std::vector<double> state_mass_;
  double light_of_samples_ = 0;
  std::vector<Cell> cells_;
  std::vector<int> bins_, unmet_;
};

}  // namespace wander
