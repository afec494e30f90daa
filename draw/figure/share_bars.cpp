#include "draw/figure/share_bars.h"

#include <algorithm>

#include "draw/figure/legend.h"
#include "draw/figure/meanings.h"
#include "draw/figure/style.h"
#include "lab/wording.h"

namespace wander::figure {
namespace {

constexpr double bar_height = 15, bar_gap = 17, legend_gap = 2, label_gap = 6;

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

void draw_bar(Svg& svg, const ShareBar& bar, const std::vector<Part>& parts, Vector at,
              double width) {
  const auto scope = svg.group("bar");
  for (const Part& part : parts) {
    const auto found = bar.shares.find(part.key);
    if (found == bar.shares.end()) continue;
    const double wide = found->second * width;
    draw_share(svg, at, wide, define_fill(svg, part.fill));
    draw_percentage(svg, at + Vector{wide / 2, bar_height / 2}, wide, found->second);
    at.x += wide;
  }
}

std::vector<LegendEntry> legend_of(const std::vector<Part>& parts) {
  std::vector<LegendEntry> entries;
  for (const Part& part : parts)
    entries.push_back({[part](Svg& svg, Vector left) {
                         svg.element("rect", {{"x", left.x},
                                              {"y", left.y - 4},
                                              {"width", swatch_width},
                                              {"height", 8},
                                              {"fill", define_fill(svg, part.fill)},
                                              {"stroke", style::ink},
                                              {"stroke-width", 0.4}});
                       },
                       part.legend});
  return entries;
}

// Above its bar, so that no name is too long.
void draw_label(Svg& svg, const ShareBar& bar, Vector at, double width) {
  const double room = width - text_width(bar.note, style::small_size) - label_gap;
  const Vector baseline = at - Vector{0, 3};
  svg.text(baseline, shortened(bar.label, style::bold_width * style::small_size, room),
           {.size = style::small_size, .weight = "bold"});
  svg.text(baseline + Vector{width, 0}, bar.note, {.size = style::small_size, .anchor = "end"});
}

}  // namespace

std::string spoken(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::vector<Part> outcome_parts(const std::map<std::string, double>& counts) {
  std::vector<Part> parts;
  const auto add = [&](const OutcomeMark& mark) {
    parts.push_back({std::string(mark.outcome), mark.fill, spoken(std::string(mark.words))});
  };
  for (const OutcomeMark& mark : outcome_marks())
    if (const auto found = counts.find(std::string(mark.outcome));
        found != counts.end() && found->second > 0)
      add(mark);
  for (const auto& [outcome, count] : counts)
    if (count > 0 && std::ranges::find(parts, outcome, &Part::key) == parts.end())
      add(mark_of_outcome(outcome));
  return parts;
}

Block share_bars(std::string heading, std::vector<ShareBar> bars, std::vector<Part> parts,
                 double width) {
  const std::vector<LegendEntry> entries = legend_of(parts);
  const double rows = static_cast<double>(bars.size()) * (bar_height + bar_gap);
  return {std::move(heading), rows + legend_gap + legend_height(entries, width),
          [=, bars = std::move(bars), parts = std::move(parts)](Svg& svg, Vector top_left) {
            const auto scope = svg.group("shares");
            Vector at = top_left;
            for (const ShareBar& bar : bars) {
              at.y += bar_gap - 4;
              draw_label(svg, bar, at, width);
              draw_bar(svg, bar, parts, at, width);
              at.y += bar_height + 4;
            }
            draw_legend(svg, entries, at + Vector{0, legend_gap}, width);
          }};
}

}  // namespace wander::figure
