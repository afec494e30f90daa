#include "draw/report/picture_store.h"

#include <fmt/format.h>

#include "core/image_shape.h"
#include "draw/figure/image_maps.h"
#include "records/png.h"
#include "records/tone.h"

namespace wander::report {
namespace {

// Fewer pixels across are shown as squares, and not smoothed.
constexpr double few = 250;
// A page of pictures takes 4/3 of this.
constexpr std::size_t most_bytes = 1'600'000;

std::string png_of(const FilmEstimate& film, double white) {
  const ImageShape shape(film.shape);
  return png_address(to_png(srgb_bytes(film.value, white), static_cast<int>(shape.width),
                            static_cast<int>(shape.height), static_cast<int>(shape.channels)));
}

std::string image(const std::string& id, double width, double height, const std::string& address) {
  return fmt::format(
      "<image {}width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" xlink:href=\"{}\"/>", id,
      figure::number(width), figure::number(height), address);
}

}  // namespace

std::size_t pixels_to_one(const FilmEstimate& like, std::size_t channels, std::size_t count,
                          std::size_t most) {
  const ImageShape shape(like.shape);
  std::size_t n = figure::pixels_per_pixel(shape.width, shape.height);
  while (count * shape.pixels() * channels / (n * n) > most) ++n;
  return n;
}

PictureStore::PictureStore(const FilmEstimate& like, std::size_t count, double white)
    : white_(white),
      per_pixel_(pixels_to_one(like, ImageShape(like.shape).channels, count, most_bytes)) {
  const ImageShape shape(like.shape);
  width_ = static_cast<double>(shape.width);
  height_ = static_cast<double>(shape.height);
}

std::size_t PictureStore::add(Html& html, const FilmEstimate& film) {
  const std::size_t number = pictures_++;
  html.markup(fmt::format(
      "<svg class=\"store\" width=\"0\" height=\"0\" aria-hidden=\"true\"><defs>{}</defs></svg>\n",
      image(fmt::format("id=\"picture-{}\" {}", number,
                        width_ < few * static_cast<double>(per_pixel_) ? "class=\"few\" " : ""),
            width_, height_, png_of(figure::averaged(film, per_pixel_), white_))));
  return number;
}

void PictureStore::show(Html& html, std::size_t number, const std::string& words,
                        const std::string& over) const {
  html.markup(fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">"
      "<use href=\"#picture-{}\"/>{}</svg>\n",
      figure::number(width_), figure::number(height_), figure::escaped(words), number, over));
}

void write_enlarged(Html& html, const FilmEstimate& film, double white, const std::string& words) {
  const ImageShape shape(film.shape);
  const auto width = static_cast<double>(shape.width), height = static_cast<double>(shape.height);
  html.markup(fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg>\n",
                          figure::number(width), figure::number(height), figure::escaped(words),
                          image("", width, height, png_of(film, white))));
}

}  // namespace wander::report
