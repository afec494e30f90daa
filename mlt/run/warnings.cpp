#include "mlt/run/warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

#include "core/film_statistics.h"
#include "core/reliability.h"
#include "mlt/run/chain_settings.h"
#include "mlt/run/deposit.h"
#include "mlt/run/reliability.h"
#include "mlt/watch/functional_words.h"
#include "statistics/number_text.h"
#include "work/parallel.h"

namespace wander {

namespace {

// A class with more than this share of the film, by the share of all steps …
constexpr double least_share = 0.005;
// … in which every group would make at least so many steps, if the chains mixed, is met by more
// than a few groups.
constexpr double fewest_steps = 100;

// A larger share of steps in which chains could do nothing is wasted.
constexpr double most_idle = 0.2;

// So many classes are named in a warning, those of most steps first.
constexpr std::size_t most_named = 3;

// A budget that is still more times as large is no advice.
constexpr double largest_factor = 100, least_factor = 1.1;

constexpr std::size_t cells_of_ranks = 16;
// Of fewer in all groups, or fewer elsewhere, F has not its law: a rare value beside a large tie is in a cell of its own.
constexpr double fewest_draws_of_cell = 50;

// The cell of each draw: which sixteenth its rank is in.  Equal values are in one cell.
std::vector<std::size_t> cells_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size()), cell(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i)
      cell[order[i]] = cells_of_ranks * (first + end - 1) / (2 * order.size());
  }
  return cell;
}

// Counts of draws in cells, [group][half][cell].
std::vector<double> counts_of(const Draws& draws, std::size_t chains_per_group) {
  const std::vector<std::size_t> cell = cells_of(draws.values);
  const std::size_t half = draws.length / 2;
  std::vector<double> counts(draws.chains / chains_per_group * 2 * cells_of_ranks);
  for (std::size_t c = 0; c < draws.chains; ++c)
    for (std::size_t i = 0; i < 2 * half; ++i)
      ++counts[(c / chains_per_group * 2 + i / half) * cells_of_ranks + cell[c * draws.length + i]];
  return counts;
}

// F of a cell.
double spread_ratio(const std::vector<double>& counts, std::size_t k) {
  double sum = 0, squares = 0, within = 0;
  const std::size_t groups = counts.size() / (2 * cells_of_ranks);
  for (std::size_t g = 0; g < groups; ++g) {
    const double first = counts[2 * g * cells_of_ranks + k],
                 second = counts[(2 * g + 1) * cells_of_ranks + k];
    const double mean = (first + second) / 2;
    sum += mean;
    squares += mean * mean;
    within += (first - second) * (first - second) / 4;
  }
  const double draws = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (std::min(2 * sum, draws - 2 * sum) < fewest_draws_of_cell) return 0;
  const auto n = static_cast<double>(groups);
  const double between = (squares - sum * sum / n) / (n - 1);
  return between > 0 ? between / (within / n) : 0;
}

std::string few_samples(const SeedTally& seeds) {
  return fmt::format(
      "the seed pass rests on about {} of {} samples: a rare event carries the light, and what was "
      "not seen is in no error bar; a larger budget or --seed-share makes a longer seed pass",
      static_cast<int>(seeds.effective_samples()), seeds.samples);
}

std::string few_seeds(const SeedTally& seeds, std::size_t chains) {
  return fmt::format(
      "the seed pass rests on about {} samples, fewer than the {} chains that start from its "
      "paths; a larger budget makes a longer seed pass",
      static_cast<int>(seeds.effective_samples()), chains);
}

// What makes chains so many times longer: first fewer of them, then a larger budget.
std::string remedy(double factor, std::size_t chains_per_group) {
  if (factor >= largest_factor)
    return "no budget below 100 times as large would do; try other mutations, or bdpt";
  const auto times = [](double x) { return fmt::format("{:.{}f}", x, x < 10 ? 1 : 0); };
  constexpr int groups = ChainSettings{}.groups;
  const auto most = static_cast<double>(chains_per_group);
  if (factor <= most && chains_per_group > 1)
    return fmt::format("--chains {} would do", groups * static_cast<int>(most / factor));
  const std::string fewer =
      chains_per_group > 1 ? fmt::format("--chains {} and ", groups) : std::string();
  return fmt::format("{}a budget {} times as large would do", fewer,
                     times(std::max(factor / most, least_factor)));
}

// Of the position on the sensor alone: what else is slow, and tells on the film, tells there.  R̂² -
// 1 falls with the length of the chains.
std::string slow_mixing(const Evidence& evidence) {
  const auto& functionals = evidence.chains.functionals;
  const auto film = std::ranges::find(functionals, "film", &FunctionalRecord::name);
  if (film == functionals.end() || !(film->r_hat > largest_r_hat)) return "";
  const double factor = (film->r_hat * film->r_hat - 1) / (largest_r_hat * largest_r_hat - 1);
  return fmt::format(
      "the chains of about {} mutations are short for their mixing: R-hat of their position on the "
      "sensor is {}, above {}; the error bars know that, but the effective sample sizes are rough; "
      "{}",
      evidence.chains.draws * evidence.chains.stride,
      std::isinf(film->r_hat) ? "infinite" : fmt::format("{:.3f}", film->r_hat), largest_r_hat,
      remedy(factor, evidence.chains_per_group));
}

