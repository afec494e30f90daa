#include "draw/report/style_sheet.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "draw/figure/style.h"

namespace wander::report {
namespace {

namespace style = figure::style;

constexpr std::string_view page = R"(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1c1c1c; --soft: #595959;
  --line: #d4d4d4; --tint: #f4f4f2; --link: #00568f; --warn: #8a2a00; --warn-tint: #fff1e6; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1.25rem 4rem; max-width: 58rem; background: var(--paper);
  color: var(--ink); font: 1rem/1.5 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { font-size: 1.3rem; margin: 3rem 0 0.75rem; padding-top: 0.75rem;
  border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.75rem 0 0.5rem; }
p, li, dd { max-width: 44rem; }
a { color: var(--link); }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.skip { position: absolute; left: -100rem; }
.skip:focus { left: 1rem; top: 1rem; padding: 0.5rem 1rem; background: var(--paper); z-index: 1; }
.about { color: var(--soft); }
nav ol { columns: 2; padding-left: 1.5rem; margin: 1rem 0; }
.verdict { padding-left: 1.2rem; }
.verdict li:first-child { font-size: 1.2rem; font-weight: 600; line-height: 1.4;
  margin-bottom: 0.5rem; }
li + li { margin-top: 0.2rem; }
.warning { border: 2px solid var(--warn); border-left-width: 0.6rem; background: var(--warn-tint);
  padding: 0.25rem 1rem 0.75rem; margin: 1.25rem 0; }
.warning h3 { color: var(--warn); margin-top: 0.5rem; }
.note { border-left: 0.3rem solid var(--line); padding-left: 0.8rem; }
figure { margin: 1.5rem 0; }
.view { overflow-x: auto; }
figure svg { display: block; width: 100%; min-width: var(--own-width); height: auto; }
.picture svg { max-width: max(36rem, var(--own-width)); }
.column svg { max-width: max(26rem, var(--own-width)); }
figcaption, .caption { color: var(--soft); font-size: 0.9rem; line-height: 1.4; text-align: left; }
figcaption { margin-top: 0.4rem; max-width: 44rem; }
.caption { margin: 1.5rem 0 0.4rem; }
.table { overflow-x: auto; margin: 0 0 1.5rem; }
table { border-collapse: collapse; font-size: 0.875rem; line-height: 1.35;
  font-variant-numeric: tabular-nums lining-nums; }
th, td { padding: 0.25rem 0.75rem 0.25rem 0; text-align: left; vertical-align: baseline;
  border-bottom: 1px solid var(--line); }
thead th { vertical-align: bottom; border-bottom: 2px solid var(--ink); max-width: 9rem; }
th:last-child, td:last-child { padding-right: 0; }
.number { text-align: right; }
td.number, td.interval { white-space: nowrap; }
td.words { min-width: 7.5rem; }
th[scope="row"] { font-weight: 600; max-width: 14rem; overflow-wrap: break-word; }
li, h1, p { overflow-wrap: anywhere; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--link); }
pre { overflow-x: auto; padding: 0.75rem; background: var(--tint); font-size: 0.8rem;
  line-height: 1.4; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
.hash { overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.2rem 1.25rem; }
dt { color: var(--soft); }
dd { margin: 0; }
.store { position: absolute; }
.gallery, .splits { display: grid; gap: 1.25rem; margin: 1rem 0;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 12.5rem), 1fr)); }
.splits { grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr)); }
.crops { display: grid; gap: 0.5rem; margin: 0 0 1rem; grid-auto-flow: column;
  grid-auto-columns: minmax(4.5rem, 11rem); }
.gallery figure, .crops figure { margin: 0; }
.gallery svg, .crops svg, .split svg { display: block; width: 100%; min-width: 0; height: auto; }
.crops svg, .few, .picture .picture { image-rendering: pixelated; }
.gallery svg text { font-family: inherit; }
.split { border: 0; margin: 0; padding: 0; min-width: 0; }
.split legend { font-weight: 600; padding: 0; }
.split label { margin: 0 0.9rem 0 0.25rem; font-size: 0.9rem; }
.frame { position: relative; container-type: inline-size; margin-top: 0.4rem; }
.over { position: absolute; top: 0; left: 0; height: 100%; width: 50%; max-width: 100%;
  overflow: hidden; resize: horizontal; border-right: 2px solid #ffffff;
  box-shadow: 1px 0 0 #000000; }
.split .over svg { width: 100cqw; }
.left:checked ~ .frame .over { width: 100% !important; resize: none; border: 0; }
.right:checked ~ .frame .over { display: none; }
@media (max-width: 40rem) { nav ol { columns: 1; } dl { display: block; }
  dd + dt { margin-top: 0.4rem; } }
@media screen and (max-width: 40rem) {
  th:first-child { position: sticky; left: 0; background: var(--paper); max-width: 8rem; }
}
@media screen and (max-width: 46rem) {
  .chart figcaption::before { content: "Wider than the screen: scroll it sideways. "; }
}
)";

