#include "lab/parsing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lab/failure.h"
#include "lab/nearest.h"

namespace wander {

namespace {

// The whole text as one number; none when anything else is in it.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

template <class Number>
Number number_between(std::string_view what, std::string_view text, Number low, Number high) {
  const auto number = number_in<Number>(text);
  if (!number || *number < low || *number > high)
    throw UsageError(
        fmt::format("{} '{}': allowed are whole numbers from {} to {}", what, text, low, high));
  return *number;
}

struct Unit {
  std::string_view suffix;
  double factor;
};
constexpr std::array time_units{Unit{"ms", 1e-3}, Unit{"min", 60}, Unit{"h", 3600}, Unit{"s", 1}};
constexpr std::array sample_units{Unit{"k", 1e3}, Unit{"M", 1e6}, Unit{"G", 1e9}, Unit{"", 1}};

// A share between 0 and 1, also in percent.
std::optional<double> share_in(std::string_view text) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const auto number = number_in<double>(text);
  const double share = number.value_or(0) / (is_percent ? 100 : 1);
  if (!(share > 0 && share < 1)) return std::nullopt;
  return share;
}

// A positive number followed by one of the units, in terms of the base unit.
std::optional<double> quantity_in(std::string_view text, std::span<const Unit> units) {
  for (const Unit& unit : units) {
    if (!text.ends_with(unit.suffix)) continue;
    const auto number = number_in<double>(text.substr(0, text.size() - unit.suffix.size()));
    if (!number || !std::isfinite(*number) || !(*number > 0)) return std::nullopt;
    return *number * unit.factor;
  }
  return std::nullopt;
}

// Wall time, or processor time where `cpu-` stands before the unit.
std::optional<TimeBudget> time_in(std::string_view text) {
  constexpr std::string_view of_processors = "cpu-";
  const std::size_t found = text.find(of_processors);
  if (found == std::string_view::npos) {
    const auto seconds = quantity_in(text, time_units);
    return seconds ? std::optional(TimeBudget{*seconds}) : std::nullopt;
  }
  const std::string number(text.substr(0, found)), unit(text.substr(found + of_processors.size()));
  if (!number_in<double>(number)) return std::nullopt;
  const auto seconds = quantity_in(number + unit, time_units);
  return seconds ? std::optional(TimeBudget{*seconds, TimeKind::processor}) : std::nullopt;
}

// LOW..HIGH, or one number where the parameter is one.
ParameterSetting setting_in(std::string_view text, std::string_view word) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::vector<ParameterFacts> known = parameters_of(word);
  std::vector<std::string_view> names;
  for (const ParameterFacts& each : known) names.push_back(each.name);
  const auto found = std::ranges::find(known, name, &ParameterFacts::name);
  if (known.empty())
    throw UsageError(fmt::format("--mutations: {} has no parameter that can be set", word));
  if (found == known.end())
    throw UsageError(fmt::format("--mutations: {}",
                                 unknown_word(fmt::format("parameter of {}", word), name, names)));
  const std::string_view value = equals == std::string_view::npos ? "" : text.substr(equals + 1);
  const std::size_t dots = value.find("..");
  const auto low = number_in<double>(value.substr(0, dots));
  const auto high = found->is_range() && dots != std::string_view::npos
                        ? number_in<double>(value.substr(dots + 2))
                        : low;
  const bool is_one = dots == std::string_view::npos;
  if (!low || !high || is_one == found->is_range() || !(*low > 0) || !(*high <= found->most) ||
      !(found->is_range() ? *low < *high : true))
    throw UsageError(
        fmt::format("--mutations: '{}': allowed is {}={} above 0, up to {} ({}; usually {})", text,
                    name, found->is_range() ? "LOW..HIGH" : "X", found->most, found->meaning,
                    found->is_range() ? fmt::format("{}..{}", found->smallest, found->largest)
                                      : fmt::format("{}", found->smallest)));
  return {std::string(name), *low, *high};
}

