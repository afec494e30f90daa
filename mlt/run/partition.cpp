#include "mlt/run/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "mlt/run/light_by_ratio.h"

namespace wander {

namespace {

constexpr double fewest_samples_of_a_pilot = 64, enough_effective_samples = 512;
constexpr double nearly_best = 1.05;  // of light that is called easy
constexpr double as_good = 1.02;      // of fewer samples, and more steps for what they have not met
// How many times the least work a choice may take that leaves less to chains; and one that leaves to samples all light
// that was seen.
constexpr double about_as_good = 1.25, worth_a_risk = 2.5;
constexpr double hardly_any_light = 1. / 1024;
constexpr std::array<double, 3> ends{0x1p9, 0x1p12, 0x1p15};  // over b, of an image
constexpr double narrowest_band = 16;                         // from a border to an end
constexpr double smallest_border = 0x1p-2, largest_border = 0x1p18, border_of_all_light = 0x1p48,
                 largest_safe_border = 0x1p10;  // over b

// Σ over the cells of a histogram of f(number of paths, their l).
template <class F>
double sum(const RatioHistogram& ratios, F&& f) {
  double total = 0;
  for (int i = ratios.first(); i < ratios.end(); ++i) {
    const RatioHistogram::Bin bin = ratios[i];
    if (bin.count > 0) total += f(bin.count, bin.sum / bin.count);
  }
  return total;
}

// V / b², of which each part is made of l / b.
class Variance {
 public:
  Variance(const Pilot& pilot, std::size_t bins)
      : light_(pilot.light_of_samples(), pilot.chains),
        borders_(pilot.borders),
        bins_(static_cast<double>(bins)),
        b_(pilot.b()),
        steps_per_chain_(pilot.steps_per_chain),
        steps_per_seed_(pilot.steps_per_seed),
        seeds_per_step_(pilot.seeds_per_step) {}

  // ρ, of all samples that there are
  double all_samples(double samples_per_step) const {
    return std::max(samples_per_step, seeds_per_step_);
  }

  // V(ρ, c) / b², but for V_b
  double of_parts(const Pilot::Border& border, double samples_per_step) const {
    const Partition side = in_units_of_b(border);
    const double draws = border.steps_per_draw *
                         mean([&](double l) { return side.of_chains(l) * side.of_chains(l); });
    return of_samples(border) / all_samples(samples_per_step) + draws +
           border.unvisited * steps_per_chain_ + of_seeds(side, samples_per_step);
  }
  // E_π[w_M]: the share of light that is left to chains
  double of_chains(const Pilot::Border& border) const {
    const Partition side = in_units_of_b(border);
    return mean([&](double l) { return side.of_chains(l); });
  }
  // V_b(ρ) / b², if the bridge had this border
  double of_total(const Pilot::Border& border, double samples_per_step) const {
    const Partition side = in_units_of_b(border);
    const double hard = of_chains(border);
    const double squared = mean([&](double l) { return side.of_chains(l) * side.of_chains(l); });
    const double chains = border.steps_per_draw_of_total * std::max(0.0, squared - hard * hard);
    return (of_samples(border) / all_samples(samples_per_step) + chains) /
           (bins_ * (1 - hard) * (1 - hard));
  }

 private:
  Partition in_units_of_b(const Pilot::Border& border) const {
    return {border.c / b_, border.end / b_};
  }
  template <class G>
  double mean(G&& g) const {
    return light_.mean([&](double l) { return g(l / b_); });
  }
  // χ E_π[l w_B²] / b
  double of_samples(const Pilot::Border& border) const {
    const Partition side = in_units_of_b(border);
    return border.together *
           mean([&](double l) { return l * side.of_samples(l) * side.of_samples(l); });
  }

  // k E_π[φ² l w_M²] / b
  double of_seeds(Partition side, double samples_per_step) const {
    return steps_per_seed_.value_or(1 / all_samples(samples_per_step)) * mean([&](double l) {
             return std::pow(where_it_began(l * b_), 2) * l * side.of_chains(l) * side.of_chains(l);
           });
  }
  // φ(l)
  double where_it_began(double ratio) const {
    double steps_per_draw = 0;
    for (const Pilot::Border& border : borders_)
      if (!border.side().has_end() && border.c <= ratio)
        steps_per_draw = std::max(steps_per_draw, border.steps_per_draw);
    return steps_per_chain_ > 0 ? std::min(1.0, steps_per_draw / steps_per_chain_) : 0;
  }

