#include "draw/figure/image_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/figure/embedded_image.h"
#include "draw/figure/style.h"
#include "records/png.h"

namespace wander::figure {
namespace {

constexpr double line_height = 9, words_gap = 4, bar_gap = 5, bar_height = 6;
constexpr std::size_t enough_across = 1024;  // pixels of the longer side
constexpr Rgb not_known_colour{0xb0, 0xb0, 0xb0};
// Labels at the ends of a scale stand out by the inset.
constexpr double gap = 18, inset = 4, most_height = 330;
constexpr double narrowest_scale = 110;

std::vector<std::string> lines_of(const ImagePanel& panel, double width) {
  std::vector<std::string> lines;
  for (const std::string& text : panel.words)
    for (std::string& line : wrapped(text, style::small_size * style::bold_width, width))
      lines.push_back(std::move(line));
  return lines;
}

// Of the scale: no wider than the scale is.
std::vector<std::string> title_lines(const Axis& axis) {
  return wrapped(axis.title, style::label_size, axis.scale.page.width());
}

void draw_words(Svg& svg, const ImagePanel& panel, Vector top_left, double width) {
  double y = top_left.y + style::small_size;
  for (const std::string& text : panel.words) {
    const bool is_first = &text == &panel.words.front();
    for (const std::string& line : wrapped(text, style::small_size * style::bold_width, width)) {
      svg.text({top_left.x, y}, line,
               {.size = style::small_size, .weight = is_first ? "bold" : "normal"});
      y += line_height;
    }
  }
}

void draw_frame(Svg& svg, Vector top_left, Vector size) {
  svg.element("rect", {{"x", top_left.x},
                       {"y", top_left.y},
                       {"width", size.x},
                       {"height", size.y},
                       {"fill", "none"},
                       {"stroke", style::ink},
                       {"stroke-width", 0.4}});
}

void draw_bar(Svg& svg, const ImagePanel& panel, Vector top_left, double width) {
  const auto scope = svg.group("colour-bar");
  const auto count = static_cast<int>(panel.colours.size() / 3);
  const Vector size{width, bar_height};
  draw_image(svg, to_png(panel.colours, count, 1, 3), top_left, size);
  draw_frame(svg, top_left, size);
  const Axis axis = panel.axis({top_left.x, top_left.x + width});
  draw_bottom_axis(svg, axis, top_left.y + bar_height);
  Axis titled = axis;
  for (double y = top_left.y + bar_height; std::string & line : title_lines(axis)) {
    titled.title = std::move(line);
    draw_bottom_title(svg, titled, y);
    y += line_height;
  }
}

}  // namespace

std::string picture_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                        std::size_t channels) {
  const std::size_t times = std::max<std::size_t>(1, enough_across / std::max(width, height));
  std::vector<std::uint8_t> enlarged;
  enlarged.reserve(pixels.size() * times * times);
  for (std::size_t y = 0; y < height * times; ++y)
    for (std::size_t x = 0; x < width * times; ++x) {
      const auto pixel =
          pixels.begin() + static_cast<std::ptrdiff_t>((y / times * width + x / times) * channels);
      enlarged.insert(enlarged.end(), pixel, pixel + static_cast<std::ptrdiff_t>(channels));
    }
  return to_png(enlarged, static_cast<int>(width * times), static_cast<int>(height * times),
                static_cast<int>(channels));
}

std::string map_png(const PixelMap& map, const ColourMap& colours,
                    const std::function<std::uint8_t(double)>& tone) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(3 * map.values.size());
  for (const double value : map.values) {
    const Rgb& colour = std::isnan(value) ? not_known_colour : colours[tone(value)];
    pixels.insert(pixels.end(), colour.begin(), colour.end());
  }
  return picture_png(pixels, map.width, map.height, 3);
}

std::vector<std::uint8_t> scale_of(const ColourMap& colours) {
  std::vector<std::uint8_t> scale;
  for (const Rgb& colour : colours) scale.insert(scale.end(), colour.begin(), colour.end());
  return scale;
}

double PanelSize::height() const {
  return line_height * static_cast<double>(lines) + words_gap + image.y + bar_gap + bar_height +
         bottom_axis_height + line_height * static_cast<double>(title_lines - 1);
}

PanelSize panel_size(const ImagePanel& panel, double width, double most_height) {
  const double height = std::min(width * panel.aspect, most_height);
  const Vector image{height / panel.aspect, height};
  const double scale = std::max(image.x, std::min(width, narrowest_scale));
  return {image, scale, lines_of(panel, width).size(), title_lines(panel.axis({0, scale})).size()};
}

void draw_panel(Svg& svg, const ImagePanel& panel, const PanelSize& size, Vector top_left,
                double width) {
  draw_words(svg, panel, top_left, width);
  const Vector image{top_left.x,
                     top_left.y + line_height * static_cast<double>(size.lines) + words_gap};
  {
    const auto scope = svg.group("picture");
    draw_image(svg, panel.png, image, size.image);
    draw_frame(svg, image, size.image);
  }
  draw_bar(svg, panel, image + Vector{0, size.image.y + bar_gap}, size.scale);
}

Block panel_row(ImagePanel left, ImagePanel right, double page_width) {
  const double width = (page_width - gap - 2 * inset) / 2;
  PanelSize of_left = panel_size(left, width, most_height),
            of_right = panel_size(right, width, most_height);
  of_left.lines = of_right.lines = std::max(of_left.lines, of_right.lines);
  return {"", std::max(of_left.height(), of_right.height()),
          [=, left = std::move(left), right = std::move(right)](Svg& svg, Vector top_left) {
            top_left.x += inset;
            draw_panel(svg, left, of_left, top_left, width);
            draw_panel(svg, right, of_right, top_left + Vector{width + gap, 0}, width);
          }};
}

int ticks_in(Range page, double points) {
  return std::max(2, static_cast<int>(page.width() / points));
}

}  // namespace wander::figure
