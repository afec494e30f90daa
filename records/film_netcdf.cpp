#include "records/film_netcdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <type_traits>

#include "records/film_facts.h"
#include "records/film_layers.h"
#include "records/netcdf.h"
#include "records/seal.h"

namespace wander {

namespace {

using netcdf::Reader;
using netcdf::Writer;

constexpr std::string_view format = "wanderlight-film/1";
constexpr std::string_view mark = "\nwanderlight-film/1\n";

// A chunk is compressed as a whole, and read as a whole.
constexpr std::size_t chunk_rows = 64, chunk_columns = 256;

bool is_of_channels(const FilmLayer& layer) {
  return !layer.name.starts_with("acceptance.") && !layer.name.starts_with("proposed.");
}

const char* meaning_of(std::string_view layer) {
  if (layer == "value") return "mean radiance or irradiance of the pixel";
  if (layer == "standard_error") return "standard error of the value; NaN: not known";
  if (layer == "reliable") return "enough is known of the pixel for its standard error to hold";
  if (layer == "chains") return "the value by the chains alone";
  if (layer == "chains.standard_error") return "its standard error";
  if (layer == "samples") return "the part of the value that independent samples carry";
  if (layer.starts_with("vertices_")) return "the part of the value from paths of so many vertices";
  if (layer.starts_with("acceptance.")) return "mean acceptance of the mutation's proposals there";
  return "how often the mutation proposed there";
}

// ---- writing

void write_facts(const Writer& file, const RunRecord& run) {
  file.attribute("format", format);
  for (const auto& [name, fact] : facts_of(run))
    std::visit(
        [&, &name = name](const auto& value) {
          if constexpr (std::is_same_v<decltype(value), const int&>)
            file.attribute(name, std::int64_t{value});
          else if constexpr (std::is_same_v<decltype(value), const double&>)
            file.attribute(name, value);
          else
            file.attribute(name, std::string_view(value));
        },
        fact);
}

Writer::Parts variable_of(const Writer& file, const FilmLayer& layer, const ImageShape& shape) {
  Writer::Dimensions dimensions{"y", "x"};
  std::vector<std::size_t> chunk{std::min(chunk_rows, shape.height),
                                 std::min(chunk_columns, shape.width)};
  if (is_of_channels(layer)) {
    dimensions.emplace_back("channel");
    chunk.push_back(layer.channels);
  }
  return layer.name == "reliable"
             ? file.flags_in_parts(layer.name, dimensions, chunk, meaning_of(layer.name))
             : file.numbers_in_parts(layer.name, dimensions, chunk, meaning_of(layer.name));
}

// Some rows after the others: a large film is not held twice.
void write_layer(const Writer& file, const FilmLayer& layer, const ImageShape& shape) {
  const Writer::Parts variable = variable_of(file, layer, shape);
  std::vector<double> numbers;
  for (std::size_t y = 0; y < shape.height; y += chunk_rows) {
    const std::size_t rows = std::min(chunk_rows, shape.height - y);
    const std::size_t row = shape.width * layer.channels;
    numbers.resize(rows * row);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = layer.number(y * row + i);
    variable.put(y, rows, numbers);
  }
}

// ---- and back

FilmFacts facts_in(const Reader::Group& file) {
  FilmFacts facts;
  for (const std::string& name : file.attributes()) {
    if (file.is_text(name))
      facts[name] = file.text(name);
    else if (file.is_whole(name))
      facts[name] = static_cast<int>(file.count(name));
    else
      facts[name] = file.number(name);
  }
  return facts;
}

std::vector<int> shape_in(const Reader::Group& file) {
  const std::size_t height = file.dimension("y"), width = file.dimension("x"),
                    channels = file.dimension("channel");
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (height == 0 || width == 0 || (channels != 1 && channels != 3) || height > most ||
      width > most / height / channels)
    throw std::runtime_error("its dimensions are not those of an image");
  const int h = static_cast<int>(height), w = static_cast<int>(width);
  return channels == 1 ? std::vector{h, w} : std::vector{h, w, 3};
}

void require_fit(const Reader::Group& file, const FilmLayerSlot& slot, const ImageShape& shape) {
  std::size_t size = 1;
  for (const std::size_t length : file.lengths(slot.name)) size *= length;
  if (size != shape.pixels() * slot.channels)
    throw std::runtime_error(fmt::format("{}: it is not of the shape of the film", slot.name));
}

void read_layer(const Reader::Group& file, const FilmLayerSlot& slot, const ImageShape& shape) {
  require_fit(file, slot, shape);
  std::vector<double> numbers;
  for (std::size_t y = 0; y < shape.height; y += chunk_rows) {
    file.read_part(slot.name, y, std::min(chunk_rows, shape.height - y), numbers);
    const std::size_t from = y * shape.width * slot.channels;
    for (std::size_t i = 0; i < numbers.size(); ++i) slot.put(from + i, numbers[i]);
  }
}

RunRecord run_in(const Reader::Group& file) {
  RunRecord run = run_of(facts_in(file));
  FilmEstimate& film = run.rendering.film;
  film.shape = shape_in(file);
  const std::vector<std::string> names = file.variables();
  file.require_room("the film", static_cast<double>(ImageShape(film.shape).pixels()) *
                                    static_cast<double>(names.size() * sizeof(double)));
  for (const FilmLayerSlot& slot : slots_of(run.rendering, {names.begin(), names.end()}))
    read_layer(file, slot, ImageShape(film.shape));
  sum_up_mutations(run.rendering);
  return run;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RunFileError(fmt::format("{}: cannot be read", path.string()));
  std::string bytes(std::filesystem::file_size(path), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

}  // namespace

void write_film_netcdf(const RunRecord& run, const ByteSink& file) {
  const FilmEstimate& film = run.rendering.film;
  if (film.shape.size() < 2) throw std::logic_error("film.nc is for images");
  const ImageShape shape(film.shape);
  const std::vector<FilmLayer> layers = layers_of(run.rendering);
  Writer whole = Writer::create(sizeof(double) * layers.size() * shape.pixels() * shape.channels);
  write_facts(whole, run);
  whole.dimension("y", shape.height);
  whole.dimension("x", shape.width);
  whole.dimension("channel", shape.channels);
  whole.names("channel", "channel", channel_names(shape.channels), "Y, or linear Rec. 709");
  for (const FilmLayer& layer : layers) write_layer(whole, layer, shape);
  write_sealed(
      [&](const ByteSink& bytes) {
        whole.take(bytes);
        bytes(mark);
      },
      file);
}

bool is_film_netcdf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string end(mark.size() + seal_size, '\0');
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  return file && end.starts_with(mark);
}

RunRecord read_film_netcdf(const std::filesystem::path& path) {
  const std::string bytes = bytes_of(path);
  const auto whole = unsealed(bytes);
  if (!whole || !whole->ends_with(mark))
    throw RunFileError(
        fmt::format("{}: not a film of this program, or cut short or changed since it was written",
                    path.string()));
  try {
    const Reader reader(whole->substr(0, whole->size() - mark.size()));
    return run_in(reader.root());
  } catch (const std::runtime_error& problem) {
    throw RunFileError(
        fmt::format("{}: {}; not a film of format {}", path.string(), problem.what(), format));
  }
}

}  // namespace wander
