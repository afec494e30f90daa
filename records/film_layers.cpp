#include "records/film_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>

#include "core/film_layout.h"
#include "core/tint.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 1> grey{"Y"};
constexpr std::array<std::string_view, 3> colour{"R", "G", "B"};
constexpr std::string_view acceptance_prefix = "acceptance.", proposed_prefix = "proposed.",
                           vertices = "vertices_", chains = "chains",
                           chains_error = "chains.standard_error", of_samples = "samples";

void require_fit(std::string_view name, std::size_t size, std::size_t expected) {
  if (size != expected) throw std::logic_error(fmt::format("layer {} does not fit the film", name));
}

// What a mutation did, by the pixels or by the cells of a raster over them.
class MutationMaps {
 public:
  explicit MutationMaps(const FilmEstimate& film)
      : shape_(film.shape),
        raster_(std::make_shared<Raster>(
            FilmLayout{.maps = Keep::always}.maps_of(pixels_of(film.shape)))) {}

  // What is known of a cell, at each of its pixels.
  FilmLayer rates(std::string name, const std::vector<double>& map) const {
    if (map.size() == shape_.pixels())
      return {std::move(name), 1, [&map](std::size_t i) { return map[i]; }};
    require_fit(name, map.size(), raster_->cells());
    return {std::move(name), 1, [&map, raster = raster_](std::size_t i) {
              return map[raster->cell(static_cast<int>(i))];
            }};
  }

  // Counts of a cell, which its pixels share.
  FilmLayer counts(std::string name, const std::vector<double>& map) const {
    if (map.size() == shape_.pixels()) return rates(std::move(name), map);
    require_fit(name, map.size(), raster_->cells());
    auto shares = std::make_shared<std::vector<double>>(map.size());
    for (std::size_t i = 0; i < shape_.pixels(); ++i)
      ++(*shares)[raster_->cell(static_cast<int>(i))];
    for (std::size_t c = 0; c < map.size(); ++c) (*shares)[c] = map[c] / (*shares)[c];
    return {std::move(name), 1, [shares, raster = raster_](std::size_t i) {
              return (*shares)[raster->cell(static_cast<int>(i))];
            }};
  }

 private:
  ImageShape shape_;
  std::shared_ptr<const Raster> raster_;
};

// The X of PREFIX X.
std::optional<std::string> after(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return std::nullopt;
  return std::string(name.substr(prefix.size()));
}

std::optional<int> length_in(std::string_view name) {
  const auto text = after(vertices, name);
  if (!text) return std::nullopt;
  int length = 0;
  const char* const end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data(), end, length);
  return error == std::errc() && stop == end ? std::optional(length) : std::nullopt;
}

// Counts and mean acceptance follow from those per bin.
void sum_up(MutationRecord& mutation) {
  double proposals = 0, accepted = 0;
  for (std::size_t i = 0; i < mutation.proposed_per_bin.size(); ++i) {
    if (!(mutation.proposed_per_bin[i] > 0)) continue;  // the acceptance of nothing may be NaN
    proposals += mutation.proposed_per_bin[i];
    accepted += mutation.proposed_per_bin[i] * mutation.acceptance_per_bin[i];
  }
  if (!(proposals > 0 && proposals < 0x1p63)) return;
  mutation.proposed = static_cast<std::uint64_t>(std::round(proposals));
  mutation.mean_acceptance = accepted / proposals;
}

}  // namespace

std::span<const std::string_view> channel_names(std::size_t channels) {
  return channels == 1 ? std::span<const std::string_view>(grey) : colour;
}

std::size_t channels_of(std::string_view layer, std::size_t film_channels) {
  return layer.starts_with(acceptance_prefix) || layer.starts_with(proposed_prefix) ? 1
                                                                                    : film_channels;
}

std::vector<FilmLayer> layers_of(const Rendering& rendering) {
  const FilmEstimate& film = rendering.film;
  const ImageShape shape(film.shape);
  std::vector<FilmLayer> layers;
  const auto add = [&](std::string name, const auto& numbers) {
    if (numbers.empty()) return;
    require_fit(name, numbers.size(), shape.numbers());
    layers.push_back({std::move(name), shape.channels,
                      [&numbers](std::size_t i) { return static_cast<double>(numbers[i]); }});
  };
  add("value", film.value);
  add("standard_error", film.standard_error);
  add("reliable", film.reliable);
  for (const auto& [length, values] : film.by_length)
    add(fmt::format("{}{}", vertices, length), values);
  if (rendering.chains_film) {
    add(std::string(chains), rendering.chains_film->value);
    add(std::string(chains_error), rendering.chains_film->standard_error);
  }
  if (rendering.pooling) add(std::string(of_samples), rendering.pooling->film_of_samples);
  const MutationMaps maps(film);
  for (const MutationRecord& mutation : rendering.mutations) {
    if (!mutation.acceptance_per_bin.empty())
      layers.push_back(
          maps.rates(std::string(acceptance_prefix) + mutation.name, mutation.acceptance_per_bin));
    if (!mutation.proposed_per_bin.empty())
      layers.push_back(
          maps.counts(std::string(proposed_prefix) + mutation.name, mutation.proposed_per_bin));
  }
  return layers;
}

std::vector<FilmLayerSlot> slots_of(Rendering& rendering, const std::set<std::string>& names) {
  FilmEstimate& film = rendering.film;
  const ImageShape shape(film.shape);
  std::vector<FilmLayerSlot> slots;
  const auto add = [&](const std::string& name, auto& numbers) {
    const std::size_t channels = channels_of(name, shape.channels);
    numbers.resize(shape.pixels() * channels);
    slots.push_back({name, channels, [&numbers](std::size_t i, double x) { numbers[i] = x; }});
  };
  for (const char* name : {"value", "standard_error", "reliable"})
    if (!names.contains(name)) throw std::runtime_error(fmt::format("it has no layer '{}'", name));
  add("value", film.value);
  add("standard_error", film.standard_error);
  film.reliable.resize(shape.numbers());
  slots.push_back({"reliable", shape.channels,
                   [&film](std::size_t i, double flag) { film.reliable[i] = flag != 0; }});
  for (const std::string& name : names)
    if (const auto length = length_in(name)) add(name, film.by_length[*length]);
  if (names.contains(std::string(chains))) {
    FilmEstimate& alone = rendering.chains_film.emplace();
    alone.shape = film.shape;
    add(std::string(chains), alone.value);
    if (names.contains(std::string(chains_error)))
      add(std::string(chains_error), alone.standard_error);
  }
  if (names.contains(std::string(of_samples)))
    add(std::string(of_samples), rendering.pooling.emplace().film_of_samples);
  for (const std::string& name : names)
    if (const auto mutation = after(acceptance_prefix, name)) {
      if (!names.contains(std::string(proposed_prefix) + *mutation))
        throw std::runtime_error(fmt::format("it has no layer '{}{}'", proposed_prefix, *mutation));
      rendering.mutations.emplace_back().name = *mutation;
    }
  for (MutationRecord& mutation : rendering.mutations) {
    add(std::string(acceptance_prefix) + mutation.name, mutation.acceptance_per_bin);
    add(std::string(proposed_prefix) + mutation.name, mutation.proposed_per_bin);
  }
  return slots;
}

void sum_up_mutations(Rendering& rendering) {
  for (MutationRecord& mutation : rendering.mutations) sum_up(mutation);
}

}  // namespace wander