constexpr std::string_view dark_page = R"(
  :root { --paper: #15171a; --ink: #e6e6e6; --soft: #a6abb1; --line: #3b3f45; --tint: #202328;
    --link: #7cc0f5; --warn: #ffb27a; --warn-tint: #33231a; }
  .picture .tones, .picture .tone-legend > rect { filter: brightness(0.85); }
)";

// Folded tables are unfolded: paper has nothing to click on.
constexpr std::string_view print = R"(
@media print {
  @page { size: A4; margin: 16mm 15mm; }
  :root { font-size: 10pt; color-scheme: light; --paper: #ffffff; --ink: #000000; --soft: #333333;
    --line: #999999; --tint: #ffffff; --link: #000000; --warn: #000000; --warn-tint: #ffffff; }
  body { max-width: none; padding: 0; }
  p, li, dd, figcaption { max-width: none; orphans: 3; widows: 3; }
  nav, .skip { display: none; }
  h2 { margin-top: 1.5rem; }
  h2, h3, .caption, summary { break-after: avoid; }
  figure, tr, dt, .short { break-inside: avoid; }
  figure { margin: 1rem 0; }
  figure svg { width: var(--own-width); min-width: 0; max-width: 100%; max-height: 215mm; }
  .picture svg { max-height: 100mm; margin: 0; }
  .view, .table, pre { overflow: visible; }
  table { font-size: 8pt; }
  th, td { padding-right: 1.5mm; }
  td.words { min-width: 0; }
  details table { font-size: 6.5pt; }
  details td.number, details td.interval { white-space: normal; }
  pre { white-space: pre-wrap; overflow-wrap: anywhere; font-size: 7.5pt; }
  .gallery { grid-template-columns: repeat(auto-fit, minmax(40mm, 1fr)); gap: 4mm; }
  .crops { break-inside: avoid; grid-auto-columns: minmax(0, 32mm); }
  .on-screen { display: none; }
  details::details-content { content-visibility: visible; display: block; height: auto; }
  summary { list-style: none; }
}
)";

// A colour of figures on white paper, and the one that stands for it on a dark page.
struct Night {
  std::string_view day, night;
};
constexpr std::array nights{
    Night{style::paper, "#15171a"}, Night{style::ink, "#e2e2e2"}, Night{style::wall, "#bdbdbd"},
    Night{style::faint, "#3b3f45"}, Night{style::light, "#ff7a70"}, Night{style::sensor, "#63b3ed"},
    Night{style::glass, "#243038"}, Night{style::glass_mark, "#8fb0c2"},
    Night{style::neutral.colour, "#9a9a9a"}, Night{style::accepted.colour, "#5b9bd8"},
    Night{style::rejected.colour, "#f09a3a"}, Night{style::films[0].colour, "#3d97dd"},
    Night{style::films[1].colour, "#ff8b4a"}, Night{style::films[2].colour, "#34cfa0"},
    Night{style::films[3].colour, "#e79cc4"}, Night{style::films[4].colour, "#f2b632"},
    Night{style::films[5].colour, "#a8dcff"}, Night{style::films[6].colour, "#c9a45c"},
    // The grounds and the marks of hatches.
    Night{"#fdebd3", "#4a3517"}, Night{"#e9e9e9", "#35393e"}, Night{"#efefef", "#2b2f34"},
    Night{"#f4f4f4", "#25282d"}, Night{"#5a5a5a", "#b4b4b4"}, Night{"#8c8c8c", "#a0a0a0"},
    Night{"#a8a8a8", "#8f8f8f"}};

// Of a picture what stands on its ground follows: the rest is drawn for tones that stay.
std::string night_colours() {
  constexpr std::string_view ground = ".picture svg > :is(rect, text)",
                             title = ".picture :is(.tone-legend, .colour-bar) > text",
                             furniture = ".picture :is(.axis, .legend)";
  std::string rules;
  for (const Night& colour : nights)
    for (const std::string_view property : {"fill", "stroke"}) {
      const std::string drawn = fmt::format("[{}=\"{}\"]", property, colour.day);
      rules += fmt::format("  .chart {0}, {1}{0}, {2}{0}, {3} {0} {{ {4}: {5}; }}\n", drawn, ground,
                           title, furniture, property, colour.night);
    }
  return rules;
}

}  // namespace

std::string style_sheet() {
  return fmt::format("{}@media screen and (prefers-color-scheme: dark) {{{}{}}}\n{}", page,
                     dark_page, night_colours(), print);
}

}  // namespace wander::report
