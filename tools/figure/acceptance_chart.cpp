#include "tools/figure/acceptance_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "tools/figure/hatching.h"
#include "tools/figure/legend.h"
#include "tools/figure/style.h"
#include "tools/wording.h"

namespace wander::figure {
namespace {

constexpr double bar_height = 15, bar_gap = 17, legend_gap = 2, label_gap = 6;
constexpr std::string_view accepted_word = "accepted", refused_word = "metropolis";

struct Bar {
  std::string mutation;
  double steps = 0, acceptance = 0;        // acceptance: Σ a
  std::map<std::string, double> outcomes;  // word -> steps
};

// Only mutations that were tried, in their order.
std::vector<Bar> bars_of(const Steps& steps) {
  std::vector<Bar> bars;
  for (const std::string& name : steps.trajectory().mutations) bars.push_back({name, 0, 0, {}});
  steps.each([&](const Step& step) {
    const auto bar = std::ranges::find(bars, steps.mutation(step), &Bar::mutation);
    if (bar == bars.end()) return;
    bar->steps += 1;
    bar->acceptance += steps.trajectory().acceptance[step.index];
    bar->outcomes[steps.accepted(step) ? std::string(accepted_word)
                                       : std::string(steps.reason(step))] += 1;
  });
  std::erase_if(bars, [](const Bar& bar) { return bar.steps == 0; });
  return bars;
}

struct Outcome {
  std::string word;
  std::size_t hatch;  // that of its reason, the same in every figure
};

// Accepted first, then the reasons in the order of the trajectory, as far as they occur.
std::vector<Outcome> outcomes_of(const Steps& steps, const std::vector<Bar>& bars) {
  std::vector<Outcome> outcomes{{std::string(accepted_word), 0}};
  std::size_t failures = 0;
  for (const std::string& reason : steps.trajectory().reasons)
    if (reason != "none") outcomes.push_back({reason, reason == refused_word ? 0 : ++failures});
  std::erase_if(outcomes, [&](const Outcome& outcome) {
    return std::ranges::none_of(
        bars, [&](const Bar& bar) { return bar.outcomes.contains(outcome.word); });
  });
  return outcomes;
}

std::string spoken(std::string text) {
  std::ranges::replace(text, '_', ' ');
  return text == refused_word ? "refused by the acceptance test" : text;
}

// Accepted and refused have the colours of proposals everywhere; failures are told by hatches.
std::string paint_of(Svg& svg, const Outcome& outcome) {
  if (outcome.word == accepted_word) return std::string(style::accepted.colour);
  return define_hatch(svg, outcome.hatch);
}

void draw_share(Svg& svg, Vector at, double width, const std::string& paint) {
  svg.element("rect", {{"class", "share"},
                       {"x", at.x},
                       {"y", at.y},
                       {"width", width},
                       {"height", bar_height},
                       {"fill", paint},
                       {"stroke", style::ink},
                       {"stroke-width", 0.4}});
}

void draw_percentage(Svg& svg, Vector middle, double room, double share) {
  const std::string text = percent(share);
  const double width = text_width(text, style::small_size) + 3;
  if (width > room) return;
  svg.element("rect", {{"x", middle.x - width / 2},
                       {"y", middle.y - 5},
                       {"width", width},
                       {"height", 10},
                       {"fill", style::paper},
                       {"fill-opacity", 0.85}});
  svg.text(middle + Vector{0, 0.36 * style::small_size}, text,
           {.size = style::small_size, .anchor = "middle"});
}

void draw_bar(Svg& svg, const Bar& bar, const std::vector<Outcome>& outcomes, Vector at,
              double width) {
  const auto scope = svg.group("bar");
  for (const Outcome& outcome : outcomes) {
    const auto found = bar.outcomes.find(outcome.word);
    if (found == bar.outcomes.end()) continue;
    const double share = found->second / bar.steps, wide = share * width;
    draw_share(svg, at, wide, paint_of(svg, outcome));
    draw_percentage(svg, at + Vector{wide / 2, bar_height / 2}, wide, share);
    at.x += wide;
  }
}

std::vector<LegendEntry> legend_of(const std::vector<Bar>& bars,
                                   const std::vector<Outcome>& outcomes) {
  double steps = 0;
  for (const Bar& bar : bars) steps += bar.steps;
  std::vector<LegendEntry> entries;
  for (const Outcome& outcome : outcomes) {
    double count = 0;
    for (const Bar& bar : bars)
      if (const auto found = bar.outcomes.find(outcome.word); found != bar.outcomes.end())
        count += found->second;
    entries.push_back({[outcome](Svg& svg, Vector left) {
                         svg.element("rect", {{"x", left.x},
                                              {"y", left.y - 4},
                                              {"width", swatch_width},
                                              {"height", 8},
                                              {"fill", paint_of(svg, outcome)},
                                              {"stroke", style::ink},
                                              {"stroke-width", 0.4}});
                       },
                       fmt::format("{}: {} of all", spoken(outcome.word), percent(count / steps))});
  }
  return entries;
}

// Above its bar, so that no name is too long.
void draw_label(Svg& svg, const Bar& bar, Vector at, double width) {
  const std::string numbers = fmt::format("{} step{}, mean a {:.2g}", count_in_words(bar.steps),
                                          bar.steps == 1 ? "" : "s", bar.acceptance / bar.steps);
  const double room = width - text_width(numbers, style::small_size) - label_gap;
  const Vector baseline = at - Vector{0, 3};
  svg.text(baseline, shortened(spoken(bar.mutation), style::bold_width * style::small_size, room),
           {.size = style::small_size, .weight = "bold"});
  svg.text(baseline + Vector{width, 0}, numbers, {.size = style::small_size, .anchor = "end"});
}

}  // namespace

Block acceptance_chart(const Steps& steps, double width) {
  const std::vector<Bar> bars = bars_of(steps);
  const std::vector<Outcome> outcomes = outcomes_of(steps, bars);
  const std::vector<LegendEntry> entries = legend_of(bars, outcomes);
  const double rows = static_cast<double>(bars.size()) * (bar_height + bar_gap);
  return {fmt::format("What became of the proposals, {}{}", in_words(steps),
                      bars.empty() ? ": no step was chosen" : ""),
          rows + legend_gap + legend_height(entries, width), [=](Svg& svg, Vector top_left) {
            const auto scope = svg.group("acceptance");
            Vector at = top_left;
            for (const Bar& bar : bars) {
              at.y += bar_gap - 4;
              draw_label(svg, bar, at, width);
              draw_bar(svg, bar, outcomes, at, width);
              at.y += bar_height + 4;
            }
            draw_legend(svg, entries, at + Vector{0, legend_gap}, width);
          }};
}

}  // namespace wander::figure
