#include "draw/figure/image_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/film_statistics.h"
#include "core/tint.h"
#include "draw/figure/image_maps.h"
#include "draw/figure/image_panel.h"
#include "draw/figure/map_panel.h"
#include "draw/figure/picture_panel.h"
#include "draw/figure/style.h"
#include "draw/figure/tones.h"
#include "lab/wording.h"
#include "records/tone.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

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
  if (run.samples > 0) work += ", " + work_in_words(run);
  if (std::isfinite(run.seconds) && run.seconds > 0)
    work += fmt::format(" in {}", duration_in_words(run.seconds));
  if (!run.complete) work += ", interrupted";
  return {image.label, work};
}

// ---- what is known of its error

bool has_gaps(const PixelMap& map) {
  return std::ranges::any_of(map.values, [](double value) { return std::isnan(value); });
}

ImagePanel error_panel(const PixelMap& map, const FilmEstimate& film, const ToneScale& scale) {
  const double share =
      static_cast<double>(reliable_bins(film)) / static_cast<double>(film.value.size());
  std::string words =
      fmt::format("{} of the film; {} of its {} are reliable", percent(relative_error(film)),
                  percent(share), channels_of(film.shape) > 1 ? "numbers" : "pixels");
  if (has_gaps(map)) words += "; grey: not known";
  return log_panel({"relative standard error", words}, thinned(map), scale,
                   {"standard error / value", ""});
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

ImagePanel row_difference(const Row& row, const PixelMap& map, double most) {
  return difference_panel(
      {fmt::format("{} − {}", row.image->label, row.other->label), agreement(row, map)},
      thinned(map), most);
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
    panels.push_back(rows[k].other ? row_difference(rows[k], maps[k], most)
                                   : error_panel(maps[k], rows[k].image->rendering.film, scale));
  return panels;
}

// ---- the page

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
    blocks.push_back(panel_row(picture_panel(words_of(*rows[k].image),
                                             rows[k].image->rendering.film, options.value, white),
                               std::move(maps[k]), block_width(page_width)));
  return page(options.title, spoken(rows), page_width, blocks);
}

}  // namespace wander::figure