std::string disagreeing_groups(const Evidence& evidence) {
  const std::size_t groups = evidence.draws.chains() / evidence.chains_per_group;
  if (groups < static_cast<std::size_t>(GroupsFilm::fewest_groups)) return "";
  double worst = 1;
  std::string_view name;
  std::array<Disagreement, std::tuple_size_v<Functionals>> all;
  in_parallel(all.size(), [&](std::size_t k) {
    all[k] = disagreement(evidence.draws.of(k), evidence.chains_per_group);
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Disagreement& found = all[k];
    if (!(found.p_value < disagreement_false_alarm) || found.ratio <= worst) continue;
    worst = found.ratio;
    name = spoken_functional(name_of_functional(k));
  }
  if (name.empty()) return "";
  return fmt::format(
      "the groups of chains disagree on {}: they differ {}, so a film may look clean and be "
      "another "
      "with another seed; believe the error bars, which are made of these differences, and take a "
      "larger budget, other mutations, or bdpt",
      name,
      std::isinf(worst) ? "from each other, and none of them changes"
                        : number_text(worst, 2) + " times as much as each of them changes");
}

std::string idle_chains(const MutationStatistics& statistics) {
  const double share = static_cast<double>(statistics.steps(Reason::not_applicable)) /
                       static_cast<double>(std::max<std::uint64_t>(1, statistics.steps()));
  if (!(share > most_idle)) return "";
  return fmt::format(
      "chains were in {} % of their steps where none of the mutations can act, and stayed; add "
      "bidirectional or primary to --mutations, which act on every path",
      number_text(100 * share, 2));
}

std::string few_groups(const Evidence& evidence) {
  const MutationStatistics& statistics = evidence.statistics;
  const std::size_t groups = evidence.all_groups;
  if (groups < 2 * static_cast<std::size_t>(GroupsFilm::fewest_groups)) return "";
  const auto steps = static_cast<double>(statistics.steps());
  std::vector<MutationStatistics::Visits> rare = statistics.visits();
  std::erase_if(rare, [&](const auto& visits) {
    const auto spent = static_cast<double>(visits.steps);
    return visits.groups >= GroupsFilm::fewest_groups ||
           spent * evidence.light_of_chains < least_share * steps ||
           spent < fewest_steps * static_cast<double>(groups);
  });
  if (rare.empty()) return "";
  std::ranges::stable_sort(rare, std::greater(), &MutationStatistics::Visits::steps);
  std::vector<std::string> parts;
  for (const auto& visits : std::span(rare).first(std::min(rare.size(), most_named)))
    parts.push_back(fmt::format(
        "{} ({} % of all steps, {} of {} groups)", name_of_class(visits.path_class),
        number_text(100 * static_cast<double>(visits.steps) / steps, 2), visits.groups, groups));
  if (rare.size() > most_named) parts.push_back(fmt::format("{} more", rare.size() - most_named));
  return fmt::format(
      "few groups of chains ever met paths of class {}: few seeds are such paths, and no mutation "
      "leads there; a larger budget makes a longer seed pass",
      fmt::join(parts, ", "));
}

}  // namespace

bool rests_on_few_samples(const SeedTally& seeds) {
  return seeds.effective_samples() < fewest_effective_samples;
}

Disagreement disagreement(const Draws& draws, std::size_t chains_per_group) {
  const std::size_t groups = draws.chains / chains_per_group;
  if (groups < 2 || draws.length < 2) return {};
  if (!std::ranges::all_of(draws.values, [](double v) { return std::isfinite(v); })) return {};
  const std::vector<double> counts = counts_of(draws, chains_per_group);
  double worst = 0;
  for (std::size_t k = 0; k < cells_of_ranks; ++k) worst = std::max(worst, spread_ratio(counts, k));
  if (std::isinf(worst)) return {worst, 0};
  const auto n = static_cast<double>(groups);
  const boost::math::fisher_f expected(n - 1, n);
  const double p = boost::math::cdf(boost::math::complement(expected, worst));
  return {std::sqrt(worst), std::min(1.0, static_cast<double>(cells_of_ranks) * p)};
}

std::string dominated_film(const FilmEstimate& film, int groups) {
  if (groups <= 2 * fewest_film_degrees || !(film.degrees_of_error < fewest_film_degrees))
    return {};
  if (!std::isfinite(relative_error(film)))
    return "nobody knows the error of the film: so few groups of chains found its light that "
           "without one "
           "of them there is none; take a larger budget, or other seeds";
  return fmt::format(
      "the error of the film, {} %, rests on {:.0f} of {} groups of chains ({} degrees of "
      "freedom): "
      "they have met bright light that the others seldom have, and there may be more of it; where "
      "pixels are not reliable, trust a larger budget, or other seeds",
      number_text(100 * relative_error(film), 2), film.degrees_of_error + 1, groups,
      number_text(film.degrees_of_error, 2));
}

std::vector<std::string> warnings(const Evidence& evidence) {
  std::vector<std::string> all;
  if (rests_on_few_samples(evidence.seeds)) {
    all.push_back(few_samples(evidence.seeds));
  } else if (evidence.seeds.effective_samples() < static_cast<double>(evidence.all_chains)) {
    all.push_back(few_seeds(evidence.seeds, evidence.all_chains));
  }
  if (evidence.light_of_chains >= least_light_of_chains) {
    const std::string disagreement = disagreeing_groups(evidence);
    // Groups that disagree are of chains that are short, and a worse matter.
    all.push_back(disagreement.empty() ? slow_mixing(evidence) : disagreement);
    all.push_back(idle_chains(evidence.statistics));
  }
  all.push_back(few_groups(evidence));
  std::erase_if(all, [](const std::string& warning) { return warning.empty(); });
  return all;
}

}  // namespace wander