  LightByRatio light_;
  std::span<const Pilot::Border> borders_;
  double bins_, b_, steps_per_chain_;
  std::optional<double> steps_per_seed_;
  double seeds_per_step_;
};

std::vector<Pilot::Border> borders_of(const Pilot& pilot) {
  if (!pilot.borders.empty()) return pilot.borders;
  std::vector<Pilot::Border> borders;
  for (const double c : borders_around(pilot.b())) borders.push_back({.c = c});
  return borders;
}

struct Choice {
  Pooling pooling;
  double work = 0;       // V (1 + ρ κ)
  double of_chains = 0;  // share of light
};

double cost_of_sample(const Pilot& pilot) {
  return pilot.rays / pilot.samples / pilot.rays_per_step;
}

// Of each border with so many samples per step.
void add_choices(const Pilot& pilot, const Variance& variance, double samples_per_step,
                 std::vector<Choice>& choices) {
  const double cost = cost_of_sample(pilot);
  const std::vector<Pilot::Border> borders = borders_of(pilot);
  double of_total = std::numeric_limits<double>::infinity();
  for (const Pilot::Border& border : borders)
    of_total = std::min(of_total, variance.of_total(border, samples_per_step));
  for (const Pilot::Border& border : borders) {
    const double work = (variance.of_parts(border, samples_per_step) + of_total) *
                        (1 + variance.all_samples(samples_per_step) * cost);
    if (std::isnan(work)) continue;
    choices.push_back({{border.side(), samples_per_step, border.steps_per_draw, cost},
                       work,
                       variance.of_chains(border)});
  }
}

// By their samples per step, the fewest first.
std::vector<Choice> all_choices(const Pilot& pilot, std::size_t bins, double most_cost) {
  const Variance variance(pilot, bins);
  std::vector<Choice> choices;
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2) {
    if (rho > fewest_samples_per_step && rho * cost_of_sample(pilot) > most_cost) break;
    add_choices(pilot, variance, rho, choices);
  }
  return choices;
}

const Choice& best_of(std::span<const Choice> choices) {
  return *std::ranges::min_element(choices, {}, &Choice::work);
}

// The one that leaves least to chains, of those that leave to samples no more than what lies below `most`
// and whose work is no more than `work`.
Choice safest(std::span<const Choice> choices, double most, double work) {
  std::vector<Choice> among(choices.begin(), choices.end());
  std::erase_if(
      among, [=](const Choice& one) { return one.pooling.partition.c > most || one.work > work; });
  return *std::ranges::min_element(
      among, {}, [](const Choice& one) { return std::pair(-one.pooling.partition.c, one.work); });
}

constexpr double any_border = std::numeric_limits<double>::infinity();

Choice about_the_best(std::span<const Choice> choices, double enough) {
  const Choice& best = best_of(choices);
  const double most = best.pooling.partition.c > enough ? any_border : enough;
  return safest(choices, most, about_as_good * best.work);
}

// The least border from `enough` on beyond which hardly any light is known.
double border_of_seen_light(std::span<const Choice> choices, double enough) {
  double least = any_border;
  for (const Choice& one : choices)
    if (const double c = one.pooling.partition.c; c >= enough && one.of_chains <= hardly_any_light)
      least = std::min(least, c);
  return least;
}

Choice of_least_risk_without_end(std::span<const Choice> choices, double enough) {
  const Choice& best = best_of(choices);
  const double most = std::max(best.pooling.partition.c, border_of_seen_light(choices, enough));
  const Choice by_samples = safest(choices, most, worth_a_risk * best.work);
  return by_samples.pooling.partition.c >= enough ? by_samples : about_the_best(choices, enough);
}

// The one that leaves least beyond its end to samples, of those about as good as the best.
Choice with_widest_end(std::span<const Choice> choices) {
  const double work = about_as_good * best_of(choices).work;
  std::vector<Choice> among(choices.begin(), choices.end());
  std::erase_if(among, [=](const Choice& one) { return one.work > work; });
  return *std::ranges::min_element(
      among, {}, [](const Choice& one) { return std::pair(-one.pooling.partition.end, one.work); });
}

Choice of_least_risk(std::span<const Choice> choices, double enough) {
  std::vector<Choice> with_end, without;
  for (const Choice& one : choices)
    (one.pooling.partition.has_end() ? with_end : without).push_back(one);
  const Choice safe = of_least_risk_without_end(without, enough);
  if (with_end.empty()) return safe;
  const bool is_left_to_samples = safe.pooling.partition.c >= enough;
  const double worth = is_left_to_samples ? about_as_good : 1 / worth_a_risk;
  return worth * best_of(with_end).work > safe.work ? safe : with_widest_end(with_end);
}

// By a rule, if there is anything to choose.
template <class Rule>
Pooling chosen_by(Rule&& rule, const Pilot& pilot, std::size_t bins, double most_cost) {
  if (!is_telling(pilot)) return pooling(pilot, fewest_samples_per_step, bins);
  const std::vector<Choice> choices = all_choices(pilot, bins, most_cost);
  if (choices.empty())
    return {.samples_per_step = fewest_samples_per_step, .cost_of_sample = cost_of_sample(pilot)};
  return rule(choices, largest_safe_border * pilot.b()).pooling;
}

}  // namespace

