#include "records/exr.h"

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
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "core/film_layout.h"
#include "records/bin_maps.h"

namespace wander {

namespace {

using Plane = std::vector<float>;
using Planes = std::map<std::string, Plane>;  // by channel name

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

// Beyond the range of a float lies infinity; the exact number is in run.json.
float to_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  if (std::abs(x) > most)
    return std::copysign(std::numeric_limits<float>::infinity(), x > 0 ? 1.F : -1.F);
  return static_cast<float>(x);
}

Plane plane_of(const std::vector<double>& values) {
  Plane plane(values.size());
  std::transform(values.begin(), values.end(), plane.begin(), to_float);
  return plane;
}

Planes planes_of(const Rendering& rendering) {
  Planes planes;
  const FilmEstimate& film = rendering.film;
  planes["Y"] = plane_of(film.value);
  planes["standard_error.Y"] = plane_of(film.standard_error);
  planes["reliable.Y"] = Plane(film.reliable.begin(), film.reliable.end());
  for (const auto& [vertices, values] : film.by_length)
    planes[fmt::format("vertices_{}.Y", vertices)] = plane_of(values);
  for (const MutationRecord& mutation : rendering.mutations) {
    planes[fmt::format("acceptance.{}.Y", mutation.name)] =
        plane_of(on_bins(mutation.acceptance_per_bin, film));
    planes[fmt::format("proposed.{}.Y", mutation.name)] =
        plane_of(shared_by_bins(mutation.proposed_per_bin, film));
  }
  std::erase_if(planes, [](const auto& entry) { return entry.second.empty(); });
  return planes;
}

struct Size {
  int width, height;
  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

Size size_of(const FilmEstimate& film) {
  return film.shape.size() == 1 ? Size{film.shape[0], 1} : Size{film.shape.at(1), film.shape.at(0)};
}

void insert_text(Imf::Header& header, const char* name, const std::string& text) {
  header.insert(name, Imf::StringAttribute(text));
}

// "1 2 3"
std::string seeds_of(const std::vector<MergedRun>& runs) {
  std::string text;
  for (const MergedRun& run : runs) text += (text.empty() ? "" : " ") + std::to_string(run.seed);
  return text;
}

Imf::Header header_of(const RunRecord& run, const Planes& planes) {
  const Rendering& rendering = run.rendering;
  const Size size = size_of(rendering.film);
  Imf::Header header(size.width, size.height);
  // 16 rows at a time, for which the library makes room also where there is one.
  const bool is_long_row = size.height == 1 && FilmLayout{}.is_large(rendering.film.shape);
  header.compression() = is_long_row ? Imf::ZIPS_COMPRESSION : Imf::ZIP_COMPRESSION;
  insert_text(header, "scene", run.provenance.scene_text);
  insert_text(header, "scene_name", run.provenance.scene_name);
  insert_text(header, "scene_sha256", run.provenance.scene_sha256);
  insert_text(header, "command_line", run.provenance.command_line);
  insert_text(header, "wanderlight_version", run.provenance.version);
  for (const OriginField& field : origin_fields)
    insert_text(header, field.name, run.provenance.origin.*field.member);
  insert_text(header, "method", rendering.method);
  insert_text(header, "seed", std::to_string(rendering.seed));
  if (!rendering.merged.empty()) insert_text(header, "merged_seeds", seeds_of(rendering.merged));
  insert_text(header, "samples", std::to_string(rendering.samples));
  insert_text(header, "complete", rendering.complete ? "true" : "false");
  header.insert("dimension", Imf::IntAttribute(run.provenance.dimension));
  header.insert("degrees_of_freedom", Imf::DoubleAttribute(rendering.film.degrees_of_freedom));
  if (const auto& b = rendering.normalization) {
    header.insert("normalization", Imf::DoubleAttribute(b->value));
    header.insert("normalization_standard_error", Imf::DoubleAttribute(b->standard_error));
  }
  for (const auto& [name, plane] : planes) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  return header;
}

void insert_window(Imf::Header& header, const PlaneWindow& window) {
  header.insert("window_low", Imf::V2dAttribute({window.low[0], window.low[1]}));
  header.insert("window_high", Imf::V2dAttribute({window.high[0], window.high[1]}));
}

Imf::FrameBuffer frame_of(Planes& planes, Size size) {
  Imf::FrameBuffer frame;
  for (auto& [name, plane] : planes)
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float),
                                  sizeof(float) * static_cast<std::size_t>(size.width)));
  return frame;
}

