// The normalization of chains: what each estimate of b says, and b by path length.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "draw/figure/film_series.h"
#include "draw/figure/interval_rows.h"
#include "draw/figure/scale_of_ten.h"
#include "draw/figure/share_bars.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::report {
namespace {

// Beyond so many standard errors of their difference, two estimates disagree.
constexpr double alarm = 4;
constexpr std::size_t groups_per_figure = 4;

std::vector<std::size_t> normalized_contenders(const Subject& subject) {
  std::vector<std::size_t> found;
  for (const std::size_t k : chain_contenders(subject))
    if (subject.details(k)->normalization) found.push_back(k);
  return found;
}

std::optional<figure::Range> range_of(const Estimate& estimate) {
  if (!std::isfinite(estimate.standard_error)) return std::nullopt;
  const compare::Interval interval = with_normal_interval(estimate).interval;
  return figure::Range{interval.low, interval.high};
}

std::string note_of(const Estimate& estimate) {
  return std::isfinite(estimate.value) ? with_interval(with_normal_interval(estimate)) : "failed";
}

std::string note_of(const figure::IntervalRow& row) {
  if (!std::isfinite(row.value)) return "failed";
  compare::Measured measured{row.value, {}};
  if (row.interval) measured.interval = {row.interval->low, row.interval->high};
  return with_interval(measured);
}

figure::IntervalGroup group_of(const Subject& subject, std::size_t contender) {
  const Normalization& b = *subject.details(contender)->normalization;
  figure::IntervalGroup group{subject.label(contender), {}};
  std::size_t k = 0;
  for (const auto& [name, estimate] : b.estimates)
    group.rows.push_back({.label = figure::spoken(name) + (name == b.method ? ", used" : ""),
                          .value = estimate.value,
                          .interval = range_of(estimate),
                          .look = figure::look_of(k++)});
  if (group.rows.empty())
    group.rows.push_back({.label = "b", .value = b.value, .interval = range_of(b)});
  return group;
}

// Rows, band and notes in one power of ten, which the axis names.
void rescale(figure::IntervalRows& rows) {
  double magnitude = 0;
  const auto see = [&](double value) {
    if (std::isfinite(value)) magnitude = std::max(magnitude, std::abs(value));
  };
  for (const figure::IntervalGroup& group : rows.groups)
    for (const figure::IntervalRow& row : group.rows) see(row.value);
  const int exponent = figure::common_exponent(magnitude);
  const auto scaled = [&](figure::Range range) {
    return figure::Range{figure::decimal(range.low, -exponent),
                         figure::decimal(range.high, -exponent)};
  };
  for (figure::IntervalGroup& group : rows.groups)
    for (figure::IntervalRow& row : group.rows) {
      row.value = figure::decimal(row.value, -exponent);
      if (row.interval) row.interval = scaled(*row.interval);
      row.note = note_of(row);
    }
  if (rows.band) rows.band = scaled(*rows.band);
  if (exponent != 0)
    rows.x.quantity.unit = fmt::format("10{} {}", superscript(exponent), rows.x.quantity.unit);
}

// The mean of the reference, with errors of bins that are independent.
std::optional<Estimate> reference_mean(const Subject& subject) {
  const FilmEstimate& film = subject.runs().reference.film;
  if (film.value.empty()) return std::nullopt;
  double variance = 0;
  const int channels = channels_of(film.shape);
  for (std::size_t i = 0; i < film.standard_error.size(); ++i) {
    const double share = channels * luminance_weight(channels, i) * film.standard_error[i];
    variance += share * share;
  }
  return Estimate{mean_value(film), std::sqrt(variance) / static_cast<double>(film.value.size())};
}

void write_estimates(Html& html, const Subject& subject) {
  const std::vector<std::size_t> contenders = normalized_contenders(subject);
  for (std::size_t first = 0; first < contenders.size(); first += groups_per_figure) {
    figure::IntervalRows rows{
        .x = {.quantity = {"b, the mean of the film", subject.unit_of_bins()}}};
    for (std::size_t k = first; k < std::min(contenders.size(), first + groups_per_figure); ++k)
      rows.groups.push_back(group_of(subject, contenders[k]));
    if (const auto mean = reference_mean(subject)) {
      rows.band = range_of(*mean);
      rows.band_label = "mean of the reference, 95 %";
    }
    rescale(rows);
    write_figure(
        html,
        figure::page("Estimates of the normalization",
                     "For each contender the estimates of b with 95 % intervals.", figure_width,
                     {figure::interval_block(std::move(rows), figure::block_width(figure_width))}),
        "What each estimate says of b in the first replicate at the last budget, with 95 % "
        "intervals of ± 1.96 standard errors. The seed pass is the mean of independent "
        "samples and is right on average whatever the chains do; the others use the chains, "
        "are narrower where those mix, and go wrong where they miss paths. The shade is the "
        "mean of the reference, as if the errors of its bins were independent.");
  }
}

// Pairs of estimates of a contender that disagree.
std::vector<std::string> disagreements(const Subject& subject, std::size_t contender) {
  const auto& estimates = subject.details(contender)->normalization->estimates;
  std::vector<std::string> found;
  for (auto a = estimates.begin(); a != estimates.end(); ++a)
    for (auto b = std::next(a); b != estimates.end(); ++b) {
      const double difference = std::abs(a->second.value - b->second.value);
      const double error = std::hypot(a->second.standard_error, b->second.standard_error);
      if (difference > alarm * error)
        found.push_back(fmt::format("{} and {} of {}, by {:.1f} standard errors",
                                    figure::spoken(a->first), figure::spoken(b->first),
                                    subject.label(contender), difference / error));
    }
  return found;
}

void write_words(Html& html, const Subject& subject) {
  std::vector<std::string> found, failed;
  bool several = false;
  for (const std::size_t k : normalized_contenders(subject)) {
    const std::vector<std::string> own = disagreements(subject, k);
    found.insert(found.end(), own.begin(), own.end());
    const auto& estimates = subject.details(k)->normalization->estimates;
    several = several || estimates.size() > 1;
    for (const auto& [name, estimate] : estimates)
      if (!std::isfinite(estimate.value))
        failed.push_back(fmt::format("{} of {}", figure::spoken(name), subject.label(k)));
  }
  if (!failed.empty()) html.element("p", fmt::format("Failed, and not used: {}.", listed(failed)));
  if (!found.empty())
    html.element("p", fmt::format("Significant: estimates disagree: {}. The chains may miss paths "
                                  "that the seed pass has met, or the seed pass may be too short.",
                                  listed(found)));
  else if (several)
    html.element(
        "p",
        fmt::format("Not significant: no two estimates of a contender lie more than {:.0f} "
                    "standard errors apart.",
                    alarm),
        {{"class", "note"}});
}

void write_lengths(Html& html, const Subject& subject) {
  std::map<int, std::size_t> row_of;
  for (const std::size_t k : normalized_contenders(subject))
    for (const LengthShare& share : subject.details(k)->normalization->by_length)
      row_of.emplace(share.vertices, 0);
  if (row_of.empty()) return;
  std::vector<std::string> names;
  for (auto& [vertices, row] : row_of) {
    row = names.size();
    names.push_back(fmt::format("{}", vertices));
  }
  Table table = named_rows("b by the number of vertices of the paths, ± 1.96 standard errors.",
                           "vertices", names);
  for (const std::size_t k : normalized_contenders(subject)) {
    std::vector<std::string> cells(names.size(), "none");
    for (const LengthShare& share : subject.details(k)->normalization->by_length)
      cells[row_of[share.vertices]] = note_of(share);
    table.add_column({subject.label(k) + ", " + subject.unit_of_bins()}, cells);
  }
  write_folded(html, "b by path length, in figures", table);
}

}  // namespace

void write_normalization(Html& html, const Subject& subject) {
  if (normalized_contenders(subject).empty()) {
    html.element("p", "No contender is a Markov chain: independent samples need no normalization.",
                 {{"class", "note"}});
    return;
  }
  write_estimates(html, subject);
  write_words(html, subject);
  write_lengths(html, subject);
}

}  // namespace wander::report
