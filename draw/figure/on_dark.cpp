#include "draw/figure/on_dark.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

struct Counterpart {
  std::string_view on_paper, on_dark;
};
constexpr std::array<Counterpart, 7> counterparts{{{style::wall, "#f2f0f4"},
                                                   {style::paper, "#37333f"},
                                                   {style::ink, "#d8d4de"},
                                                   {style::light, "#ff8f86"},
                                                   {style::sensor, "#7cc6ff"},
                                                   {style::glass, "#2b3a44"},
                                                   {style::glass_mark, "#8fb0c2"}}};

}  // namespace

// Rules outweigh the attributes that marks are drawn with.
void define_on_dark(Svg& svg) {
  if (!svg.is_new(on_dark)) return;
  std::string rules;
  for (const Counterpart& c : counterparts)
    for (const std::string_view property : {"stroke", "fill"})
      rules += fmt::format(".{0} [{1}='{2}']{{{1}:{3}}}", on_dark, property, c.on_paper, c.on_dark);
  rules += fmt::format(
      ".{0} *{{stroke:#000;stroke-width:3.4px;stroke-linejoin:round;fill:none}}.{0}{{opacity:.5}}",
      dark_rim);
  svg.style_sheet(rules);
}

}  // namespace wander::figure
