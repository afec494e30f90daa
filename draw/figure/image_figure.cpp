#include "draw/figure/image_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/film_statistics.h"
#include "core/image_shape.h"
#include "core/tint.h"
#include "draw/figure/block.h"
#include "draw/figure/image_maps.h"
#include "draw/figure/image_panel.h"
#include "draw/figure/style.h"
#include "draw/figure/tones.h"
#include "lab/wording.h"
#include "records/tone.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

// Labels at the ends of a scale stand out by the inset.
constexpr double gap = 18, inset = 4, most_height = 330;

// Labels take so much of the page.
int ticks_in(Range page, double points) {
  return std::max(2, static_cast<int>(page.width() / points));
}

// One image and, if there is one, the other that it is held against.
struct Row {
  const LabelledFilm* image;
  const LabelledFilm* other;
};

std::vector<Row> rows_of(const std::vector<LabelledFilm>& images,
                         const ImageFigureOptions& options) {
  const LabelledFilm* reference = options.reference ? &*options.reference : nullptr;
  if (reference == nullptr && images.size() == 2) reference = &images[1];
  std::vector<Row> rows;
  for (const LabelledFilm& image : images)
    rows.push_back({&image, &image == reference ? nullptr : reference});
  if (options.reference) rows.push_back({&*options.reference, nullptr});
  return rows;
}

// ---- how it looks

std::vector<std::string> words_of(const LabelledFilm& image) {
  const Rendering& run = image.rendering;
  std::string work = extent_in_words(run.film.shape);
  if (run.samples > 0)
    work += fmt::format(", {} samples", count_in_words(static_cast<double>(run.samples)));
  if (std::isfinite(run.seconds) && run.seconds > 0)
    work += fmt::format(" in {}", duration_in_words(run.seconds));
  if (!run.complete) work += ", interrupted";
  return {image.label, work};
}

ImagePanel picture_panel(const LabelledFilm& image, const Quantity& quantity, double white) {
  const FilmEstimate shown = averaged(image.rendering.film);
  const ImageShape size(shown.shape);
  std::vector<std::uint8_t> greys;
  for (int k = 0; k < 256; ++k)
    greys.insert(greys.end(), 3, srgb_byte(static_cast<double>(k) / 255));
  const Quantity scale{(size.channels > 1 ? "luminance of " : "") + quantity.name, quantity.unit};
  return {words_of(image),
          picture_png(srgb_bytes(shown.value, white), size.width, size.height, size.channels),
          static_cast<double>(image.rendering.film.shape[0]) / image.rendering.film.shape[1], greys,
          [=](Range page) {
            return make_axis(scale, {0, white}, page, ticks_in(page, 34));
          }};
}

// ---- what is known of its error

bool has_gaps(const PixelMap& map) {
  return std::ranges::any_of(map.values, [](double value) { return std::isnan(value); });
}

double aspect_of(const PixelMap& map) {
  return static_cast<double>(map.height) / static_cast<double>(map.width);
}

ImagePanel error_panel(const PixelMap& map, const FilmEstimate& film, const ToneScale& scale) {
  const double share =
      static_cast<double>(reliable_bins(film)) / static_cast<double>(film.value.size());
  std::string words =
      fmt::format("{} of the film; {} of its {} are reliable", percent(relative_error(film)),
                  percent(share), channels_of(film.shape) > 1 ? "numbers" : "pixels");
  if (has_gaps(map)) words += "; grey: not known";
  return {{"relative standard error", words},
          map_png(thinned(map), light_colours(), [=](double value) { return scale.tone(value); }),
          aspect_of(map),
          scale_of(light_colours()),
          [=](Range page) {
            return make_log_axis({"standard error / value", ""}, scale.domain, page);
          }};
}

// Wide enough for all but few, and for what chance makes of agreement.
double largest_shown(const std::vector<PixelMap>& maps) {
  constexpr double usual = 4, beyond = 0.002, most = 100;
  std::vector<double> sizes;
  for (const PixelMap& map : maps)
    for (const double z : map.values)
      if (std::isfinite(z)) sizes.push_back(std::abs(z));
  if (sizes.empty()) return usual;
  const auto at = sizes.begin() +
                  static_cast<std::ptrdiff_t>((1 - beyond) * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, at);
  return std::clamp(std::ceil(*at), usual, most);
}

