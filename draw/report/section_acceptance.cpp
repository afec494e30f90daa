// What became of proposals: by mutation, by the length of the path, and over the film.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/share_bars.h"
#include "draw/report/bins.h"
#include "draw/report/chart_pages.h"
#include "draw/report/numbers.h"
#include "draw/report/outcome_bars.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/wording.h"

namespace wander::report {
namespace {

constexpr std::size_t most_steps = 200;
// Of fewer proposals a mean says little.
constexpr std::uint64_t fewest_proposals = 1000;
constexpr double fewest_per_step = 100;

// The mutations of all contenders, each once: the same look wherever it occurs.
std::vector<std::string> mutations_of(const Subject& subject) {
  std::vector<std::string> names;
  for (const std::size_t k : chain_contenders(subject))
    for (const MutationRecord& mutation : subject.details(k)->mutations)
      if (std::ranges::find(names, mutation.name) == names.end()) names.push_back(mutation.name);
  return names;
}

figure::Look look_of(const std::vector<std::string>& names, const std::string& name) {
  return figure::look_of(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()));
}

void write_by_length(Html& html, const Subject& subject) {
  const std::vector<std::string> names = mutations_of(subject);
  figure::Range lengths{INFINITY, -INFINITY};
  figure::Chart chart{.y = {.quantity = {"mean acceptance", ""}, .range = figure::Range{0, 1.02}},
                      .panel_height = 70};
  for (const std::size_t k : chain_contenders(subject)) {
    figure::ChartPanel panel{.heading = subject.label(k),
                             .empty_note = "too few proposals at every length"};
    for (const MutationRecord& mutation : subject.details(k)->mutations) {
      figure::Series series{.label = figure::spoken(mutation.name),
                            .look = look_of(names, mutation.name)};
      for (const PathsRecord& paths : mutation.by_length)
        if (paths.proposed >= fewest_proposals) {
          series.points.push_back(
              {.x = static_cast<double>(paths.vertices), .y = paths.mean_acceptance});
          const double length = series.points.back().x;
          lengths = {std::min(lengths.low, length), std::max(lengths.high, length)};
        }
      if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
    chart.panels.push_back(std::move(panel));
  }
  chart.x = {.quantity = {"vertices of the path, both ends counted", ""},
             .spacing = figure::Spacing::whole,
             .range = lengths.low > lengths.high
                          ? figure::Range{1.5, 3.5}
                          : figure::Range{lengths.low - 0.5, lengths.high + 0.5}};
  write_panels(
      html, chart, "Mean acceptance by path length",
      "The mean acceptance of each mutation against the number of vertices of the path.",
      fmt::format("Mean acceptance of the proposals that were made from a path of so many "
                  "vertices; lengths with fewer than {} proposals are left out. A mutation "
                  "near zero at a length does not move the chain there.",
                  fewest_proposals));
}

void write_by_bin(Html& html, const Subject& subject) {
  const std::vector<std::string> names = mutations_of(subject);
  figure::Chart chart{.x = film_dimension(subject),
                      .y = {.quantity = {"mean acceptance", ""}, .range = figure::Range{0, 1.02}},
                      .panel_height = 70};
  for (const std::size_t k : chain_contenders(subject)) {
    figure::ChartPanel panel{.heading = subject.label(k), .empty_note = "no proposals"};
    for (const MutationRecord& mutation : subject.details(k)->mutations)
      panel.series.push_back(
          {.label = figure::spoken(mutation.name),
           .points = steps_over_film(subject, mutation.acceptance_per_bin,
                                     mutation.proposed_per_bin, fewest_per_step, most_steps),
           .look = look_of(names, mutation.name),
           .marks = figure::Marks::none});
    chart.panels.push_back(std::move(panel));
  }
  write_panels(
      html, chart, "Mean acceptance over the film",
      "The mean acceptance of each mutation against the position on the sensor.",
      "Mean acceptance of the proposals that were made while the path met the sensor there. "
      "Places with fewer than 100 proposals are left out. A dip is a place that chains enter "
      "and leave seldom.");
}

std::string microseconds(const MutationRecord& mutation) {
  return rounded(1e6 * mutation.seconds / static_cast<double>(mutation.proposed));
}

void write_mutations(Html& html, const Subject& subject) {
  std::vector<std::string> names, mutations, proposals, times, runs;
  std::vector<double> acceptance, accepted, jump;
  for (const std::size_t k : chain_contenders(subject))
    for (const MutationRecord& mutation : subject.details(k)->mutations) {
      const auto proposed = static_cast<double>(mutation.proposed);
      names.push_back(subject.label(k));
      mutations.push_back(figure::spoken(mutation.name));
      proposals.push_back(count_in_words(proposed));
      acceptance.push_back(100 * mutation.mean_acceptance);
      accepted.push_back(100 * static_cast<double>(mutation.accepted) / proposed);
      jump.push_back(1e3 * mutation.squared_jump);
      times.push_back(microseconds(mutation));
      runs.push_back(count_in_words(static_cast<double>(mutation.longest_rejection_run)));
    }
  Table table = named_rows(
      "Mutations of the first replicate at the last budget. The squared jump is "
      "the mean of a · |film(y) − film(x)|², the film being of length 1. Rejected in a row counts "
      "the proposals of this mutation alone that one chain rejected, one after the other.",
      "contender", names);
  table.add_column({"mutation", Kind::words}, mutations);
  table.add_column({"proposals"}, proposals);
  table.add_column({"mean acceptance, %"}, aligned(acceptance));
  table.add_column({"accepted, %"}, aligned(accepted));
  table.add_column({"squared jump, 10⁻³"}, aligned(jump));
  table.add_column({"time per proposal, µs"}, times);
  table.add_column({"most rejected in a row"}, runs);
  write_table(html, table);
}

}  // namespace

void write_acceptance(Html& html, const Subject& subject) {
  if (chain_contenders(subject).empty()) {
    html.element("p", "No contender is a Markov chain: nothing is proposed, accepted or rejected.",
                 {{"class", "note"}});
    return;
  }
  write_outcomes(html, subject);
  write_mutations(html, subject);
  write_by_length(html, subject);
  if (!subject.is_image()) write_by_bin(html, subject);
  html.element("p",
               "Not significant: consecutive proposals of a chain depend on one another, so these "
               "shares carry no intervals. Small differences between them mean nothing.",
               {{"class", "note"}});
}

}  // namespace wander::report
