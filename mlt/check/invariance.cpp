#include "mlt/check/invariance.h"

#include <cmath>

#include "statistics/median.h"
#include "statistics/visible_error.h"

namespace wander {

namespace {

// The largest |z| of the comparisons that can tell anything, each with the number it is known by.
class Comparisons {
 public:
  explicit Comparisons(double heaviest) : heaviest_(heaviest) {}

  // `level`: what the difference is an error of.
  void add(std::size_t number, double difference, double magnitude, double square, double level) {
    if (!(magnitude >= fewest_contributions * heaviest_) || !(square > 0)) return;
    z_.push_back(difference / std::sqrt(square + heaviest_ * std::abs(difference) / 2));
    numbers_.push_back(number);
    spreads_.push_back({square, level});
  }
  Decision decide(const char* test, double false_alarm) const {
    if (z_.empty()) {
      Decision none{.test = test, .p_value = 0, .false_alarm = false_alarm, .comparisons = 0};
      none.detail = nothing_moved;
      return none;
    }
    Decision decision = largest_z_test(z_, false_alarm);
    decision.test = test;
    decision.worst = numbers_[decision.worst];
    std::vector<double> visible;
    for (const auto& [square, level] : spreads_)
      visible.push_back(visible_sum(square, heaviest_, decision.threshold) / level);
    decision.visible = median(visible);
    return decision;
  }

 private:
  struct Spread {
    double square, level;
  };
  double heaviest_;
  std::vector<double> z_;
  std::vector<std::size_t> numbers_;
  std::vector<Spread> spreads_;
};

}  // namespace

void Deviations::merge(const Deviations& other) {
  for (std::size_t k = 0; k < function_count; ++k) {
    sums_[k].value += other.sums_[k].value;
    sums_[k].magnitude += other.sums_[k].magnitude;
    sums_[k].square += other.sums_[k].square;
    sums_[k].level += other.sums_[k].level;
  }
}

Decision Deviations::decide(double heaviest, double false_alarm) const {
  Comparisons comparisons(heaviest);
  for (std::size_t k = 0; k < function_count; ++k)
    comparisons.add(k, sums_[k].value, sums_[k].magnitude, sums_[k].square, sums_[k].level);
  return comparisons.decide("invariance", false_alarm);
}

void Flux::merge(const Flux& other) {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    entries_[k].flow += other.entries_[k].flow;
    entries_[k].square += other.entries_[k].square;
  }
}

Decision Flux::decide(double heaviest, double false_alarm) const {
  Comparisons comparisons(heaviest);
  for (std::size_t i = 0; i < cell_count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Entry &there = entries_[i * cell_count + j], &back = entries_[j * cell_count + i];
      comparisons.add(i * cell_count + j, there.flow - back.flow, there.flow + back.flow,
                      there.square + back.square, (there.flow + back.flow) / 2);
    }
  }
  return comparisons.decide("balance of flux", false_alarm);
}

void InvarianceTally::merge(const InvarianceTally& other) {
  one_step.merge(other.one_step);
  many_steps.merge(other.many_steps);
  flux.merge(other.flux);
  heaviest = std::max(heaviest, other.heaviest);
  starts += other.starts;
  acted += other.acted;
  moved += other.moved;
  acceptance += other.acceptance;
}

InvarianceReport InvarianceTally::report(double false_alarm) const {
  InvarianceReport r;
  r.one_step = one_step.decide(heaviest, false_alarm);
  r.many_steps = many_steps.decide(heaviest, false_alarm);
  r.flux = flux.decide(heaviest, false_alarm);
  r.starts = starts;
  r.acted = acted;
  r.moved = moved;
  if (starts > 0) r.acceptance = acceptance.value() / static_cast<double>(starts);
  return r;
}

}  // namespace wander
