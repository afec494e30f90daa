#include "lab/compare/kept_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/image_shape.h"
#include "lab/compare/film_loan.h"
#include "lab/failure.h"
#include "records/atomic_file.h"
#include "records/json_place.h"
#include "records/rendering_archive.h"
#include "records/run_record.h"
#include "records/seal.h"
#include "records/version.h"
#include "scenes/format/json_text.h"
#include "scenes/format/sha256.h"

namespace wander::compare {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

template <class Archive>
void serialize(Archive& archive, Run& run) {
  archive(run.contender, run.budget, run.replicate, run.seed, run.samples, run.seconds,
          run.seed_seconds, run.seed_samples, run.film, run.command, run.processor_seconds);
}
template <class Archive>
void serialize(Archive& archive, FailedRun& run) {
  archive(run.contender, run.budget, run.replicate, run.seed, run.message);
}
template <class Archive>
void serialize(Archive& archive, FinishedTurn& turn) {
  archive(turn.run, turn.failure, turn.details);
}
template <class Archive>
void serialize(Archive& archive, Reference& reference) {
  archive(reference.film, reference.origin, reference.doubts, reference.max_vertices);
}
template <class Archive>
void serialize(Archive& archive, KeptReference& kept) {
  archive(kept.reference, kept.warnings);
}

namespace {

constexpr std::string_view format = "wanderlight-kept/5", family = "wanderlight-kept/";
constexpr const char* plan_part = "plan";
constexpr const char* reference_part = "reference";
constexpr std::string_view runs_prefix = "runs-";
constexpr std::string_view anew =
    "; compare anew: `wander compare SCENE … --force`, without --continue";
constexpr int share_of_keeping = 20;  // one part in so many of the time

[[noreturn]] void refuse(const fs::path& file, std::string_view what) {
  throw RunFileError(fmt::format("{}: {}{}", file.string(), what, anew));
}

template <class Value>
Value value_of(const fs::path& file, const std::string& body) {
  try {
    return from_archive<Value>(body);
  } catch (const ArchiveError& problem) {
    refuse(file, fmt::format("it cannot be read ({})", problem.what()));
  }
}

// Takes what comes before the next end of a line.
std::string_view take_line(std::string_view& bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
  return line;
}

struct KeptPart {
  std::string comparison, body;
};

KeptPart read_part(const fs::path& file, const std::string& part) {
  std::error_code problem;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !fs::is_regular_file(file, problem)) refuse(file, "it cannot be read");
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  if (!std::string_view(whole).starts_with(family)) refuse(file, "is no part of a comparison");
  const auto unbroken = unsealed(whole);
  if (!unbroken) refuse(file, "it is damaged or cut short");
  std::string_view bytes = *unbroken;
  if (const std::string_view found = take_line(bytes); found != format)
    refuse(file,
           fmt::format("its format is {}, and this program reads {}", excerpt(found), format));
  try {
    const ordered_json document = parsed_json(take_line(bytes));
    const JsonPlace header(document);
    if (const auto version = header.at("version").get<std::string>(); version != program_version())
      refuse(file, fmt::format("it is of version {} of the program, and this is {}",
                               excerpt(version), program_version()));
    if (header.at("part").get<std::string>() != part)
      refuse(file, "it is another part of a comparison");
    return {header.at("comparison"), std::string(bytes)};
  } catch (const JsonPlaceError& problem) {
    refuse(file, fmt::format("its header cannot be read ({})", problem.what()));
  }
}

// What makes a comparison the one that it is.
ordered_json identity_of(const Request& r) {
  return {{"scene", whole_digest(r.scene.digest)},
          {"methods", r.methods},
          {"budgets", r.budgets},
          {"reference", r.reference},
          {"dials", r.fixed},
          {"sweeps", r.sweeps},
          {"seed", r.seed}};
}

std::string json_of(const Request& r) {
  ordered_json json = identity_of(r);
  json["scene"] = to_json(r.scene);
  json["replicates"] = r.replicates;
  json["target"] = std::isfinite(r.target) ? ordered_json(r.target) : ordered_json(nullptr);
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Request request_from(const fs::path& file, const std::string& text) {
  try {
    const ordered_json document = parsed_json(text);
    const JsonPlace json(document);
    return {.scene = kept_scene_from(json.at("scene")),
            .methods = json.at("methods"),
            .budgets = json.at("budgets"),
            .reference = json.at("reference"),
            .fixed = json.at("dials").get<std::vector<std::string>>(),
            .sweeps = json.at("sweeps").get<std::vector<std::string>>(),
            .seed = json.at("seed"),
            .replicates = json.at("replicates"),
            .target = json.at("target").number()};
  } catch (const JsonPlaceError& problem) {
    refuse(file, fmt::format("the plan cannot be read ({})", problem.what()));
  }
}

// Of a file of runs its number; 0 if it is another.
std::size_t number_of(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(runs_prefix)) return 0;
  std::size_t number = 0;
  std::from_chars(name.data() + runs_prefix.size(), name.data() + name.size(), number);
  return number;
}

bool holds_more_than_a_plan(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename().string();
        name == reference_part || name.starts_with(runs_prefix))
      return true;
  return false;
}

}  // namespace

