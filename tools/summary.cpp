#include "tools/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "lab/reference_name.h"
#include "lab/wording.h"
#include "mlt/watch/functional_words.h"
#include "statistics/number_text.h"

namespace wander {

namespace {

// Runs 1 to N of a job array are the usual case.
std::string seeds_in_words(const Rendering& rendering) {
  const auto& runs = rendering.merged;
  if (runs.size() < 2) return fmt::format(", seed {}", rendering.seed);
  const std::uint64_t first = runs.front().seed, last = runs.back().seed;
  if (last - first + 1 == runs.size())
    return fmt::format(", {} runs of seeds {} to {}", runs.size(), first, last);
  return fmt::format(", {} runs of seeds between {} and {}", runs.size(), first, last);
}

// Few enough for all digits.
std::string counted(int count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string work_line(const Rendering& rendering) {
  if (const std::string origin = origin_of(rendering); !origin.empty())
    return fmt::format("reference: {}\n", origin);
  std::string line =
      fmt::format("{}: {}", rendering.method, counted_in_words(rendering.samples, "sample"));
  if (rendering.seconds > 0) {
    line += fmt::format(" in {} ({}/s)", duration_in_words(rendering.seconds),
                        count_in_words(static_cast<double>(rendering.samples) / rendering.seconds));
    if (rendering.seed_seconds > 0)
      line += fmt::format(", of which seed pass {}", duration_in_words(rendering.seed_seconds));
    line += "; " + counted(rendering.threads, "thread");
  }
  line += seeds_in_words(rendering);
  if (rendering.chains > 0)
    line += fmt::format("; {} in {}", counted(rendering.chains, "chain"),
                        counted(rendering.groups, "group"));
  if (rendering.complete) return line + "\n";
  return fmt::format("{}; INCOMPLETE, {} was interrupted\n", line,
                     rendering.merged.empty() ? "it" : "a part of it");
}

std::string film_lines(const FilmEstimate& film) {
  const std::string extent = extent_in_words(film.shape);
  if (film.value.empty()) return fmt::format("  film            {}\n", extent);
  const bool coloured = channels_of(film.shape) > 1;
  std::string text = fmt::format("  film            {}, mean {}{}\n", extent,
                                 coloured ? "luminance " : "", number_text(mean_value(film), 6));
  text += fmt::format("  relative error  {}\n", percent(relative_error(film)));
  text += fmt::format("  reliable        {} of {} {}", reliable_bins(film), film.value.size(),
                      coloured                ? "numbers"
                      : film.shape.size() > 1 ? "pixels"
                                              : "bins");
  if (std::isfinite(film.degrees_of_freedom))
    text += fmt::format(" ({} degrees of freedom)", number_text(film.degrees_of_freedom, 4));
  return text + '\n';
}

std::string normalization_lines(const Normalization& normalization) {
  std::string text = fmt::format("  normalization   {}", with_error(normalization));
  text += normalization.method.empty() ? "\n" : fmt::format(" ({})\n", normalization.method);
  for (const auto& [name, estimate] : normalization.estimates)
    text += fmt::format("    {:<15} {}\n", name, with_error(estimate));
  return text;
}

std::string number(double x, const char* unit) {
  return std::isnan(x) ? "-" : count_in_words(x) + unit;
}

// Of a large film the chains alone have no error bars.
std::string chains_error_in_words(const Rendering& rendering) {
  const auto& alone = rendering.chains_film;
  if (!alone || alone->standard_error.empty()) return ", the rest by the chains";
  return fmt::format(", the rest by the chains (alone {})", percent(relative_error(*alone)));
}

// What is the same in all states has no diagnostics, nor has a run that was interrupted early.
std::string chain_lines(const ChainsRecord& chains, double seconds) {
  std::string text;
  for (const FunctionalRecord& f : chains.functionals) {
    if (std::isnan(f.r_hat) && std::isnan(f.ess_bulk)) continue;
    text +=
        fmt::format("    {:<22} {:>7} {:>9} {:>9} {:>10}  {}\n", spoken_functional(f.name),
                    std::isnan(f.r_hat) ? "-" : fmt::format("{:.3f}", f.r_hat),
                    number(f.ess_bulk, ""), number(f.ess_tail, ""),
                    number(f.ess_bulk / seconds, ""), number(f.autocorrelation_time, " mutations"));
  }
  if (text.empty()) return text;
  return fmt::format("  {:<24} {:>7} {:>9} {:>9} {:>10}  autocorrelation\n", "chains", "R-hat",
                     "ESS bulk", "tail", "ESS/s") +
         text;
}

// The commonest reasons, as shares of all proposals.
std::string refusals(const MutationRecord& mutation) {
  constexpr std::size_t most_reasons = 3;
  std::vector<std::pair<std::string, std::uint64_t>> failures(mutation.failures.begin(),
                                                              mutation.failures.end());
  std::stable_sort(failures.begin(), failures.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  failures.resize(std::min(failures.size(), most_reasons));
  std::vector<std::string> parts;
  for (const auto& [reason, count] : failures)
    parts.push_back(
        fmt::format("{} {}", reason,
                    percent(static_cast<double>(count) / static_cast<double>(mutation.proposed))));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string mutation_lines(const std::vector<MutationRecord>& mutations) {
  std::string text =
      fmt::format("  {:<15} {:>10} {:>11}  rejected for\n", "mutation", "proposed", "acceptance");
  for (const MutationRecord& mutation : mutations)
    text += fmt::format("    {:<13} {:>10} {:>11}  {}\n", mutation.name,
                        count_in_words(static_cast<double>(mutation.proposed)),
                        percent(mutation.mean_acceptance), refusals(mutation));
  return text;
}

std::string summary_of(const Rendering& rendering) {
  std::string text = work_line(rendering) + film_lines(rendering.film);
  if (rendering.adaptation && rendering.adaptation->kernel != 1)
    text += fmt::format("  adapted         small moves go {} times as far as usual\n",
                        rendering.adaptation->kernel);
  if (rendering.pooling && rendering.pooling->samples > 0)
    text += fmt::format("  pooled          {} of the light by {} samples{}\n",
                        percent(rendering.pooling->light_of_samples),
                        count_in_words(static_cast<double>(rendering.pooling->samples)),
                        chains_error_in_words(rendering));
  if (rendering.normalization) text += normalization_lines(*rendering.normalization);
  if (rendering.chains_record) text += chain_lines(*rendering.chains_record, rendering.seconds);
  if (!rendering.mutations.empty()) text += mutation_lines(rendering.mutations);
  return text;
}

}  // namespace wander