std::string agreement(const Row& row, const PixelMap& map) {
  const FilmComparison c = film_comparison(row.image->rendering.film, row.other->rendering.film);
  if (c.bins == 0) return "no pixel is reliable in both: nothing can be compared";
  std::string text = fmt::format(
      "χ²\u00a0/\u00a0{}\u00a0=\u00a0{} over {} reliable in both; largest |z|\u00a0=\u00a0{}",
      channels_of(row.image->rendering.film.shape) > 1 ? "number" : "pixel",
      number_text(c.chi2_per_degree), count_in_words(static_cast<double>(c.bins)),
      number_text(c.largest_z));
  return has_gaps(map) ? text + "; grey: not reliable" : text;
}

ImagePanel difference_panel(const Row& row, const PixelMap& map, double most) {
  const auto tone = [most](double z) {
    const double place = std::clamp((z + most) / (2 * most), 0., 1.);
    return static_cast<std::uint8_t>(std::lround(255 * place));
  };
  return {{fmt::format("{} − {}", row.image->label, row.other->label), agreement(row, map)},
          map_png(thinned(map), difference_colours(), tone),
          aspect_of(map),
          scale_of(difference_colours()),
          [most](Range page) {
            return make_axis({"z: difference / standard error of both", ""}, {-most, most}, page,
                             ticks_in(page, 18));
          }};
}

// All maps of a figure, which have their scales in common.
std::vector<ImagePanel> map_panels(const std::vector<Row>& rows) {
  std::vector<PixelMap> maps, differences;
  std::vector<double> errors;
  for (const Row& row : rows) {
    const FilmEstimate& film = row.image->rendering.film;
    maps.push_back(row.other ? difference_map(film, row.other->rendering.film)
                             : relative_error_map(film));
    if (row.other)
      differences.push_back(maps.back());
    else
      errors.insert(errors.end(), maps.back().values.begin(), maps.back().values.end());
  }
  const ToneScale scale = tone_scale(errors);
  const double most = largest_shown(differences);
  std::vector<ImagePanel> panels;
  for (std::size_t k = 0; k < rows.size(); ++k)
    panels.push_back(rows[k].other ? difference_panel(rows[k], maps[k], most)
                                   : error_panel(maps[k], rows[k].image->rendering.film, scale));
  return panels;
}

// ---- the page

Block row_block(ImagePanel left, ImagePanel right, double page_width) {
  const double width = (page_width - gap - 2 * inset) / 2;
  PanelSize of_left = panel_size(left, width, most_height),
            of_right = panel_size(right, width, most_height);
  of_left.lines = of_right.lines = std::max(of_left.lines, of_right.lines);
  return {"", of_left.height(),
          [=, left = std::move(left), right = std::move(right)](Svg& svg, Vector top_left) {
            top_left.x += inset;
            draw_panel(svg, left, of_left, top_left, width);
            draw_panel(svg, right, of_right, top_left + Vector{width + gap, 0}, width);
          }};
}

std::string spoken(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows)
    text += fmt::format("{}{}: {}, relative error {}.", text.empty() ? "" : " ", row.image->label,
                        extent_in_words(row.image->rendering.film.shape),
                        percent(relative_error(row.image->rendering.film)));
  return text;
}

}  // namespace

std::string image_figure(const std::vector<LabelledFilm>& images,
                         const ImageFigureOptions& options) {
  const std::vector<Row> rows = rows_of(images, options);
  const double white = white_of(rows.back().image->rendering.film) / std::exp2(options.exposure);
  const double page_width = options.width.value_or(style::page_width);
  std::vector<ImagePanel> maps = map_panels(rows);
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < rows.size(); ++k)
    blocks.push_back(row_block(picture_panel(*rows[k].image, options.value, white),
                               std::move(maps[k]), block_width(page_width)));
  return page(options.title, spoken(rows), page_width, blocks);
}

}  // namespace wander::figure
