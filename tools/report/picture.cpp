#include "tools/report/picture.h"

#include <algorithm>

#include "tools/figure/block.h"
#include "tools/figure/tones.h"
#include "tools/report/embedding.h"

namespace wander::report {
namespace {

constexpr int most_columns = 64, tiles_per_row = 3;
constexpr double tile_gap = 8, title_height = 11;

struct Tile {
  std::string label;
  PlaneGrid grid;
  std::vector<double> values;
};

// A film with fewer pixels, each the mean of a square of them.
Tile tile_of(const std::string& label, const FilmEstimate& film) {
  const int height = film.shape[0], width = film.shape[1];
  const int block = (std::max(width, height) + most_columns - 1) / most_columns;
  const int columns = (width + block - 1) / block, rows = (height + block - 1) / block;
  std::vector<double> sums(static_cast<std::size_t>(columns * rows)), counts(sums.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto cell = static_cast<std::size_t>((y / block) * columns + x / block);
      sums[cell] += film.value[static_cast<std::size_t>(y * width + x)];
      counts[cell] += 1;
    }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= counts[k];
  return {label, PlaneGrid({0, 0}, {columns, rows}, columns), std::move(sums)};
}

std::vector<Tile> tiles_of(const Subject& subject) {
  std::vector<Tile> tiles;
  if (const FilmEstimate& reference = subject.runs().reference.film; reference.shape.size() == 2)
    tiles.push_back(tile_of("reference", reference));
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k); details && details->film.shape.size() == 2)
      tiles.push_back(tile_of(subject.label(k), details->film));
  return tiles;
}

figure::Block tiles_block(const std::vector<Tile>& tiles, double width) {
  std::vector<double> all;
  for (const Tile& tile : tiles) all.insert(all.end(), tile.values.begin(), tile.values.end());
  const figure::ToneScale scale = figure::tone_scale(all);
  const double across = (width - (tiles_per_row - 1) * tile_gap) / tiles_per_row;
  const PlaneGrid& grid = tiles.front().grid;
  const double tall = across * grid.rows() / grid.columns();
  const double rows = std::ceil(static_cast<double>(tiles.size()) / tiles_per_row);
  const double picture_height = rows * (title_height + tall + tile_gap);
  return {"", picture_height + figure::tone_legend_height,
          [=](figure::Svg& svg, figure::Vector top_left) {
            for (std::size_t k = 0; k < tiles.size(); ++k) {
              const figure::Vector at =
                  top_left +
                  figure::Vector{
                      static_cast<double>(k % tiles_per_row) * (across + tile_gap),
                      static_cast<double>(k / tiles_per_row) * (title_height + tall + tile_gap)};
              svg.text(at + figure::Vector{0, title_height - 3.5},
                       figure::shortened(tiles[k].label, figure::style::small_size, across),
                       {.size = figure::style::small_size});
              const figure::Vector low = at + figure::Vector{0, title_height + tall};
              figure::draw_tones(svg, tiles[k].values, tiles[k].grid, scale,
                                 figure::style::light_shading, low,
                                 at + figure::Vector{across, title_height});
            }
            figure::draw_tone_legend(svg, scale, figure::style::light_shading,
                                     {"film", "W/m² or W/(m² sr)"},
                                     top_left + figure::Vector{0, picture_height}, width / 2);
          }};
}

}  // namespace

void write_pictures(Html& html, const Subject& subject) {
  const std::vector<Tile> tiles = tiles_of(subject);
  if (tiles.empty()) return;
  write_figure(html,
               figure::page("Films at the last budget",
                            "The film of each contender as an image, on one scale of tones.",
                            figure_width, {tiles_block(tiles, figure::block_width(figure_width))}),
               "The first replicate of each contender, on one logarithmic scale; light tones are "
               "bright. Images show gross faults only: the errors below are what counts.",
               Ground::paper);
}

}  // namespace wander::report
