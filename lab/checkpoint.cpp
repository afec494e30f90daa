#include "lab/checkpoint.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "lab/failure.h"
#include "lab/packing.h"
#include "records/atomic_file.h"
#include "records/json_place.h"
#include "records/run_record.h"
#include "records/seal.h"
#include "records/version.h"
#include "scenes/format/json_text.h"

namespace wander {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::string_view family = "wanderlight-checkpoint/", format = "wanderlight-checkpoint/13";

class Refusal {
 public:
  Refusal(const fs::path& file, std::string_view remedy) : file_(file), remedy_(remedy) {}

  [[noreturn]] void operator()(std::string_view what) const {
    throw RunFileError(fmt::format("{}: {}; {}", file_.string(), what, remedy_));
  }

 private:
  const fs::path& file_;
  std::string_view remedy_;
};

// How large a state is stands behind it, packed as it is: it is known when it has been written.
std::string bytes_of_size(std::uint64_t size) {
  std::string bytes(sizeof size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  return bytes;
}

// None if it is not what is packed there.
std::optional<std::string> state_in(std::string_view bytes) {
  std::uint64_t size = 0;
  if (bytes.size() < sizeof size) return std::nullopt;
  std::memcpy(&size, bytes.data() + bytes.size() - sizeof size, sizeof size);
  bytes.remove_suffix(sizeof size);
  return unpacked(bytes, size);
}

ordered_json to_json(const std::vector<Look>& looks) {
  ordered_json list = ordered_json::array();
  for (const Look& look : looks)
    list.push_back({{"samples", look.samples},
                    {"error", look.error},
                    {"degrees_of_freedom", look.degrees_of_freedom}});
  return list;
}

ordered_json header_of(const Checkpoint& c) {
  const Headway& h = c.run.headway;
  return {{"version", program_version()},
          {"scene", to_json(c.scene)},
          {"method", c.method},
          {"budget", c.budget},
          {"dials", c.dials},
          {"seed", c.seed},
          {"precision", name_of(c.turned().precision)},
          {"samples", h.samples},
          {"seconds", h.wall_seconds},
          {"processor_seconds", h.processor_seconds},
          {"seed_seconds", h.seed_seconds},
          {"looks",
           {{"target", h.target},
            {"seed_goal", h.seed_goal},
            {"goal", h.goal},
            {"seen", to_json(h.looks)}}}};
}

Checkpoint from_header(const JsonPlace& header) {
  Checkpoint c;
  c.scene = kept_scene_from(header.at("scene"));
  c.method = header.at("method");
  c.budget = header.at("budget");
  c.dials = header.at("dials").get<std::map<std::string, std::string>>();
  c.seed = header.at("seed");
  Headway& h = c.run.headway;
  h.samples = header.at("samples");
  h.wall_seconds = header.at("seconds");
  h.processor_seconds = header.at("processor_seconds");
  h.seed_seconds = header.at("seed_seconds");
  const JsonPlace looks = header.at("looks");
  h.target = looks.at("target");
  h.seed_goal = looks.at("seed_goal");
  h.goal = looks.at("goal");
  for (const JsonPlace& look : looks.at("seen").elements())
    h.looks.push_back({look.at("samples"), look.at("error"), look.at("degrees_of_freedom")});
  return c;
}

// Takes what comes before the next end of a line.
std::string_view take_line(std::string_view& bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
  return line;
}

std::string bytes_of(const fs::path& file, const Refusal& refuse) {
  std::error_code problem;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !fs::is_regular_file(file, problem)) refuse("cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

[[noreturn]] void refuse_without_checkpoint(const fs::path& directory, std::string_view remedy) {
  std::error_code problem, of_file;
  const std::string name = directory.string();
  const fs::file_status status = fs::status(directory, problem);
  if (status.type() == fs::file_type::not_found)
    throw UsageError(name + ": there is no such directory; check the path");
  if (fs::exists(status) && !fs::is_directory(status))
    throw UsageError(name + " is no directory; name that of a run, which holds its checkpoint");
  // One may see a directory and not what is in it.
  if (fs::status(checkpoint_in(directory), of_file).type() == fs::file_type::none)
    throw RunFileError(
        fmt::format("{} cannot be read ({}); check its permissions", name, of_file.message()));
  throw UsageError(fmt::format("{} holds no checkpoint; {}", name, remedy));
}

}  // namespace

Dials Checkpoint::turned() const {
  Dials values;
  for (const auto& [word, text] : dials) find_dial(word).set(values, text);
  return values;
}

fs::path checkpoint_in(const fs::path& directory) { return directory / "checkpoint"; }

void write_checkpoint(const Checkpoint& checkpoint, const StateWriter& state,
                      const fs::path& directory) {
  // What is no UTF-8, such as the name of a file, must not end a run.
  const std::string header =
      header_of(checkpoint).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  write_file(checkpoint_in(directory), [&](const ByteSink& file) {
    write_sealed(
        [&](const ByteSink& bytes) {
          bytes(fmt::format("{}\n{}\n", format, header));
          Packing packing(bytes);
          std::uint64_t size = 0;
          write_through(
              [&](std::string_view piece) {
                packing.add(piece);
                size += piece.size();
              },
              state);
          packing.end();
          bytes(bytes_of_size(size));
        },
        file);
  });
}

Checkpoint read_checkpoint(const fs::path& directory, std::string_view remedy) {
  const fs::path file = checkpoint_in(directory);
  std::error_code error;
  if (!fs::exists(file, error)) refuse_without_checkpoint(directory, remedy);
  const Refusal refuse(file, remedy);
  const std::string whole = bytes_of(file, refuse);
  if (!std::string_view(whole).starts_with(family)) refuse("is not a checkpoint of a run");
  const auto unbroken = unsealed(whole);
  if (!unbroken) refuse("the checkpoint is damaged or cut short");
  std::string_view bytes = *unbroken;
  if (const std::string_view found = take_line(bytes); found != format)
    refuse(fmt::format("its format is {}, and this program reads {}", excerpt(found), format));
  try {
    const ordered_json document = parsed_json(take_line(bytes));
    const JsonPlace header(document);
    if (const auto version = header.at("version").get<std::string>(); version != program_version())
      refuse(fmt::format("it is of version {} of the program, and this is {}", excerpt(version),
                         program_version()));
    Checkpoint checkpoint = from_header(header);
    checkpoint.scene.beside = fs::absolute(directory).string();
    checkpoint.turned();
    auto state = state_in(bytes);
    if (!state) refuse("its state cannot be read");
    checkpoint.run.state = *std::move(state);
    return checkpoint;
  } catch (const JsonPlaceError& problem) {
    refuse(fmt::format("its header cannot be read ({})", problem.what()));
  } catch (const UsageError& problem) {
    refuse(problem.what());
  }
}

}  // namespace wander