RatioHistogram Pilot::states() const {
  RatioHistogram all;
  for (const RatioHistogram& chain : chains) all.add(chain, 1);
  return all;
}

RatioHistogram Pilot::light_of_samples() const {
  return weighed ? *weighed : found.without_largest();
}

double Pilot::b() const {
  return sum(found, [](double paths, double l) { return paths * l; }) / samples;
}

std::vector<double> borders_around(double b) {
  std::vector<double> borders;
  for (double c = smallest_border; c <= largest_border; c *= 4) borders.push_back(c * b);
  borders.push_back(border_of_all_light * b);
  return borders;
}

std::vector<Partition> partitions_around(double b, FilmKind film) {
  std::vector<Partition> all;
  for (const double c : borders_around(b)) all.push_back({c});
  if (film == FilmKind::curve) return all;
  for (const double end : ends)
    for (double c = smallest_border; c * narrowest_band <= end; c *= 4)
      all.push_back({c * b, end * b});
  return all;
}

double steps_per_draw(double variance_ratio, double steps) {
  // x by halving the octaves in which it may lie: R falls with x.
  double low = 0.5, high = 2 * steps;
  while (high / low > 1.001) {
    const double x = std::sqrt(low * high);
    (2 * (x - 1 + std::exp(-x)) > variance_ratio * x * x ? low : high) = x;
  }
  return 2 * steps / std::sqrt(low * high);
}

double Pilot::effective_samples() const {
  const double unit = b();
  if (!(unit > 0)) return 0;
  const double all = sum(found, [&](double paths, double l) { return paths * (l / unit); });
  const double squares =
      sum(found, [&](double paths, double l) { return paths * (l / unit) * (l / unit); });
  return all * all / squares;
}

bool is_telling(const Pilot& pilot) {
  return pilot.effective_samples() >= fewest_samples_of_a_pilot;
}

bool tells_enough(const Pilot& pilot) {
  return pilot.effective_samples() >= enough_effective_samples;
}

bool finds_rare_light(const Pilot& pilot) {
  return !is_telling(pilot) && pilot.samples >= static_cast<double>(most_samples_of_a_pilot);
}

Pooling pooling(const Pilot& pilot, double samples_per_step, std::size_t bins) {
  if (!(pilot.b() > 0) || !(samples_per_step > 0)) return {.samples_per_step = samples_per_step};
  std::vector<Choice> choices;
  add_choices(pilot, {pilot, bins}, samples_per_step, choices);
  return choices.empty() ? Pooling{.samples_per_step = samples_per_step} : best_of(choices).pooling;
}

Pooling best_pooling(const Pilot& pilot, std::size_t bins, double most_cost) {
  return chosen_by(about_the_best, pilot, bins, most_cost);
}

bool is_left_to_samples(const Pooling& pooling, double b) {
  return !pooling.partition.has_end() && pooling.partition.c >= largest_safe_border * b;
}

Pooling cautious_pooling(const Pilot& pilot, std::size_t bins, double most_cost) {
  return chosen_by(of_least_risk, pilot, bins, most_cost);
}

std::optional<Pooling> pooling_of_easy_light(const Pilot& samples, std::size_t bins,
                                             double most_cost) {
  if (!tells_enough(samples)) return {};
  std::vector<Choice> choices = all_choices(samples, bins, most_cost);
  if (choices.empty()) return {};
  const double enough = nearly_best * best_of(choices).work,
               border = largest_safe_border * samples.b();
  std::erase_if(choices, [&](const Choice& one) {
    return one.pooling.partition.c != border || one.work > enough;
  });
  if (choices.empty()) return {};
  const double least = best_of(choices).work;
  const auto is_as_good = [least](const Choice& one) { return one.work <= as_good * least; };
  return std::ranges::find_if(choices, is_as_good)->pooling;  // fewest samples first
}

}  // namespace wander
