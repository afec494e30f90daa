#include "draw/figure/block.h"

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double gap = 12, heading_gap = 6, heading_line = 9, title_line = 10.5;

std::vector<std::string> heading_lines(const Block& block, double width) {
  if (block.heading.empty()) return {};
  return wrapped(block.heading, style::bold_width * style::label_size, width);
}

double heading_room(const Block& block, double width) {
  const auto lines = static_cast<double>(heading_lines(block, width).size());
  return lines > 0 ? heading_gap + heading_line * lines : 0;
}

double height_of(const std::vector<Block>& blocks, double width) {
  double height = 0;
  for (const Block& block : blocks)
    height += heading_room(block, width) + block.height + (&block == &blocks.back() ? 0 : gap);
  return height;
}

}  // namespace

double title_height(const std::string& title, double width) {
  if (title.empty()) return 0;
  const auto lines = wrapped(title, style::bold_width * style::title_size, width).size();
  return 1.8 * style::title_size + title_line * static_cast<double>(lines - 1);
}

void draw_title(Svg& svg, const std::string& title, Vector top, double width) {
  if (title.empty()) return;
  top.y += style::title_size;
  for (const std::string& line : wrapped(title, style::bold_width * style::title_size, width)) {
    svg.text(top, line, {.size = style::title_size, .anchor = "middle", .weight = "bold"});
    top.y += title_line;
  }
}

double block_width(double page_width) { return page_width - 2 * style::margin; }

std::string page(const std::string& title, const std::string& description, double page_width,
                 const std::vector<Block>& blocks) {
  const double width = block_width(page_width);
  const double top = style::margin + title_height(title, width);
  Svg svg({page_width, top + height_of(blocks, width) + style::margin},
          title.empty() ? "Figure" : title, description);
  draw_title(svg, title, {page_width / 2, style::margin}, width);
  Vector at{style::margin, top};
  for (const Block& block : blocks) {
    Vector line = at + Vector{0, style::label_size + 1};
    for (const std::string& text : heading_lines(block, width)) {
      svg.text(line, text, {.size = style::label_size, .weight = "bold"});
      line.y += heading_line;
    }
    at.y += heading_room(block, width);
    block.draw(svg, at);
    at.y += block.height + gap;
  }
  return std::move(svg).finish();
}

}  // namespace wander::figure