fs::path kept_in(const fs::path& directory) { return directory / "kept"; }

bool holds_kept_comparison(const fs::path& directory) {
  std::error_code error;
  return fs::exists(kept_in(directory) / plan_part, error);
}

KeptComparison::KeptComparison(Request request, const fs::path& directory)
    : folder_(kept_in(directory)), request_(std::move(request)) {
  if (holds_more_than_a_plan(folder_)) {
    fs::remove_all(set_aside());
    fs::rename(folder_, set_aside());
  }
  fs::remove_all(folder_);
  fs::create_directory(folder_);
  write_plan();
}

fs::path KeptComparison::set_aside() const { return fs::path(folder_) += ".before"; }

KeptComparison KeptComparison::in(const fs::path& directory) {
  if (!holds_kept_comparison(directory))
    throw UsageError(fmt::format("{} holds nothing of a comparison that could be carried on{}",
                                 directory.string(), anew));
  KeptComparison kept;
  kept.folder_ = kept_in(directory);
  const fs::path plan = kept.folder_ / plan_part;
  const KeptPart part = read_part(plan, plan_part);
  kept.request_ = request_from(plan, part.body);
  if (part.comparison != kept.identity()) refuse(plan, "it contradicts itself");
  if (const fs::path file = kept.folder_ / reference_part; fs::exists(file))
    kept.reference_ = value_of<KeptReference>(file, kept.body_of(reference_part));
  kept.read_runs();
  return kept;
}

void KeptComparison::read_runs() {
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::size_t number = number_of(entry.path());
    if (number == 0) continue;
    files_ = std::max(files_, number);
    for (FinishedTurn& turn : read_turns(number)) {
      if (!turn.run && !turn.failure) refuse(entry.path(), "a run of it is missing");
      const Place place = turn.run ? place_of(*turn.run) : place_of(*turn.failure);
      if (turn.run && is_image(turn.run->film.shape)) {
        films_[place] = number;
        shelve(turn.run->film);
      }
      turns_[place] = std::move(turn);
    }
  }
}

std::vector<FinishedTurn> KeptComparison::read_turns(std::size_t number) const {
  const std::string name = name_of(number);
  return value_of<std::vector<FinishedTurn>>(folder_ / name, body_of(name));
}

std::string KeptComparison::name_of(std::size_t number) {
  return fmt::format("{}{:04}", runs_prefix, number);
}

FilmEstimate KeptComparison::film_of(const Run& run) const {
  const std::size_t number = films_.at(place_of(run));
  for (FinishedTurn& turn : read_turns(number))
    if (turn.run && place_of(*turn.run) == place_of(run)) return std::move(turn.run->film);
  refuse(folder_ / name_of(number), "a run of it is missing");
}

std::string KeptComparison::identity() const { return sha256(identity_of(request_).dump()); }

std::string KeptComparison::body_of(const std::string& part) const {
  KeptPart read = read_part(folder_ / part, part);
  if (read.comparison != identity()) refuse(folder_ / part, "it is of another comparison");
  return std::move(read.body);
}

void KeptComparison::write(const std::string& part, const std::string& body) const {
  const ordered_json header{
      {"version", program_version()}, {"part", part}, {"comparison", identity()}};
  write_file(folder_ / part, sealed(fmt::format("{}\n{}\n{}", format, header.dump(), body)));
}

void KeptComparison::write_plan() const { write(plan_part, json_of(request_)); }

void KeptComparison::extend(std::size_t replicates, double target) {
  request_.replicates = replicates;
  request_.target = target;
  remove_leftovers(folder_);
  write_plan();
}

void KeptComparison::keep(KeptReference reference) {
  reference_ = std::move(reference);
  if (!folder_.empty()) write(reference_part, archived(*reference_));
}

FinishedTurn KeptComparison::take(const Turn& turn) {
  return std::move(turns_.extract(place_of(turn)).mapped());
}

void KeptComparison::keep(const FinishedTurn& finished) {
  if (folder_.empty()) return;
  waiting_.push_back(finished);
  if (finished.run && is_image(finished.run->film.shape)) {
    keep_all();
    films_[place_of(*finished.run)] = files_;
  } else if (Clock::now() - written_ >= share_of_keeping * cost_) {
    keep_all();
  }
}

void KeptComparison::keep_all() {
  if (waiting_.empty()) return;
  const Clock::time_point before = Clock::now();
  write(name_of(++files_), archived(waiting_));
  // One whose runs all fail comes to nothing.
  if (std::ranges::any_of(waiting_, [](const FinishedTurn& turn) { return turn.run.has_value(); }))
    fs::remove_all(set_aside());
  waiting_.clear();
  written_ = Clock::now();
  cost_ = written_ - before;
}

void KeptComparison::discard() {
  if (!folder_.empty()) {
    fs::remove_all(folder_);
    if (fs::exists(set_aside())) fs::rename(set_aside(), folder_);
  }
  *this = {};
}

}  // namespace wander::compare
