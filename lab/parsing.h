// The small languages of the command line.  Each parser throws UsageError that says what is
// allowed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/dials.h"
#include "work/session.h"

namespace wander {

// The parts between the separators; an empty text is one empty part.
std::vector<std::string_view> split(std::string_view text, char separator);

// `2000000`, `300k`, `5M`, `2G`: a whole number of one or more, or none.
std::optional<std::uint64_t> sample_count_in(std::string_view text);
// `2000000`, `300k`, `5M`, `2G` samples; `1500ms`, `30s`, `5min`, `2h` of wall time, `30cpu-s` of
// processor time; `error<0.01`, `error<1%` of the film.
Budget parse_budget(std::string_view text);

// `auto` (no weights) or `WORD=WEIGHT,...` with the words of the catalogue of mutations.  What is
// not named is not used.
MutationWeights parse_mutations(std::string_view text);
// What --mutations takes, in words.
std::string mutations_help();

inline constexpr std::array<std::string_view, 2> estimator_words{"kelemen", "expected"};
StepEstimator parse_estimator(std::string_view text);

inline constexpr std::array<std::string_view, 3> normalization_words{"seed", "least-squares",
                                                                     "bridge"};
NormalizationMethod parse_normalization(std::string_view text);

inline constexpr std::array<std::string_view, 2> film_words{"chains", "pooled"};
FilmParts parse_film(std::string_view text);

inline constexpr std::array<std::string_view, 2> target_words{"even", "light"};
Target parse_target(std::string_view text);

// A number above zero, and no larger than `most`.
double parse_positive(std::string_view what, std::string_view text, double most);
// Seconds between two checkpoints; 0: none are kept.
double parse_checkpoint_interval(std::string_view text);
// In stops.
double parse_exposure(std::string_view text);
// `float` or `double`.
Precision parse_precision(std::string_view text);
// A share of steps, above 0 and below 1.
double parse_large_step(std::string_view text);
// A factor on how far small moves go, from 0.001 to 100, or `auto`, which is none.
std::optional<double> parse_kernel(std::string_view text);

std::uint64_t parse_seed(std::string_view text);
int parse_threads(std::string_view text);
int parse_max_vertices(std::string_view text);
// A whole number from `low` to `high`; `what` names it in the message.
std::uint64_t parse_count(std::string_view what, std::string_view text, std::uint64_t low,
                          std::uint64_t high);
// A number above 0 and below 1, also in percent.
double parse_share(std::string_view what, std::string_view text);
// `A:B`, two whole numbers from 0 to 2^53.
std::pair<std::uint64_t, std::uint64_t> parse_pair(std::string_view what, std::string_view text);
// `84mm`, `8.4cm`, `3.3in`, `238pt` or `320px` (96 to the inch), from 60 mm to 1 m: in points.
double parse_figure_width(std::string_view text);
// Pixels to the inch, from 36 to 1200.
double parse_resolution(std::string_view what, std::string_view text);

}  // namespace wander
