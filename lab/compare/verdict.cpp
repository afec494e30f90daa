#include "lab/compare/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/compare/curves.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::compare {

namespace {

constexpr std::size_t most_sentences = 6;
constexpr std::size_t most_named = 4;  // contenders or pairs, in one sentence

// Two digits, or whole numbers up to a hundred thousand.
constexpr int whole_digits = 5;
std::string digits(double x) {
  if (!std::isfinite(x)) return "?";
  const bool is_whole = std::abs(x) >= 100 && std::abs(x) < 1e5;
  return is_whole ? number_text(std::round(x), whole_digits) : number_text(x, 2);
}

std::string range(const Interval& interval, double factor) {
  if (std::isnan(interval.low) && std::isnan(interval.high)) return "";
  if (std::isnan(interval.high)) return fmt::format(" ({} or more)", digits(factor * interval.low));
  if (std::isnan(interval.low)) return fmt::format(" ({} or less)", digits(factor * interval.high));
  return fmt::format(" ({}–{})", digits(factor * interval.low), digits(factor * interval.high));
}

// Zero is the first budget or before.
std::string range_of_time(const Interval& seconds) {
  if (seconds.low != 0) return range(seconds, 1);
  return std::isnan(seconds.high) ? "" : range({not_known, seconds.high}, 1);
}

// Unknown ends stay so.
Measured inverse(const Measured& ratio) {
  return {1 / ratio.value, {1 / ratio.interval.high, 1 / ratio.interval.low}};
}

// The budgets are samples, and equal samples are not equal time.
bool counts_samples(const std::string& budget) {
  return !budget.ends_with('s') && !budget.ends_with("min") && !budget.ends_with('h');
}

class Words {
 public:
  explicit Words(const Comparison& comparison) : all_(comparison) {}

  const std::string& label(std::size_t contender) const {
    return all_.runs.contenders[contender].label;
  }
  const Cell& cell(std::size_t contender) const {
    return all_.cells[contender * all_.runs.budgets.size() + all_.decisive];
  }
  const std::string& budget() const { return all_.runs.budgets[all_.decisive]; }
  std::string error(std::size_t contender) const {
    return percent_with_interval(cell(contender).relative_rmse);
  }
  std::string pair(const Crossing& c) const {
    return fmt::format("{} and {}", label(c.ahead), label(c.behind));
  }
  std::string standing(const Crossing& crossing) const;
  std::string beginning(const Crossing& crossing) const;
  std::string since(const Crossing& crossing) const;
  bool is_measured(std::size_t contender) const {
    return std::isfinite(cell(contender).relative_rmse.value);
  }

  std::string headline() const;
  std::string of_the_rest() const;
  std::string of_chance() const;
  std::string of_equal_time() const;
  std::string of_the_target() const;

