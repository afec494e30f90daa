#include "draw/figure/meanings.h"

#include <fmt/format.h>

#include <algorithm>

namespace wander::figure {
namespace {

constexpr std::string_view grey = "#5a5a5a", middle = "#8c8c8c", pale = "#a8a8a8";
constexpr std::string_view tint = "#e9e9e9", light_tint = "#efefef", lightest_tint = "#f4f4f4";

constexpr std::array outcomes{
    OutcomeMark{accepted_word, "accepted", {Tile::plain, 3, 0, 0, "", style::accepted.colour}},
    OutcomeMark{refused_word,
                "rejected by the acceptance test",
                {Tile::line, 3, 45, 1.3, style::rejected.colour, "#fdebd3"}},
    OutcomeMark{"occluded", "occluded", {Tile::line, 2.4, -70, 0.6, grey, style::paper}},
    OutcomeMark{"missed_scene", "missed scene", {Tile::dash, 3.2, 0, 0.9, grey, style::paper}},
    OutcomeMark{"changed_class", "changed class", {Tile::line, 2.4, 0, 0.7, grey, tint}},
    OutcomeMark{"too_long", "too long", {Tile::cross, 3, 45, 0.5, grey, style::paper}},
    OutcomeMark{
        "zero_contribution", "zero contribution", {Tile::line, 3.4, 90, 1.4, middle, style::paper}},
    OutcomeMark{"not_reversible", "not reversible", {Tile::dot, 3.4, 45, 1, middle, light_tint}},
    OutcomeMark{"outside_range", "outside range", {Tile::cross, 2.6, 0, 0.5, grey, style::faint}},
    OutcomeMark{"solver_failed", "solver failed", {Tile::line, 4.4, -45, 1.6, pale, style::paper}},
    OutcomeMark{"not_finite", "not finite", {Tile::line, 1.6, 90, 0.4, grey, style::paper}},
    OutcomeMark{
        "not_applicable", "not applicable", {Tile::cross, 4.6, 20, 0.9, grey, lightest_tint}}};

// Outlines and solid shapes; lines, crosses and dots are of outcomes.
constexpr std::array<Fill, most_classes + 1> classes{
    {{Tile::ring, 4.2, 0, 0.6, grey, style::paper},
     {Tile::triangle, 4.2, 0, 0, grey, style::paper},
     {Tile::zigzag, 4.4, 0, 0.7, grey, lightest_tint},
     {Tile::square, 3.8, 0, 0, middle, style::paper},
     {Tile::plus, 4.2, 0, 0.8, grey, style::paper},
     {Tile::ring, 3.4, 0, 1.2, middle, tint},
     {Tile::zigzag, 4.4, 90, 0.7, grey, style::paper},
     {Tile::triangle, 4.2, 180, 0, middle, light_tint},
     {Tile::square, 4.2, 45, 0, grey, lightest_tint},
     {Tile::plain, 3, 0, 0, "", tint}}};

}  // namespace

std::span<const OutcomeMark> outcome_marks() { return outcomes; }

OutcomeMark mark_of_outcome(std::string_view outcome) {
  const auto found = std::ranges::find(outcomes, outcome, &OutcomeMark::outcome);
  if (found != outcomes.end()) return *found;
  return {outcome, outcome, {Tile::plain, 3, 0, 0, "", style::paper}};
}

std::span<const Fill> class_fills() { return classes; }

Fill unreliable_fill(std::string_view colour) { return {Tile::line, 3, -20, 0.6, colour, ""}; }

std::vector<MeantFill> all_fills() {
  std::vector<MeantFill> all{{"clear glass", clear_glass},
                             {"rough glass", rough_glass},
                             {"unreliable bin", unreliable_fill(style::neutral.colour)},
                             {"unknown outcome", mark_of_outcome("?").fill}};
  for (const OutcomeMark& mark : outcomes) all.push_back({std::string(mark.words), mark.fill});
  for (std::size_t k = 0; k < classes.size(); ++k)
    all.push_back({fmt::format("path class {}", k + 1), classes[k]});
  return all;
}

}  // namespace wander::figure
