#include "draw/report/crops.h"

#include <algorithm>
#include <functional>

#include "core/image_shape.h"
#include "records/tone.h"

namespace wander::report {
namespace {

constexpr std::size_t least_side = 8, most_side = 96, parts = 4;

// Σ over the pixels above and to the left, so that the sum over a square takes four numbers.
class Sums {
 public:
  Sums(const FilmEstimate& film, const FilmEstimate& reference, double white)
      : shape_(reference.shape), sums_((shape_.width + 1) * (shape_.height + 1)) {
    for (std::size_t y = 0; y < shape_.height; ++y)
      for (std::size_t x = 0; x < shape_.width; ++x) {
        double square = 0;
        const std::size_t first = (y * shape_.width + x) * shape_.channels;
        for (std::size_t i = first; i < first + shape_.channels; ++i) {
          const double d = srgb_byte(film.value[i] / white) - srgb_byte(reference.value[i] / white);
          square += d * d;
        }
        at(x + 1, y + 1) = square + at(x, y + 1) + at(x + 1, y) - at(x, y);
      }
  }
  double over(const Crop& c) const {
    return sum(c.x + c.side, c.y + c.side) - sum(c.x, c.y + c.side) - sum(c.x + c.side, c.y) +
           sum(c.x, c.y);
  }

 private:
  double& at(std::size_t x, std::size_t y) { return sums_[y * (shape_.width + 1) + x]; }
  double sum(std::size_t x, std::size_t y) const { return sums_[y * (shape_.width + 1) + x]; }

  ImageShape shape_;
  std::vector<double> sums_;
};

struct Scored {
  Crop crop;
  double score;
};

double score_of(const std::vector<Sums>& films, const Crop& crop) {
  double most = 0, least = films.front().over(crop);
  for (const Sums& film : films) {
    most = std::max(most, film.over(crop));
    least = std::min(least, film.over(crop));
  }
  return films.size() > 1 ? most - least : most;
}

bool overlap(const Crop& a, const Crop& b) {
  return a.x < b.x + b.side && b.x < a.x + a.side && a.y < b.y + b.side && b.y < a.y + a.side;
}

}  // namespace

std::vector<Crop> choose_crops(std::span<const FilmEstimate* const> films,
                               const FilmEstimate& reference, double white, std::size_t most) {
  const ImageShape shape(reference.shape);
  const std::size_t shorter = std::min(shape.width, shape.height);
  const std::size_t side = std::min(shorter, std::clamp(shorter / parts, least_side, most_side));
  if (films.empty() || side == 0) return {};
  std::vector<Sums> sums;
  for (const FilmEstimate* film : films) sums.emplace_back(*film, reference, white);
  std::vector<Scored> all;
  const std::size_t step = std::max<std::size_t>(1, side / 4);
  for (std::size_t y = 0; y + side <= shape.height; y += step)
    for (std::size_t x = 0; x + side <= shape.width; x += step)
      all.push_back({{x, y, side}, score_of(sums, {x, y, side})});
  std::ranges::stable_sort(all, std::ranges::greater{}, &Scored::score);
  std::vector<Crop> chosen;
  for (const Scored& each : all)
    if (chosen.size() < most &&
        std::ranges::none_of(chosen, [&](const Crop& other) { return overlap(each.crop, other); }))
      chosen.push_back(each.crop);
  return chosen;
}

FilmEstimate cropped(const FilmEstimate& image, const Crop& crop) {
  const ImageShape shape(image.shape);
  FilmEstimate part{.shape = image.shape};
  part.shape[0] = part.shape[1] = static_cast<int>(crop.side);
  for (std::size_t y = crop.y; y < crop.y + crop.side; ++y) {
    const auto row = image.value.begin() +
                     static_cast<std::ptrdiff_t>((y * shape.width + crop.x) * shape.channels);
    part.value.insert(part.value.end(), row,
                      row + static_cast<std::ptrdiff_t>(crop.side * shape.channels));
  }
  return part;
}

}  // namespace wander::report
