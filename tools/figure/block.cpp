#include "tools/figure/block.h"

#include "tools/figure/style.h"

namespace wander::figure {
namespace {

constexpr double gap = 12, heading_height = 15;

double heading_room(const Block& block) { return block.heading.empty() ? 0 : heading_height; }

double height_of(const std::vector<Block>& blocks) {
  double height = 0;
  for (const Block& block : blocks)
    height += heading_room(block) + block.height + (&block == &blocks.back() ? 0 : gap);
  return height;
}

}  // namespace

double block_width(double page_width) { return page_width - 2 * style::margin; }

std::string page(const std::string& title, const std::string& description, double page_width,
                 const std::vector<Block>& blocks) {
  const double width = block_width(page_width);
  const double top = style::margin + (title.empty() ? 0 : 1.8 * style::title_size);
  Svg svg({page_width, top + height_of(blocks) + style::margin}, title.empty() ? "Figure" : title,
          description);
  if (!title.empty())
    svg.text({page_width / 2, style::margin + style::title_size},
             shortened(title, style::bold_width * style::title_size, width),
             {.size = style::title_size, .anchor = "middle", .weight = "bold"});
  Vector at{style::margin, top};
  for (const Block& block : blocks) {
    if (!block.heading.empty())
      svg.text(at + Vector{0, style::label_size + 1},
               shortened(block.heading, style::bold_width * style::label_size, width),
               {.size = style::label_size, .weight = "bold"});
    at.y += heading_room(block);
    block.draw(svg, at);
    at.y += block.height + gap;
  }
  return std::move(svg).finish();
}

}  // namespace wander::figure