 private:
  const Comparison& all_;
};

// The first time at which both are measured.
std::string Words::beginning(const Crossing& c) const {
  constexpr double noticeable = 1.2;  // budgets of time are met more closely
  const double ahead = shortest_run(all_, c.ahead), behind = shortest_run(all_, c.behind);
  if (std::max(ahead, behind) < noticeable * std::min(ahead, behind))
    return " from the first budget on";
  return fmt::format(" from {} on, where {} begins", duration_in_words(std::max(ahead, behind)),
                     label(ahead > behind ? c.ahead : c.behind));
}

// "from 1.7 s on (1.2–2.5)"
std::string Words::since(const Crossing& c) const {
  const auto& [seconds, interval] = c.seconds;
  if (std::isnan(seconds)) return "";
  if (seconds > 0)
    return fmt::format(" from {} on{}", duration_in_words(seconds), range_of_time(interval));
  return beginning(c) +
         (interval.high > 0 ? fmt::format(" (or from {} s)", digits(interval.high)) : "");
}

std::string Words::standing(const Crossing& c) const {
  if (!c.significant) return fmt::format("Which of {} is ahead cannot be told", pair(c));
  std::string when = since(c);  // in time, where it is ahead by that
  if (when.empty() && counts_samples(budget())) when = " at equal samples";
  return fmt::format("{} is ahead of {}{}", label(c.ahead), label(c.behind), when);
}

std::string Words::headline() const {
  const std::size_t best = all_.ranking.front();
  if (!is_measured(best)) return "No contender has a relative error: there is nothing to rank.";
  if (all_.crossings.empty())
    return fmt::format("At {} the relative RMSE of {} is {}.", budget(), label(best), error(best));
  const Crossing& first = all_.crossings.front();
  if (!first.significant)
    return fmt::format("{}: at {} the relative RMSE of {} is {}, that of {} {}.", standing(first),
                       budget(), label(best), error(best), label(first.behind),
                       error(first.behind));
  const std::string ratio = std::isnan(first.speedup.value)
                                ? ""
                                : fmt::format(", which is {} times the mean square error",
                                              number_with_interval(first.speedup));
  return fmt::format("{}: at {} its relative RMSE is {}, that of {} {}{}.", standing(first),
                     budget(), error(best), label(first.behind), error(first.behind), ratio);
}

// Whom the best one beats besides, by how much.
std::string Words::of_the_rest() const {
  std::string text;
  std::size_t named = 0;
  for (std::size_t i = 1; i + 1 < all_.ranking.size(); ++i) {
    const Crossing& c = all_.crossings[i];  // the first pairs are those of the best
    if (!c.significant || std::isnan(c.speedup.value)) continue;
    if (++named <= most_named)
      text += fmt::format("{}{} {} times", named > 1 ? ", " : "", label(c.behind),
                          number_with_interval(c.speedup));
  }
  if (named == 0) return "";
  if (named > most_named) text += fmt::format(", and {} more", named - most_named);
  return fmt::format("The mean square error of others over that of {}: {}.",
                     label(all_.ranking.front()), text);
}

std::string Words::of_chance() const {
  if (all_.crossings.empty()) return "There is one contender, and nothing to compare it with.";
  std::string text;
  std::size_t named = 0;
  for (const Crossing& c : all_.crossings)
    if (!c.significant && ++named <= most_named)
      text += fmt::format("{}{}", named > 1 ? "; " : "", pair(c));
  if (named == 0)
    return fmt::format("Every difference is significant (5 % over {} {}, Holm).",
                       all_.crossings.size(), all_.crossings.size() == 1 ? "pair" : "pairs");
  if (named > most_named) text += fmt::format("; and {} more", named - most_named);
  if (all_.runs.replicates < 2)
    text += ", because a single replicate has no interval";
  else if (all_.crossings.size() == 1 && std::isfinite(all_.crossings.front().p_value))
    text += fmt::format(", p = {}", digits(all_.crossings.front().p_value));
  return fmt::format("Not significant: the difference between {}.", text);
}

std::string Words::of_equal_time() const {
  if (!counts_samples(budget()) || all_.crossings.empty()) return "";
  const Crossing& first = all_.crossings.front();
  if (std::isnan(first.efficiency.value)) return "";
  const bool turned = first.efficiency.interval.high < 1;
  const std::size_t better = turned ? first.behind : first.ahead,
                    other = turned ? first.ahead : first.behind;
  return fmt::format(
      "This is at equal samples, which took {} {} and {} {}: at equal time {}the efficiency of {} "
      "is {} times that of {}.",
      label(first.ahead), duration_in_words(cell(first.ahead).seconds.value), label(first.behind),
      duration_in_words(cell(first.behind).seconds.value),
      turned ? fmt::format("{} is ahead: ", label(better)) : "", label(better),
      number_with_interval(turned ? inverse(first.efficiency) : first.efficiency), label(other));
}

std::string Words::of_the_target() const {
  if (std::isnan(all_.target)) return "";
  std::string text;
  std::size_t named = 0;
  for (const std::size_t c : all_.ranking) {
    if (!is_measured(c) || cell(c).is_dark || ++named > most_named) continue;
    text += fmt::format("{}{} {}", named > 1 ? "; " : "", label(c), time_to_target(all_, c));
  }
  if (named == 0) return "";
  return fmt::format("Time to a relative RMSE of {}: {}.", percent(all_.target), text);
}

}  // namespace

std::string standing(const Comparison& comparison, const Crossing& crossing) {
  return Words(comparison).standing(crossing);
}

std::string time_to_target(const Comparison& comparison, std::size_t contender) {
  const Curve& curve = comparison.curves[contender];
  const Measured& seconds = curve.seconds_to_target;
  const double longest = longest_run(comparison, contender);
  if (std::isnan(longest)) return "unknown";
  if (seconds.value == 0)
    return fmt::format("at most its shortest run ({})",
                       duration_in_words(shortest_run(comparison, contender)));
  if (std::isnan(seconds.value))
    return curve.inverse_root
               ? fmt::format("more than {} times its longest run ({})", farthest,
                             duration_in_words(longest))
               : fmt::format("not reached in its longest run ({})", duration_in_words(longest));
  return is_extrapolated(comparison, curve)
             ? fmt::format("extrapolated: about {}", seconds_with_interval(seconds))
             : seconds_with_interval(seconds);
}

std::string percent_with_interval(const Measured& share) {
  if (std::isnan(share.value)) return "unknown";
  return fmt::format("{} %{}", digits(100 * share.value), range(share.interval, 100));
}

std::string number_with_interval(const Measured& value) {
  return digits(value.value) + range(value.interval, 1);
}

std::string seconds_with_interval(const Measured& seconds) {
  if (std::isnan(seconds.value)) return "unknown";
  return fmt::format("{} s{}", digits(seconds.value), range_of_time(seconds.interval));
}

std::vector<std::string> verdict_of(const Comparison& comparison) {
  if (comparison.ranking.empty()) return {};
  const Words words(comparison);
  std::vector<std::string> verdict;
  for (const std::string& sentence : {words.headline(), words.of_equal_time(), words.of_chance(),
                                      words.of_the_rest(), words.of_the_target()})
    if (!sentence.empty()) verdict.push_back(sentence);
  const std::size_t cautions = comparison.cautions.size();
  const std::size_t room = most_sentences - std::min(std::size_t{3}, cautions);
  if (verdict.size() > room) verdict.resize(room);
  for (std::size_t i = 0; i < cautions; ++i) {
    const std::size_t left = most_sentences - verdict.size();
    if (left == 1 && i + 1 < cautions) {
      verdict.push_back(fmt::format("There are {} more reasons for caution.", cautions - i));
      break;
    }
    verdict.push_back(comparison.cautions[i]);
  }
  return verdict;
}

}  // namespace wander::compare
