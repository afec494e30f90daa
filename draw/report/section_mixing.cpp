// How fast chains forget: autocorrelation times, effective sample sizes, longest stays.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/interval_rows.h"
#include "draw/figure/share_bars.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/wording.h"
#include "mlt/watch/functional_words.h"

namespace wander::report {
namespace {

std::vector<std::size_t> recorded_contenders(const Subject& subject) {
  std::vector<std::size_t> found;
  for (const std::size_t k : chain_contenders(subject))
    if (subject.details(k)->chains_record) found.push_back(k);
  return found;
}

// What never changes has no autocorrelation.
bool is_measured(const FunctionalRecord& functional) {
  return std::isfinite(functional.autocorrelation_time);
}

// Draws so many steps apart tell of no shorter time.
std::string time_in_words(const FunctionalRecord& functional, const ChainsRecord& record) {
  if (!is_measured(functional)) return unknown_number;
  const auto stride = static_cast<double>(record.stride);
  if (record.stride > 1 && functional.autocorrelation_time <= stride) return "≤ " + rounded(stride);
  return rounded(functional.autocorrelation_time);
}

std::vector<figure::IntervalGroup> groups_of(const Subject& subject) {
  std::vector<figure::IntervalGroup> groups;
  for (const std::size_t k : recorded_contenders(subject))
    for (const FunctionalRecord& functional : subject.details(k)->chains_record->functionals) {
      if (!is_measured(functional)) continue;
      const std::string heading = std::string(spoken_functional(functional.name));
      auto group = std::ranges::find(groups, heading, &figure::IntervalGroup::heading);
      if (group == groups.end()) group = groups.insert(groups.end(), {heading, {}});
      group->rows.push_back(
          {.label = subject.label(k),
           .value = functional.autocorrelation_time,
           .look = figure::look_of(k),
           .note = time_in_words(functional, *subject.details(k)->chains_record)});
    }
  return groups;
}

void write_times(Html& html, const Subject& subject) {
  const std::vector<figure::IntervalGroup> groups = groups_of(subject);
  if (groups.empty()) return;
  figure::IntervalRows rows;
  rows.x.quantity = {"integrated autocorrelation time", "mutations of one chain"};
  rows.x.spacing = figure::Spacing::logarithmic;
  rows.groups = groups;
  const figure::Block block =
      figure::interval_block(std::move(rows), figure::block_width(figure_width));
  write_figure(
      html,
      figure::page("Integrated autocorrelation times",
                   "For each functional of the state the autocorrelation time of each "
                   "contender, in mutations.",
                   figure_width, {block}),
      "How many mutations of one chain are worth one independent draw, for the position "
      "on the sensor, the logarithm of the contribution f, and the numbers of vertices and "
      "of specular vertices. Farther left mixes faster, per mutation; a mutation of one "
      "method may cost more time than one of another. A functional with large times is what "
      "limits the run. Times marked ≤ are shorter than the draws are apart.");
}

void write_functionals(Html& html, const Subject& subject) {
  std::vector<std::string> names, functionals, bulk, tail, rate, times;
  for (const std::size_t k : recorded_contenders(subject)) {
    const Rendering& details = *subject.details(k);
    for (const FunctionalRecord& functional : details.chains_record->functionals) {
      const auto count = [](double value) {
        return std::isfinite(value) ? count_in_words(value) : std::string(unknown_number);
      };
      names.push_back(subject.label(k));
      functionals.push_back(std::string(spoken_functional(functional.name)));
      bulk.push_back(count(functional.ess_bulk));
      tail.push_back(count(functional.ess_tail));
      rate.push_back(count(functional.ess_bulk / details.seconds));
      times.push_back(time_in_words(functional, *details.chains_record));
    }
  }
  Table table = named_rows(
      "Effective sample sizes of all chains together, in the first replicate at "
      "the last budget. A dash: what never changes has none.",
      "contender", names);
  table.add_column({"functional", Kind::words}, functionals);
  table.add_column({"autocorrelation time, mutations"}, times);
  table.add_column({"ESS, bulk"}, bulk);
  table.add_column({"ESS, tail"}, tail);
  table.add_column({"ESS per second, 1/s"}, rate);
  write_table(html, table);
}

void write_stays(Html& html, const Subject& subject) {
  std::vector<std::string> names, chains, draws, strides, runs;
  for (const std::size_t k : recorded_contenders(subject)) {
    const Rendering& details = *subject.details(k);
    const ChainsRecord& record = *details.chains_record;
    names.push_back(subject.label(k));
    chains.push_back(fmt::format("{} in {}", details.chains, details.groups));
    draws.push_back(count_in_words(static_cast<double>(record.draws)));
    strides.push_back(count_in_words(static_cast<double>(record.stride)));
    runs.push_back(count_in_words(static_cast<double>(record.longest_rejection_run)));
  }
  Table table = named_rows(
      "The chains. Diagnostics rest on the recorded draws and do not resolve times below their "
      "distance. The longest stay is the most mutations, of any kind, that one chain made in a "
      "row without a move; a long one is a path that the chain could not leave.",
      "contender", names);
  table.add_column({"chains in groups"}, chains);
  table.add_column({"draws recorded of each"}, draws);
  table.add_column({"mutations between draws"}, strides);
  table.add_column({"longest stay at one path, mutations"}, runs);
  write_table(html, table);
}

void write_unrecorded(Html& html, const Subject& subject) {
  std::vector<std::string> names;
  for (const std::size_t k : chain_contenders(subject))
    if (!subject.details(k)->chains_record) names.push_back(subject.label(k));
  if (!names.empty())
    html.element("p",
                 fmt::format("Not known: no draws of the chains of {} are kept.", listed(names)),
                 {{"class", "note"}});
}

}  // namespace

void write_mixing(Html& html, const Subject& subject) {
  if (recorded_contenders(subject).empty()) {
    html.element("p", "No contender is a Markov chain: samples are independent.",
                 {{"class", "note"}});
    return;
  }
  write_times(html, subject);
  write_functionals(html, subject);
  write_stays(html, subject);
  write_unrecorded(html, subject);
  html.element("p",
               "Not significant: autocorrelation times come from one replicate and carry no "
               "interval; times that differ by less than about a third are as good as equal.",
               {{"class", "note"}});
}

}  // namespace wander::report
