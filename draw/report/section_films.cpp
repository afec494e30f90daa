// The films of the contenders at the last budget, each with the reference.
#include <fmt/format.h>

#include <algorithm>

#include "core/film_statistics.h"
#include "draw/figure/film_figure.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/reference_name.h"
#include "lab/wording.h"

namespace wander::report {
namespace {

// No higher than half a page of paper, so that pages fill.
constexpr std::size_t films_per_figure = 3;

std::vector<figure::LabelledFilm> films_of(const Subject& subject) {
  std::vector<figure::LabelledFilm> films;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k))
      films.push_back({subject.label(k), *details});
  return films;
}

std::optional<figure::LabelledFilm> reference_of(const Subject& subject) {
  const compare::Reference& reference = subject.runs().reference;
  if (reference.film.value.empty()) return std::nullopt;
  Rendering rendering;
  rendering.film = reference.film;
  return figure::LabelledFilm{name_of_reference(reference.origin), rendering};
}

void write_panels(Html& html, const Subject& subject,
                  const std::vector<figure::LabelledFilm>& films) {
  for (std::size_t first = 0; first < films.size(); first += films_per_figure) {
    const auto begin = films.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(films_per_figure, films.size() - first);
    write_figure(
        html,
        figure::film_figure(
            {begin, begin + static_cast<std::ptrdiff_t>(count)},
            {.title = fmt::format("Films at the last budget, {}", subject.runs().budgets.back()),
             .axes = figure::film_axes(subject.scene),
             .inset = subject.scene,
             .reference = reference_of(subject),
             .layout = figure::Layout::panels}),
        "The first replicate of each contender: the line is the estimate of each bin, the shade "
        "its "
        "95 % interval, the thin line the reference. Where the error bars are right, the reference "
        "leaves the shade in about one bin of twenty.");
  }
}

// How far each of these films lies from the reference, and what it says itself.
void write_distances(Html& html, const Subject& subject) {
  const FilmEstimate& reference = subject.runs().reference.film;
  std::vector<std::string> names, held;
  std::vector<double> seen, claimed, chi2;
  std::vector<std::string> reliable;
  for (std::size_t k = 0; k < subject.contenders(); ++k) {
    const Rendering* details = subject.details(k);
    if (!details) continue;
    const FilmEstimate& film = details->film;
    names.push_back(subject.label(k));
    claimed.push_back(100 * relative_error(film));
    reliable.push_back(subject.is_image()
                           ? percent(static_cast<double>(reliable_bins(film)) /
                                     static_cast<double>(film.value.size()))
                           : fmt::format("{} of {}", reliable_bins(film), film.value.size()));
    const bool comparable = reference.shape == film.shape;
    const FilmComparison found =
        comparable ? film_comparison(film, reference)
                   : FilmComparison{not_known, not_known, not_known, not_known, 0};
    seen.push_back(100 * found.relative_rmse);
    chi2.push_back(found.chi2_per_degree);
    held.push_back(rounded(100 * found.covered_share));
  }
  const std::string bins = subject.bins(), bin = bins.substr(0, bins.size() - 1);
  Table table = named_rows(
      fmt::format("These films, one replicate each: the distance from the reference, and the error "
                  "that the film claims. χ² per {} is near 1 where claims hold.",
                  bin),
      "contender", names);
  table.add_column({"distance, %"}, aligned(seen));
  table.add_column({"claimed error, %"}, aligned(claimed));
  table.add_column({"χ² per " + bin}, aligned(chi2));
  table.add_column({bins + " whose interval holds the reference, %"}, held);
  table.add_column({"reliable " + bins}, reliable);
  write_table(html, table);
}

}  // namespace

void write_films(Html& html, const Subject& subject) {
  const std::vector<figure::LabelledFilm> films = films_of(subject);
  if (films.empty()) {
    html.element("p", "No contender reached the last budget: there are no films to show.",
                 {{"class", "note"}});
    return;
  }
  if (const std::string& origin = subject.runs().reference.origin; !origin.empty())
    html.element("p", fmt::format("The reference: {}.", origin));
  if (subject.is_image())
    write_pictures(html, subject);
  else
    write_panels(html, subject, films);
  write_distances(html, subject);
}

}  // namespace wander::report
