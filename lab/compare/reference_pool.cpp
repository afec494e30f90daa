#include "lab/compare/reference_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/film_pool.h"
#include "lab/wording.h"
#include "statistics/number_text.h"
#include "statistics/squared.h"

namespace wander::compare {

namespace {

double unit_of(const FilmEstimate& a, const FilmEstimate& b) {
  double unit = 0;  // squares stay finite
  for (const FilmEstimate* film : {&a, &b})
    for (const double x : film->value) unit = std::max(unit, std::abs(x));
  return unit > 0 ? unit : 1;
}

bool is_reliable(const FilmEstimate& film, std::size_t bin) {
  return (film.reliable.empty() || film.reliable[bin]) && std::isfinite(film.standard_error[bin]);
}

bool is_testable(const FilmEstimate& a, const FilmEstimate& b, std::size_t bin) {
  if (a.value[bin] == 0 && b.value[bin] == 0) return false;
  const bool of_a = is_reliable(a, bin), of_b = is_reliable(b, bin);
  return (of_a && of_b) || (of_a && b.value[bin] == 0) || (of_b && a.value[bin] == 0);
}

Measurement measurement_of(const FilmEstimate& film, std::size_t bin, double unit) {
  const bool known = is_reliable(film, bin);
  return {film.value[bin] / unit, known ? film.standard_error[bin] / unit : 0,
          film.degrees_of_freedom};
}

// Variances of weighted films, summed over bins, in squares of `unit`.
double variance_of(const FilmEstimate& film, double weight, double unit) {
  double sum = 0;
  for (const double error : film.standard_error) sum += squared(weight * error / unit);
  return sum;
}

// The factor on squares by which two films differ more than they claim; at least 1.
double excess(const FilmEstimate& a, const FilmEstimate& b, double unit) {
  double difference = 0;
  for (std::size_t j = 0; j < a.value.size(); ++j)
    difference += squared((a.value[j] - b.value[j]) / unit);
  const double claimed = variance_of(a, 1, unit) + variance_of(b, 1, unit);
  return claimed > 0 ? std::max(1.0, difference / claimed) : 1;
}

FilmEstimate weighted_mean(const FilmEstimate& a, const FilmEstimate& b, double of_a,
                           double growth) {
  const double of_b = 1 - of_a, unit = unit_of(a, b);
  FilmEstimate mean = a;
  mean.reliable.resize(mean.value.size());
  for (std::size_t j = 0; j < mean.value.size(); ++j) {
    mean.value[j] = of_a * a.value[j] + of_b * b.value[j];
    mean.standard_error[j] =
        std::sqrt(growth) * std::hypot(of_a * a.standard_error[j], of_b * b.standard_error[j]);
    mean.reliable[j] = is_reliable(a, j) && is_reliable(b, j);
  }
  // Of a sum of variances [Welch 1947].
  const double va = variance_of(a, of_a, unit), vb = variance_of(b, of_b, unit);
  const double shares = squared(va) / a.degrees_of_freedom + squared(vb) / b.degrees_of_freedom;
  if (shares > 0) mean.degrees_of_freedom = squared(va + vb) / shares;
  return mean;
}

std::string text_of(const Part& part) {
  double samples = 0, seconds = 0;
  for (const Rendering& run : part.runs) {
    samples += static_cast<double>(run.samples);
    seconds += run.seconds;
  }
  return fmt::format("{} independent {} of {} ({} samples, {})", part.runs.size(),
                     part.runs.size() == 1 ? "run" : "runs", part.made_by, count_in_words(samples),
                     duration_in_words(seconds));
}

std::string disagreement(const Part& a, const Part& b, const Decision& decision) {
  return fmt::format(
      "The two methods that made the reference, {} and {}, do not agree ({}; by chance once in "
      "{:.0f} times): at least one misses light, or has too little of it, so that no error here "
      "can "
      "be trusted; give larger budgets (-b), which make a longer reference, or --reference FILE.",
      a.made_by, b.made_by, decision.detail, 1 / false_disagreement);
}

Reference of_one(const Part& part) {
  return {pooled_film(part.runs),
          "the mean of " + text_of(part),
          {fmt::format("The reference was made by {} alone, and no other method confirms it.",
                       part.made_by)}};
}

}  // namespace

Decision agreement(const FilmEstimate& a, const FilmEstimate& b) {
  const double unit = unit_of(a, b);
  std::vector<Measurement> of_a, of_b;
  std::vector<std::size_t> bins;
  for (std::size_t j = 0; j < a.value.size(); ++j) {
    if (!is_testable(a, b, j)) continue;
    of_a.push_back(measurement_of(a, j, unit));
    of_b.push_back(measurement_of(b, j, unit));
    bins.push_back(j);
  }
  if (bins.empty()) return {.test = "nothing to compare", .passed = true};
  Decision decision = welch_tests(of_a, of_b, false_disagreement);
  const Measurement &x = of_a[decision.worst], &y = of_b[decision.worst];
  decision.worst = bins[decision.worst];
  decision.detail =
      fmt::format("in {}, {} ± {} and {} ± {}", place_in_words(a.shape, decision.worst),
                  number_text(unit * x.value, 4), number_text(unit * x.standard_error, 2),
                  number_text(unit * y.value, 4), number_text(unit * y.standard_error, 2));
  return decision;
}

Reference pooled_reference(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  if (parts.size() == 1) return of_one(first);
  const Part& second = parts.back();
  const FilmEstimate a = pooled_film(first.runs), b = pooled_film(second.runs);
  const double share = first.weight / (first.weight + second.weight);
  const Decision decision = agreement(a, b);
  const double growth = decision.passed ? 1 : excess(a, b, unit_of(a, b));
  Reference reference{
      weighted_mean(a, b, share, growth),
      fmt::format("the mean of {}, weight {}, and {}, weight {}", text_of(first),
                  number_text(share, 2), text_of(second), number_text(1 - share, 2))};
  if (!decision.passed) reference.doubts.push_back(disagreement(first, second, decision));
  return reference;
}

}  // namespace wander::compare
