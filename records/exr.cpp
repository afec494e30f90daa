#include "records/exr.h"

#include <IexBaseExc.h>
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/film_layout.h"
#include "records/exr_header.h"
#include "records/film_facts.h"
#include "records/film_layers.h"
#include "scenes/format/json_text.h"

namespace wander {

namespace {

// The library writes where it likes and returns to fill in offsets.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("film.exr") {}
  void write(const char bytes[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::copy_n(bytes, size, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

// Beyond the range of a float lies infinity; the exact number is in run.json or film.nc.
float to_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  if (std::abs(x) > most)
    return std::copysign(std::numeric_limits<float>::infinity(), x > 0 ? 1.F : -1.F);
  return static_cast<float>(x);
}

// ---- channels and layers

std::string channel_name(std::string_view layer, std::string_view channel) {
  return layer == "value" ? std::string(channel) : fmt::format("{}.{}", layer, channel);
}

// LAYER.C, or C alone of the estimate; none if it is no channel of such a film.
std::optional<std::string> layer_of(std::string_view name, std::size_t film_channels) {
  const std::size_t dot = name.rfind('.');
  const std::string_view channel = dot == std::string_view::npos ? name : name.substr(dot + 1);
  const std::string_view layer =
      dot == std::string_view::npos ? std::string_view("value") : name.substr(0, dot);
  const auto allowed = channel_names(channels_of(layer, film_channels));
  if (std::ranges::find(allowed, channel) == allowed.end()) return std::nullopt;
  return std::string(layer);
}

// ---- rows: few at a time, so that a large film is not held twice

// As many as the library compresses together.
constexpr std::size_t rows_at_once = 16;

struct Rows {
  std::size_t first, count, width;
  std::size_t pixels() const { return count * width; }
};

void for_rows(const ImageShape& shape, const std::function<void(const Rows&)>& visit) {
  for (std::size_t y = 0; y < shape.height; y += rows_at_once)
    visit({y, std::min(rows_at_once, shape.height - y), shape.width});
}

// The channels of a layer side by side in a buffer of these rows.
void insert_layer(Imf::FrameBuffer& frame, std::string_view layer, std::size_t channels,
                  std::vector<float>& buffer, const Rows& rows) {
  const auto names = channel_names(channels);
  const auto y = static_cast<int>(rows.first);
  const Imath::Box2i window(
      {0, y}, {static_cast<int>(rows.width) - 1, y + static_cast<int>(rows.count) - 1});
  for (std::size_t c = 0; c < channels; ++c)
    frame.insert(channel_name(layer, names[c]),
                 Imf::Slice::Make(Imf::FLOAT, buffer.data() + c, window, sizeof(float) * channels));
}

// ---- writing

void insert(Imf::Header& header, const FilmFacts& facts) {
  struct Insertion {
    Imf::Header& header;
    const char* name;
    void operator()(const std::string& text) { header.insert(name, Imf::StringAttribute(text)); }
    void operator()(int number) { header.insert(name, Imf::IntAttribute(number)); }
    void operator()(double number) { header.insert(name, Imf::DoubleAttribute(number)); }
  };
  for (const auto& [name, fact] : facts) std::visit(Insertion{header, name.c_str()}, fact);
}

Imf::Header header_of(const RunRecord& run, const std::vector<FilmLayer>& layers) {
  const ImageShape shape(run.rendering.film.shape);
  Imf::Header header(static_cast<int>(shape.width), static_cast<int>(shape.height));
  // 16 rows at a time, for which the library makes room also where there is one.
  const bool is_long_row = shape.height == 1 && FilmLayout{}.is_large(run.rendering.film.shape);
  header.compression() = is_long_row ? Imf::ZIPS_COMPRESSION : Imf::ZIP_COMPRESSION;
  insert(header, facts_of(run));
  for (const FilmLayer& layer : layers)
    for (const std::string_view channel : channel_names(layer.channels))
      header.channels().insert(channel_name(layer.name, channel), Imf::Channel(Imf::FLOAT));
  return header;
}

void insert_window(Imf::Header& header, const PlaneWindow& window) {
  header.insert("window_low", Imf::V2dAttribute({window.low[0], window.low[1]}));
  header.insert("window_high", Imf::V2dAttribute({window.high[0], window.high[1]}));
}

void write_rows(Imf::OutputFile& file, const std::vector<FilmLayer>& layers, const Rows& rows) {
  Imf::FrameBuffer frame;
  std::vector<std::vector<float>> buffers(layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const FilmLayer& layer = layers[k];
    buffers[k].resize(rows.pixels() * layer.channels);
    const std::size_t from = rows.first * rows.width * layer.channels;
    for (std::size_t i = 0; i < buffers[k].size(); ++i)
      buffers[k][i] = to_float(layer.number(from + i));
    insert_layer(frame, layer.name, layer.channels, buffers[k], rows);
  }
  file.setFrameBuffer(frame);
  file.writePixels(static_cast<int>(rows.count));
}

std::string image_of(const ImageShape& shape, const std::vector<FilmLayer>& layers,
                     const Imf::Header& header) {
  MemoryStream stream;
  {
    // The file is finished by the destructor.  Threads: none, so that bytes do not depend on them.
    Imf::OutputFile file(stream, header, 0);
    for_rows(shape, [&](const Rows& rows) { write_rows(file, layers, rows); });
  }
  return stream.take();
}

// ---- and back

FilmFacts facts_in(const Imf::Header& header) {
  FilmFacts facts;
  for (auto it = header.begin(); it != header.end(); ++it) {
    const Imf::Attribute& attribute = it.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute))
      facts[it.name()] = text->value();
    else if (const auto* count = dynamic_cast<const Imf::IntAttribute*>(&attribute))
      facts[it.name()] = count->value();
    else if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute))
      facts[it.name()] = number->value();
  }
  return facts;
}

