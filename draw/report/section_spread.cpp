// All seeds of each contender, and whether they lie as far apart as their error bars say.
#include <fmt/format.h>

#include <algorithm>

#include "draw/figure/film_series.h"
#include "draw/figure/share_bars.h"
#include "draw/report/bins.h"
#include "draw/report/chart_pages.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/spread.h"
#include "draw/report/table.h"
#include "lab/reference_name.h"
#include "mlt/watch/functional_words.h"

namespace wander::report {
namespace {

constexpr std::size_t most_spread_steps = 400;
// Of all lines of this section: so many steps are drawn that the page stays small.
constexpr std::size_t most_points = 24'000;
constexpr double thin = 0.4;

figure::ChartPanel seeds_panel(const Subject& subject, std::size_t contender, std::size_t steps) {
  figure::ChartPanel panel{.heading = subject.label(contender), .empty_note = "no runs"};
  const std::string_view colour = figure::style::films[0].colour;
  for (const Run* run : subject.replicates(contender))
    panel.series.push_back({.label = "one replicate",
                            .points = steps_over_film(subject, run->film.value, steps),
                            .look = {.stroke = {colour, "none"}},
                            .marks = figure::Marks::none,
                            .width = thin});
  if (const FilmEstimate& reference = subject.runs().reference.film; !reference.value.empty())
    panel.series.push_back(
        {.label = is_exact(subject.runs().reference.origin) ? "reference: exact" : "reference",
         .points = steps_over_film(subject, reference.value, steps),
         .look = {.stroke = {figure::style::ink, "none"}},
         .marks = figure::Marks::none,
         .width = 0.8});
  return panel;
}

// All finite values of the films that are drawn, ascending.
std::vector<double> drawn_values(const Subject& subject) {
  std::vector<double> values = subject.runs().reference.film.value;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    for (const Run* run : subject.replicates(k))
      values.insert(values.end(), run->film.value.begin(), run->film.value.end());
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::ranges::sort(values);
  return values;
}

double quantile(const std::vector<double>& ascending, double share) {
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

// Few values, such as fireflies, may lie beyond the axis, if they lie far beyond; it is logarithmic where a peak would
// press all the rest to the ground.
figure::Dimension value_dimension(const Subject& subject) {
  constexpr double beyond = 0.003, steep = 20, most_range = 1e4, far = 2;
  figure::Dimension dimension{.quantity = figure::film_axes(subject.scene).value};
  std::vector<double> values = drawn_values(subject);
  if (values.empty()) return dimension;
  double low = quantile(values, beyond), high = quantile(values, 1 - beyond);
  if (values.back() - values.front() <= far * (high - low)) {
    low = values.front();
    high = values.back();
  }
  std::erase_if(values, [](double value) { return !(value > 0); });
  if (!values.empty() && high > steep * quantile(values, 0.5)) {
    dimension.spacing = figure::Spacing::logarithmic;
    dimension.range =
        figure::Range{std::max(0.7 * quantile(values, beyond), high / most_range), 1.3 * high};
    return dimension;
  }
  const bool near_zero = low >= 0 && low < 0.6 * high;
  const double room = 0.05 * (high - (near_zero ? 0 : low));
  dimension.range = figure::usable({near_zero ? 0 : low - room, high + room});
  return dimension;
}

// On a logarithmic axis, of the lit ones.
std::size_t values_outside(const Subject& subject, const figure::Dimension& axis) {
  if (!axis.range) return 0;
  const bool has_zero = axis.spacing != figure::Spacing::logarithmic;
  const std::vector<double> values = drawn_values(subject);
  return static_cast<std::size_t>(std::ranges::count_if(values, [&](double value) {
    return value > axis.range->high || (value < axis.range->low && (has_zero || value > 0));
  }));
}

void write_seeds(Html& html, const Subject& subject) {
  std::size_t lines = 0;
  for (std::size_t k = 0; k < subject.contenders(); ++k) lines += subject.replicates(k).size() + 1;
  const std::size_t steps =
      std::clamp<std::size_t>(most_points / std::max<std::size_t>(1, lines), 40, most_spread_steps);
  figure::Chart chart{
      .x = film_dimension(subject), .y = value_dimension(subject), .panel_height = 70};
  const std::size_t outside = values_outside(subject, chart.y);
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    chart.panels.push_back(seeds_panel(subject, k, steps));
  write_panels(
      html, chart, "All replicates at the last budget",
      "The film of every seed of each contender, one over the other, with the reference.",
      "Every replicate of each contender as a thin line, the reference as a thick one. "
      "Lines that fan out are noise; lines that go together but leave the reference are "
      "bias; one line apart from the rest is a run that has missed something." +
          std::string(chart.y.spacing == figure::Spacing::logarithmic
                          ? " The axis is logarithmic, and what is dark is left out."
                          : "") +
          (outside > 0 ? fmt::format(" Beyond the axis {} {}.", outside == 1 ? "is" : "are",
                                     counted(outside, "value"))
                       : ""));
}

// Replicates that happen to agree in a bin have a ratio near zero, which nobody needs to see.
figure::Range ratio_range(const std::vector<SeedSpread>& spreads) {
  double low = 1, high = 1;
  for (const SeedSpread& spread : spreads)
    for (const double ratio : spread.ratio)
      if (ratio > 0) {
        low = std::min(low, ratio);
        high = std::max(high, ratio);
      }
  return {0.8 * std::clamp(low, 0.1, 0.4), 1.25 * std::clamp(high, 2.5, 100.)};
}

void write_ratios(Html& html, const Subject& subject, const std::vector<SeedSpread>& spreads) {
  figure::Chart chart{.x = film_dimension(subject),
                      .y = {.quantity = {"spread / claimed", ""},
                            .spacing = figure::Spacing::logarithmic,
                            .range = ratio_range(spreads)},
                      .panel_height = 62};
  for (std::size_t k = 0; k < spreads.size(); ++k) {
    figure::ChartPanel panel{.heading = subject.label(k),
                             .empty_note = "not known: fewer than two replicates claim errors"};
    if (spreads[k].is_known()) {
      panel.band = {spreads[k].expected.low, spreads[k].expected.high};
      panel.guides = {{1, ""}};
    }
    panel.series.push_back({.label = "",
                            .points = steps_over_film(subject, spreads[k].ratio, most_spread_steps),
                            .look = {.stroke = {figure::style::films[0].colour, "none"}},
                            .marks = figure::Marks::none});
    chart.panels.push_back(std::move(panel));
  }
  write_panels(
      html, chart, "Spread between seeds over claimed standard error",
      "The ratio of the standard deviation over seeds to the standard error that runs claim.",
      "For each bin, the standard deviation over replicates divided by the root mean square of the "
      "standard errors that they claim: what R-hat is for a functional, between seeds over within "
      "a "
      "run. Above 1, seeds differ by more than they claim. The shade holds 95 % of the bins of a "
      "contender whose claims are right, so one in twenty outside says nothing.");
}

void write_spread_table(Html& html, const Subject& subject,
                        const std::vector<SeedSpread>& spreads) {
  std::vector<double> pooled;
  std::vector<std::string> expected, beyond;
  for (const SeedSpread& spread : spreads) {
    pooled.push_back(spread.pooled);
    expected.push_back(spread.is_known() ? rounded(spread.expected) : "");
    beyond.push_back(spread.is_known() ? fmt::format("{} of {}", spread.beyond, spread.bins)
                                       : std::string(unknown_number));
  }
  Table table = named_rows("Spread between seeds over claimed standard error, at the last budget.",
                           "contender", subject.labels());
  const std::string bins = subject.bins();
  table.add_column({fmt::format("all {} together", bins)}, aligned(pooled));
  table.add_column({fmt::format("95 % of {} expected in", bins), Kind::interval}, expected);
  table.add_column({bins + " outside"}, beyond);
  write_table(html, table);
}

void write_words(Html& html, const Subject& subject, const std::vector<SeedSpread>& spreads) {
  std::vector<std::string> wide, narrow;
  for (std::size_t k = 0; k < spreads.size(); ++k)
    if (spreads[k].is_known()) (spreads[k].is_wide() ? wide : narrow).push_back(subject.label(k));
  if (!wide.empty())
    html.element("p", fmt::format("Significant: the seeds of {} lie farther apart than their error "
                                  "bars claim; do not rely on these bars.",
                                  listed(wide)));
  if (!narrow.empty())
    html.element("p",
                 fmt::format("Not significant: the seeds of {} lie no farther apart than their "
                             "error bars claim, as far as {} can tell.",
                             listed(narrow), counted(subject.runs().replicates, "replicate")),
                 {{"class", "note"}});
}

std::string r_hat_of(const Rendering& details, const std::string& functional) {
  for (const FunctionalRecord& record : details.chains_record->functionals)
    if (record.name == functional && std::isfinite(record.r_hat))
      return fmt::format("{:.3f}", record.r_hat);
  return unknown_number;
}

void write_r_hat(Html& html, const Subject& subject) {
  std::vector<std::string> names, functionals;
  std::vector<const Rendering*> records;
  for (const std::size_t k : chain_contenders(subject)) {
    const Rendering* details = subject.details(k);
    if (!details->chains_record) continue;
    names.push_back(subject.label(k));
    records.push_back(details);
    for (const FunctionalRecord& record : details->chains_record->functionals)
      if (std::ranges::find(functionals, record.name) == functionals.end())
        functionals.push_back(record.name);
  }
  if (records.empty()) return;
  Table table = named_rows(
      "R-hat of functionals of the states, rank-normalized and split, over the chains of the first "
      "replicate. Above 1.01 the chains have not mixed; a functional that never changes has none.",
      "contender", names);
  for (const std::string& functional : functionals) {
    std::vector<std::string> cells;
    for (const Rendering* details : records) cells.push_back(r_hat_of(*details, functional));
    table.add_column({std::string(spoken_functional(functional))}, cells);
  }
  html.element("h3", "Chains within a run: R-hat");
  write_table(html, table);
}

}  // namespace

void write_spread(Html& html, const Subject& subject) {
  std::vector<SeedSpread> spreads;
  for (std::size_t k = 0; k < subject.contenders(); ++k) {
    spreads.push_back(spread_of(WholeReplicates(subject, k, subject.last_budget()).runs()));
    if (subject.is_image()) spreads.back().ratio.clear();
  }
  const bool some = std::ranges::any_of(spreads, &SeedSpread::is_known);
  if (!subject.is_image()) write_seeds(html, subject);
  if (some) {
    if (!subject.is_image()) write_ratios(html, subject, spreads);
    write_words(html, subject, spreads);
    write_spread_table(html, subject, spreads);
  } else {
    html.element("p",
                 "The spread between seeds is not known: it takes at least two replicates that "
                 "claim errors.",
                 {{"class", "note"}});
  }
  write_r_hat(html, subject);
}

}  // namespace wander::report