// ---- and back

std::string text_in(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
  if (attribute == nullptr) throw std::runtime_error(fmt::format("it has no attribute '{}'", name));
  return attribute->value();
}

Origin origin_in(const Imf::Header& header) {
  Origin origin;
  for (const OriginField& field : origin_fields)
    if (header.find(field.name) != header.end()) origin.*field.member = text_in(header, field.name);
  return origin;
}

double number_in(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::DoubleAttribute>(name);
  if (attribute == nullptr) throw std::runtime_error(fmt::format("it has no attribute '{}'", name));
  return attribute->value();
}

std::uint64_t count_in(const Imf::Header& header, const char* name) {
  const std::string text = text_in(header, name);
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error(fmt::format("its attribute '{}' is not a count", name));
  return count;
}

int dimension_in(const Imf::Header& header) {
  const auto* attribute = header.findTypedAttribute<Imf::IntAttribute>("dimension");
  if (attribute == nullptr) throw std::runtime_error("it has no attribute 'dimension'");
  return attribute->value();
}

// A header may promise any size: memory is spent only if the file can hold so much.
Size plausible_size(const Imf::Header& header, std::uintmax_t file_bytes) {
  constexpr double best_compression = 4096;  // more than deflate reaches
  const auto& window = header.dataWindow();
  const double width = double(window.max.x) + 1, height = double(window.max.y) + 1;
  const Imf::ChannelList& channels = header.channels();
  double count = 0;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) ++count;
  if (window.min.x != 0 || window.min.y != 0) throw std::runtime_error("its data are shifted");
  if (width * height * count * sizeof(float) > best_compression * static_cast<double>(file_bytes))
    throw std::runtime_error("its header promises more than the file holds");
  return {window.max.x + 1, window.max.y + 1};
}

Planes read_planes(Imf::InputFile& file, Size size) {
  Planes planes;
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end();
       ++channel)
    planes[channel.name()].resize(size.pixels());
  file.setFrameBuffer(frame_of(planes, size));
  file.readPixels(0, size.height - 1);
  return planes;
}

std::vector<double> values_of(const Planes& planes, const std::string& name) {
  const auto found = planes.find(name);
  if (found == planes.end()) throw std::runtime_error(fmt::format("it has no channel '{}'", name));
  return {found->second.begin(), found->second.end()};
}

// The X of "PREFIX" X ".Y", if the name is of that form.
std::optional<std::string> between(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(".Y")) return std::nullopt;
  name.remove_prefix(prefix.size());
  name.remove_suffix(2);
  return std::string(name);
}

// Counts and mean acceptance follow from those per bin.
MutationRecord mutation_of(const Planes& planes, const std::string& name) {
  MutationRecord mutation;
  mutation.name = name;
  mutation.acceptance_per_bin = values_of(planes, fmt::format("acceptance.{}.Y", name));
  mutation.proposed_per_bin = values_of(planes, fmt::format("proposed.{}.Y", name));
  double proposed = 0, accepted = 0;
  for (std::size_t i = 0; i < mutation.proposed_per_bin.size(); ++i) {
    if (!(mutation.proposed_per_bin[i] > 0)) continue;  // the acceptance of nothing may be NaN
    proposed += mutation.proposed_per_bin[i];
    accepted += mutation.proposed_per_bin[i] * mutation.acceptance_per_bin[i];
  }
  if (!(proposed > 0 && proposed < 0x1p63)) return mutation;
  mutation.proposed = static_cast<std::uint64_t>(std::round(proposed));
  mutation.mean_acceptance = accepted / proposed;
  return mutation;
}

