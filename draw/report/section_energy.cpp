// Where the light comes from: by path length for every contender, by path class for chains.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "draw/figure/film_series.h"
#include "draw/report/chart_pages.h"
#include "draw/report/class_shares.h"
#include "draw/report/embedding.h"
#include "draw/report/energy.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"

namespace wander::report {
namespace {

using Energies = std::vector<std::map<int, compare::Measured>>;  // by contender

std::set<int> lengths_of(const Energies& energies) {
  std::set<int> lengths;
  for (const auto& energy : energies)
    for (const auto& [vertices, light] : energy) lengths.insert(vertices);
  return lengths;
}

void write_chart(Html& html, const Subject& subject, const Energies& energies) {
  const std::set<int> lengths = lengths_of(energies);
  const auto count = static_cast<double>(energies.size());
  figure::ChartPanel panel{.empty_note = "no light"};
  for (std::size_t k = 0; k < energies.size(); ++k) {
    figure::Series series{.label = subject.label(k),
                          .look = figure::look_of(k),
                          .connection = figure::Connection::none};
    for (const auto& [vertices, light] : energies[k]) {
      figure::Point point{.x = vertices + 0.5 * ((static_cast<double>(k) + 0.5) / count - 0.5),
                          .y = light.value};
      if (std::isfinite(light.interval.low))
        point.y_interval = figure::Range{light.interval.low, light.interval.high};
      series.points.push_back(point);
    }
    panel.series.push_back(std::move(series));
  }
  write_figure(
      html,
      chart_document(
          {.x = {.quantity = {"vertices of the path, both ends counted", ""},
                 .spacing = figure::Spacing::whole,
                 .range = figure::Range{*lengths.begin() - 0.5, *lengths.rbegin() + 0.5}},
           .y = {.quantity = {"mean over the film", subject.unit_of_bins()},
                 .spacing = figure::Spacing::logarithmic},
           .panels = {std::move(panel)}},
          "Light by path length",
          "For each contender the mean of the film that paths of each length make."),
      "The mean over the film of the light of paths with so many vertices, in colour of its "
      "luminance, over all replicates at the last budget: the lengths sum to b. Bars are 95 % "
      "intervals, and contenders stand side by side so that bars do "
      "not hide one another. Contenders that are right agree at every length; one that is low at a "
      "length misses paths of it.");
}

// Lengths that the intervals of two contenders put apart.
std::vector<std::string> disagreements(const Subject& subject, const Energies& energies) {
  std::vector<std::string> found;
  for (const int vertices : lengths_of(energies))
    for (std::size_t a = 0; a < energies.size(); ++a)
      for (std::size_t b = a + 1; b < energies.size(); ++b) {
        const auto x = energies[a].find(vertices), y = energies[b].find(vertices);
        if (x == energies[a].end() || y == energies[b].end()) continue;
        if (x->second.interval.high < y->second.interval.low ||
            y->second.interval.high < x->second.interval.low)
          found.push_back(fmt::format("{} and {} at {} vertices", subject.label(a),
                                      subject.label(b), vertices));
      }
  return found;
}

void write_words(Html& html, const Subject& subject, const Energies& energies) {
  if (subject.runs().replicates < 2 || energies.size() < 2) {
    html.element("p",
                 "Whether contenders agree is not known: it takes two of them, and two replicates "
                 "of each.",
                 {{"class", "note"}});
    return;
  }
  std::vector<std::string> found = disagreements(subject, energies);
  constexpr std::size_t most_named = 6;
  const std::size_t more = found.size() > most_named ? found.size() - most_named : 0;
  if (more > 0) {
    found.resize(most_named);
    found.push_back(fmt::format("{} more", more));
  }
  html.element("p",
               found.empty() ? "Not significant: at no length do the 95 % intervals of two "
                               "contenders lie apart."
                             : fmt::format("The 95 % intervals lie apart of {}. Where many pairs "
                                           "are compared, a few do so by chance.",
                                           listed(found)),
               {{"class", "note"}});
}

void write_lengths(Html& html, const Subject& subject, const Energies& energies) {
  const std::set<int> lengths = lengths_of(energies);
  std::vector<std::string> names;
  for (const int vertices : lengths) names.push_back(fmt::format("{}", vertices));
  Table table = named_rows(
      "Mean over the film, in colour of its luminance, by the number of vertices of the paths; "
      "95 % intervals over replicates.",
      "vertices", names);
  for (std::size_t k = 0; k < energies.size(); ++k) {
    std::vector<std::string> cells;
    for (const int vertices : lengths) {
      const auto found = energies[k].find(vertices);
      cells.push_back(found == energies[k].end() ? "none" : with_interval(found->second));
    }
    table.add_column({subject.label(k) + ", " + subject.unit_of_bins()}, cells);
  }
  write_folded(html, "Light by path length, in figures", table);
}

}  // namespace

void write_energy(Html& html, const Subject& subject) {
  Energies energies;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    energies.push_back(energy_by_length(WholeReplicates(subject, k, subject.last_budget()).runs()));
  if (lengths_of(energies).empty()) {
    html.element("p", "The films hold no light of any length, or were not kept by length.",
                 {{"class", "note"}});
  } else {
    write_chart(html, subject, energies);
    write_words(html, subject, energies);
    write_lengths(html, subject, energies);
  }
  write_class_shares(html, subject);
}

}  // namespace wander::report