// WORD=WEIGHT, with parameters after it.
MutationWeight weight_in(std::string_view item) {
  std::vector<std::string_view> parts = split(item, ':');
  const std::size_t equals = parts.front().find('=');
  const std::string_view word = parts.front().substr(0, equals);
  const std::vector<std::string_view> words = mutation_words();
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw UsageError(fmt::format("--mutations: {}", unknown_word("mutation", word, words)));
  const auto weight = equals == std::string_view::npos
                          ? std::nullopt
                          : number_in<double>(parts.front().substr(equals + 1));
  if (!weight || !std::isfinite(*weight) || *weight < 0)
    throw UsageError(fmt::format(
        "--mutations: '{}': allowed is {}=WEIGHT with a weight of zero or more", item, word));
  MutationWeight result{std::string(word), *weight};
  for (const std::string_view part : std::span(parts).subspan(1)) {
    ParameterSetting setting = setting_in(part, word);
    if (std::ranges::find(result.parameters, setting.name, &ParameterSetting::name) !=
        result.parameters.end())
      throw UsageError(fmt::format("--mutations: '{}' of {} is given twice", setting.name, word));
    result.parameters.push_back(std::move(setting));
  }
  return result;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::uint64_t> sample_count_in(std::string_view text) {
  const auto samples = quantity_in(text, sample_units);
  // Beyond 2^53 a count is no longer exact; 1.1k is 1100 even where its product is not.
  const double count = std::round(samples.value_or(0));
  if (samples && count >= 1 && count <= 0x1p53 && std::abs(*samples - count) <= 1e-12 * count)
    return static_cast<std::uint64_t>(count);
  return std::nullopt;
}

Budget parse_budget(std::string_view text) {
  constexpr std::string_view error = "error<";
  if (text.starts_with(error)) {
    if (const auto target = share_in(text.substr(error.size()))) return ErrorBudget{*target};
    throw UsageError(
        fmt::format("budget '{}': allowed are relative errors above 0 and below 1, such as "
                    "error<0.01 or error<1%",
                    text));
  }
  if (const auto time = time_in(text)) return *time;
  if (const auto count = sample_count_in(text)) return SampleBudget{*count};
  throw UsageError(
      fmt::format("budget '{}': allowed are whole numbers of samples (2000000, 300k, 5M), wall "
                  "time (1500ms, 30s, "
                  "5min, 2h), processor time (30cpu-s) and a relative error of the film "
                  "(error<0.01, error<1%)",
                  text));
}

MutationWeights parse_mutations(std::string_view text) {
  if (text == "auto") return {};
  MutationWeights weights;
  for (const std::string_view item : split(text, ',')) {
    auto weight = weight_in(item);
    if (std::ranges::find(weights, weight.word, &MutationWeight::word) != weights.end())
      throw UsageError(fmt::format("--mutations: '{}' is given twice", weight.word));
    weights.push_back(std::move(weight));
  }
  if (std::none_of(weights.begin(), weights.end(), [](const auto& w) { return w.weight > 0; }))
    throw UsageError("--mutations: at least one weight must be above zero");
  return weights;
}

StepEstimator parse_estimator(std::string_view text) {
  constexpr std::array estimators{StepEstimator::kelemen, StepEstimator::expected};
  const auto found = std::find(estimator_words.begin(), estimator_words.end(), text);
  if (found == estimator_words.end())
    throw UsageError(unknown_word("estimator", text, estimator_words));
  return estimators[static_cast<std::size_t>(found - estimator_words.begin())];
}

NormalizationMethod parse_normalization(std::string_view text) {
  const auto found = std::find(normalization_words.begin(), normalization_words.end(), text);
  if (found == normalization_words.end())
    throw UsageError(unknown_word("normalization", text, normalization_words));
  return static_cast<NormalizationMethod>(found - normalization_words.begin());
}

FilmParts parse_film(std::string_view text) {
  const auto found = std::find(film_words.begin(), film_words.end(), text);
  if (found == film_words.end()) throw UsageError(unknown_word("film", text, film_words));
  return static_cast<FilmParts>(found - film_words.begin());
}

Target parse_target(std::string_view text) {
  const auto found = std::find(target_words.begin(), target_words.end(), text);
  if (found == target_words.end()) throw UsageError(unknown_word("target", text, target_words));
  return static_cast<Target>(found - target_words.begin());
}

double parse_positive(std::string_view what, std::string_view text, double most) {
  const auto number = number_in<double>(text);
  if (!number || !(*number > 0) || *number > most)
    throw UsageError(
        fmt::format("{} '{}': allowed are numbers above 0, up to {}", what, text, most));
  return *number;
}

double parse_checkpoint_interval(std::string_view text) {
  const auto seconds = number_in<double>(text);
  if (seconds && *seconds >= 0 && *seconds <= 1e6) return *seconds;
  throw UsageError(fmt::format(
      "--checkpoint '{}': allowed are seconds, such as 60, up to 1e6; 0 keeps no checkpoint",
      text));
}

double parse_exposure(std::string_view text) {
  const auto stops = number_in<double>(text.starts_with('+') ? text.substr(1) : text);
  if (stops && *stops >= -100 && *stops <= 100) return *stops;
  throw UsageError(fmt::format(
      "--exposure '{}': allowed are stops from -100 to 100, such as 1 for twice as bright", text));
}

Precision parse_precision(std::string_view text) {
  std::vector<std::string_view> words;
  for (const Precision precision : precisions) {
    if (text == name_of(precision)) return precision;
    words.push_back(name_of(precision));
  }
  throw UsageError(unknown_word("precision", text, words));
}

double parse_large_step(std::string_view text) {
  const auto share = number_in<double>(text);
  if (share && *share > 0 && *share < 1) return *share;
  throw UsageError(
      fmt::format("--large-step '{}': allowed are numbers above 0 and below 1, such as 0.3", text));
}

std::optional<double> parse_kernel(std::string_view text) {
  if (text == "auto") return std::nullopt;
  const auto factor = number_in<double>(text);
  if (factor && *factor >= 0.001 && *factor <= 100) return factor;
  throw UsageError(fmt::format(
      "--kernel '{}': allowed are auto and factors from 0.001 to 100, such as 0.5", text));
}

std::string mutations_help() {
  std::string text = "auto (the default: all that the scene can use of";
  for (const std::string_view word : mutation_words())
    text += fmt::format(" {}={}", word, auto_weight_of(word));
  text +=
      "), or relative weights of some, as in bidirectional=1,lens=2; with parameters after a "
      "colon, "
      "as in lens=1:angle=1e-5..0.1; these are";
  for (const std::string_view word : mutation_words())
    for (const ParameterFacts& each : parameters_of(word))
      text += fmt::format(" {}:{}={}{}", word, each.name, each.smallest,
                          each.is_range() ? fmt::format("..{}", each.largest) : "");
  return text;
}

std::uint64_t parse_seed(std::string_view text) {
  return number_between<std::uint64_t>("seed", text, 0, std::numeric_limits<std::uint64_t>::max());
}

int parse_threads(std::string_view text) { return number_between("threads", text, 1, 1024); }

int parse_max_vertices(std::string_view text) {
  return number_between("--max-vertices", text, 2, 100000);
}

std::uint64_t parse_count(std::string_view what, std::string_view text, std::uint64_t low,
                          std::uint64_t high) {
  return number_between(what, text, low, high);
}

double parse_share(std::string_view what, std::string_view text) {
  if (const auto share = share_in(text)) return *share;
  throw UsageError(fmt::format(
      "{} '{}': allowed is a number above 0 and below 1, such as 0.01 or 1%", what, text));
}

std::pair<std::uint64_t, std::uint64_t> parse_pair(std::string_view what, std::string_view text) {
  constexpr std::uint64_t most = std::uint64_t{1} << 53;
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() != 2)
    throw UsageError(
        fmt::format("{} '{}': allowed are two whole numbers with a colon between", what, text));
  return {parse_count(what, parts[0], 0, most), parse_count(what, parts[1], 0, most)};
}

double parse_figure_width(std::string_view text) {
  constexpr double inch = 72, millimetre = inch / 25.4;
  constexpr std::array<Unit, 5> units{
      {{"mm", millimetre}, {"cm", 10 * millimetre}, {"in", inch}, {"pt", 1}, {"px", inch / 96}}};
  // Narrower figures have no room for their words.
  constexpr double least = 60 * millimetre, most = 1000 * millimetre, rounding = 1e-9;
  const auto width = quantity_in(text, units);
  if (!width || *width < least * (1 - rounding) || *width > most * (1 + rounding))
    throw UsageError(
        fmt::format("--width '{}': allowed is a length from 60mm to 1000mm, in mm, cm, in, pt or "
                    "px, such as 84mm",
                    text));
  return *width;
}

double parse_resolution(std::string_view what, std::string_view text) {
  const auto dpi = number_in<double>(text);
  if (!dpi || !(*dpi >= 36 && *dpi <= 1200))
    throw UsageError(fmt::format(
        "{} '{}': allowed are numbers from 36 to 1200, in pixels to the inch", what, text));
  return *dpi;
}

}  // namespace wander