Rendering rendering_of(const Imf::Header& header, const Planes& planes, Size size) {
  Rendering rendering;
  rendering.complete = text_in(header, "complete") == "true";
  rendering.method = text_in(header, "method");
  rendering.samples = count_in(header, "samples");
  rendering.seed = count_in(header, "seed");
  rendering.processor_seconds = std::numeric_limits<double>::quiet_NaN();
  rendering.seconds = rendering.seed_seconds = std::numeric_limits<double>::quiet_NaN();
  FilmEstimate& film = rendering.film;
  film.shape = dimension_in(header) == 2 && size.height == 1 ? std::vector{size.width}
                                                             : std::vector{size.height, size.width};
  film.value = values_of(planes, "Y");
  film.standard_error = values_of(planes, "standard_error.Y");
  for (const double flag : values_of(planes, "reliable.Y")) film.reliable.push_back(flag != 0);
  film.degrees_of_freedom = number_in(header, "degrees_of_freedom");
  for (const auto& [name, plane] : planes) {
    if (const auto vertices = between(name, "vertices_"))
      film.by_length[std::stoi(*vertices)] = values_of(planes, name);
    if (const auto mutation = between(name, "acceptance."))
      rendering.mutations.push_back(mutation_of(planes, *mutation));
  }
  if (header.find("normalization") != header.end()) {
    rendering.normalization.emplace();
    rendering.normalization->value = number_in(header, "normalization");
    rendering.normalization->standard_error = number_in(header, "normalization_standard_error");
  }
  return rendering;
}

RunRecord run_of(const std::filesystem::path& path) {
  Imf::InputFile file(path.c_str(), 0);
  const Imf::Header& header = file.header();
  const Size size = plausible_size(header, std::filesystem::file_size(path));
  const Provenance provenance{text_in(header, "scene_name"),
                              text_in(header, "scene"),
                              text_in(header, "scene_sha256"),
                              dimension_in(header),
                              text_in(header, "command_line"),
                              text_in(header, "wanderlight_version"),
                              origin_in(header)};
  return {rendering_of(header, read_planes(file, size), size), provenance};
}

std::string image_of(const RunRecord& run, Planes planes, const Imf::Header& header) {
  const Size size = size_of(run.rendering.film);
  for (const auto& [name, plane] : planes)
    if (plane.size() != size.pixels())
      throw std::logic_error(fmt::format("channel {} does not fit the film", name));
  MemoryStream stream;
  {
    // The file is finished by the destructor.  Threads: none, so that bytes do not depend on them.
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame_of(planes, size));
    file.writePixels(size.height);
  }
  return stream.take();
}

// What the library and the readers above say becomes a fault of the file.
template <class Reading>
auto read_from(const std::filesystem::path& path, Reading&& reading) {
  try {
    return reading();
  } catch (const std::exception& problem) {
    throw RunFileError(
        fmt::format("{}: not a film of this program: {}", path.string(), problem.what()));
  }
}

}  // namespace

std::string to_exr(const RunRecord& run) {
  Planes planes = planes_of(run.rendering);
  const Imf::Header header = header_of(run, planes);
  return image_of(run, std::move(planes), header);
}

std::string to_exr(const RunRecord& run, const PlaneWindow& window) {
  Planes planes = planes_of(run.rendering);
  Imf::Header header = header_of(run, planes);
  insert_window(header, window);
  return image_of(run, std::move(planes), header);
}

RunRecord read_exr(const std::filesystem::path& path) {
  return read_from(path, [&] { return run_of(path); });
}

std::optional<PlaneWindow> read_window(const std::filesystem::path& path) {
  return read_from(path, [&]() -> std::optional<PlaneWindow> {
    const Imf::InputFile file(path.c_str(), 0);
    const auto* low = file.header().findTypedAttribute<Imf::V2dAttribute>("window_low");
    const auto* high = file.header().findTypedAttribute<Imf::V2dAttribute>("window_high");
    if (low == nullptr || high == nullptr) return std::nullopt;
    return PlaneWindow{{low->value().x, low->value().y}, {high->value().x, high->value().y}};
  });
}

}  // namespace wander
