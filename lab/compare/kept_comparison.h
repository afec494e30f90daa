// What is kept of a comparison on its way, in the folder `kept` of its directory, so that it can be
// carried on:
//
//   plan         what was asked for, with the text of the scene
//   reference    what errors are measured against, once it is there
//   runs-0001 …  runs that have come to their end, some in each file; of images one in each, from
//                which its film is read when it is wanted
//
// Each is written whole or not at all:
//   "wanderlight-kept/3\n" HEADER "\n" BODY SEAL
// HEADER is a line of JSON: the version of the program that wrote it, which part it is, and of which
// comparison, by a digest of the plan.  The body of the plan is JSON, and those of the others are
// read by the version that wrote them.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "lab/compare/runs.h"
#include "lab/compare/schedule.h"
#include "lab/kept_scene.h"

namespace wander::compare {

// What was asked for, in the words of the command line.
struct Request {
  KeptScene scene{};
  std::string methods{}, budgets{}, reference{};
  std::vector<std::string> fixed{}, sweeps{};  // of dials
  std::uint64_t seed = 1;
  // These two may become others on the way.
  std::size_t replicates = 0;
  double target = not_known;
};

struct KeptReference {
  Reference reference;
  std::vector<std::string> warnings{};  // of its making
};

// A turn that has come to its end: a run or one that failed, and where all its records are wanted
// (Runs::details), these.
struct FinishedTurn {
  std::optional<Run> run{};
  std::optional<FailedRun> failure{};
  std::optional<Rendering> details{};
};

class KeptComparison {
 public:
  // Keeps nothing.
  KeptComparison() = default;
  // A new one, in the directory of its files.  What was kept of another there is set aside, and goes when the first
  // run of this one is kept.
  KeptComparison(Request request, const std::filesystem::path& directory);
  // Throws UsageError if none is kept there, RunFileError if it is damaged or of another version.
  static KeptComparison in(const std::filesystem::path& directory);

  const Request& request() const { return request_; }
  // What may change when it is carried on; replicates never become fewer.
  void extend(std::size_t replicates, double target);

  const std::optional<KeptReference>& reference() const { return reference_; }
  void keep(KeptReference reference);

  // Of turns that had come to their end when it was carried on.
  std::size_t finished() const { return turns_.size(); }
  bool has(const Turn& turn) const { return turns_.contains(place_of(turn)); }
  FinishedTurn take(const Turn& turn);  // one that it has; the film of an image stays in its file

  // Is the film of this run, which was kept, in a file of its own?
  bool has_film_of(const Run& run) const { return films_.contains(place_of(run)); }
  FilmEstimate film_of(const Run& run) const;

  // Kept at once, unless that would take more than a small part of the time; then with one of the
  // next, or by keep_all().
  void keep(const FinishedTurn& finished);
  void keep_all();

  // Of a comparison that came to nothing: what had been set aside for it is there again.
  void discard();

 private:
  using Clock = std::chrono::steady_clock;
  using Place = std::tuple<std::size_t, std::size_t, std::size_t, std::uint64_t>;

  template <class T>
  static Place place_of(const T& of) {
    return {of.contender, of.budget, of.replicate, of.seed};
  }
  void read_runs();
  std::vector<FinishedTurn> read_turns(std::size_t number) const;
  static std::string name_of(std::size_t number);
  std::string identity() const;
  std::string body_of(const std::string& part) const;
  void write(const std::string& part, const std::string& body) const;
  void write_plan() const;
  std::filesystem::path set_aside() const;

  std::filesystem::path folder_{};  // empty: nothing is kept
  Request request_{};
  std::optional<KeptReference> reference_{};
  std::map<Place, FinishedTurn> turns_{};  // that were kept before
  std::vector<FinishedTurn> waiting_{};    // to be kept
  std::map<Place, std::size_t> films_{};   // of images, by the number of their file
  std::size_t files_ = 0;                  // of runs
  Clock::time_point written_{};            // when the last file of runs was
  Clock::duration cost_{};                 // of writing it
};

// Is there one, finished or not?
bool holds_kept_comparison(const std::filesystem::path& directory);
// The folder of what is kept.
std::filesystem::path kept_in(const std::filesystem::path& directory);

}  // namespace wander::compare