struct Size {
  int width, height;
};

Size size_in(const Imf::Header& header) {
  const auto& window = header.dataWindow();
  if (window.min.x != 0 || window.min.y != 0) throw std::runtime_error("its data are shifted");
  return {window.max.x + 1, window.max.y + 1};
}

std::vector<int> shape_in(const Imf::Header& header, Size size, int dimension) {
  if (dimension == 2 && size.height == 1) return {size.width};
  if (header.channels().findChannel("Y") != nullptr) return {size.height, size.width};
  return {size.height, size.width, 3};
}

std::set<std::string> layers_in(const Imf::Header& header, const ImageShape& shape) {
  std::set<std::string> layers;
  const Imf::ChannelList& channels = header.channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    if (const auto layer = layer_of(channel.name(), shape.channels)) layers.insert(*layer);
  for (const std::string& layer : layers)
    for (const std::string_view channel : channel_names(channels_of(layer, shape.channels)))
      if (const std::string name = channel_name(layer, channel);
          channels.findChannel(name) == nullptr)
        throw std::runtime_error(fmt::format("it has no channel '{}'", name));
  return layers;
}

void read_rows(Imf::InputFile& file, const std::vector<FilmLayerSlot>& slots, const Rows& rows) {
  Imf::FrameBuffer frame;
  std::vector<std::vector<float>> buffers(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) {
    buffers[k].resize(rows.pixels() * slots[k].channels);
    insert_layer(frame, slots[k].name, slots[k].channels, buffers[k], rows);
  }
  file.setFrameBuffer(frame);
  file.readPixels(static_cast<int>(rows.first), static_cast<int>(rows.first + rows.count) - 1);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::size_t from = rows.first * rows.width * slots[k].channels;
    for (std::size_t i = 0; i < buffers[k].size(); ++i) slots[k].put(from + i, buffers[k][i]);
  }
}

RunRecord run_in(const std::filesystem::path& path) {
  require_plausible_header(path);
  Imf::InputFile file(path.c_str(), 0);
  const Imf::Header& header = file.header();
  const Size size = size_in(header);
  RunRecord run = run_of(facts_in(header));
  run.rendering.film.shape = shape_in(header, size, run.provenance.dimension);
  const ImageShape shape(run.rendering.film.shape);
  const auto slots = slots_of(run.rendering, layers_in(header, shape));
  for_rows(shape, [&](const Rows& rows) { read_rows(file, slots, rows); });
  sum_up_mutations(run.rendering);
  return run;
}

// What the readers above say becomes a fault of the file; what the library says is told in our own words.
template <class Reading>
auto read_from(const std::filesystem::path& path, Reading&& reading) {
  const auto refuse = [&](std::string_view what) {
    throw RunFileError(fmt::format("{}: not a film of this program: {}", path.string(), what));
  };
  try {
    return reading();
  } catch (const std::runtime_error& problem) {
    refuse(printable(problem.what()));  // names of channels may be anything
  } catch (const Iex::BaseExc&) {
    refuse("its header or its pixels are damaged, cut short or of another kind");
  }
  return decltype(reading()){};
}

}  // namespace

std::string to_exr(const RunRecord& run) {
  const std::vector<FilmLayer> layers = layers_of(run.rendering);
  return image_of(ImageShape(run.rendering.film.shape), layers, header_of(run, layers));
}

std::string to_exr(const RunRecord& run, const PlaneWindow& window) {
  const std::vector<FilmLayer> layers = layers_of(run.rendering);
  Imf::Header header = header_of(run, layers);
  insert_window(header, window);
  return image_of(ImageShape(run.rendering.film.shape), layers, header);
}

bool is_exr(const std::filesystem::path& path) {
  std::string beginning(4, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RunFileError(fmt::format("{}: cannot be read", path.string()));
  file.read(beginning.data(), 4);
  return beginning == "\x76\x2f\x31\x01";
}

RunRecord read_exr(const std::filesystem::path& path) {
  return read_from(path, [&] { return run_in(path); });
}

std::optional<PlaneWindow> read_window(const std::filesystem::path& path) {
  return read_from(path, [&]() -> std::optional<PlaneWindow> {
    require_plausible_header(path);
    const Imf::InputFile file(path.c_str(), 0);
    const auto* low = file.header().findTypedAttribute<Imf::V2dAttribute>("window_low");
    const auto* high = file.header().findTypedAttribute<Imf::V2dAttribute>("window_high");
    if (low == nullptr || high == nullptr) return std::nullopt;
    return PlaneWindow{{low->value().x, low->value().y}, {high->value().x, high->value().y}};
  });
}

}  // namespace wander
