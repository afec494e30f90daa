// What a comparison has measured, before anything is made of it: each contender at each budget,
// several times, with seeds of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "records/rendering.h"
#include "records/run_record.h"
#include "work/clock.h"

namespace wander::compare {

// A method at one setting of its dials: a line of every table, a curve of every figure.
struct Contender {
  std::string label;   // "mlt"; in a sweep "mlt large_step=0.1", "mlt large_step=0.3 (default)"
  std::string method;  // of --method
  std::string dial{}, setting{};  // "large_step", "0.1"; both empty at the base point
};

// One rendering.  The film is whole, because errors against the mean of the replicates need it; that
// of an image may lie on the shelf of the comparison, and has a shape alone.
struct Run {
  std::size_t contender = 0, budget = 0, replicate = 0;
  std::uint64_t seed = 1, samples = 0;
  double seconds = 0;              // wall time of sampling, seed pass included
  double seed_seconds = 0;         // of which seed pass
  std::uint64_t seed_samples = 0;  // of the seed pass; 0 for independent samples
  FilmEstimate film;
  std::string command{};                 // that makes this run again, quoted for a shell
  double processor_seconds = not_known;  // of all threads in `seconds`

  double time(TimeKind kind) const { return kind == TimeKind::wall ? seconds : processor_seconds; }
};

// A rendering that gave no film: a chain that found no light to start from.
struct FailedRun {
  std::size_t contender = 0, budget = 0, replicate = 0;
  std::uint64_t seed = 1;
  std::string message;
};

// What errors are measured against: a film whose own error is known.
struct Reference {
  FilmEstimate film;   // standard_error is its own, and zero where it is exact
  std::string origin;  // in words: "exact: ...", a file, or the runs that it is the mean of
  std::vector<std::string> doubts{};   // why it may not be what it seems; each a sentence
  int max_vertices = 0;                // of its paths; 0: that is not known
  std::vector<std::uint64_t> seeds{};  // of a file of this scene: those that its samples have
};

// Gives the films that runs do not hold (film_loan.h).
using FilmShelf = std::function<FilmEstimate(const Run&)>;

struct Runs {
  Provenance provenance;  // of the scene and of the command
  std::vector<Contender> contenders{};
  std::vector<std::string> budgets{};  // as given: "1s", "2M"
  std::size_t replicates = 0;
  std::vector<Run> runs{};  // in the order in which they were made
  std::vector<FailedRun> failures{};
  double target = not_known;  // relative error asked for; not known: what the best reaches
  Reference reference{};
  // For each contender the first replicate at the last budget, with all its records; one without
  // samples where there is none.
  std::vector<Rendering> details{};
  std::vector<std::string> warnings{};
  bool complete = true;            // false: interrupted
  TimeKind time = TimeKind::wall;  // in which errors are told: that of the budgets
  FilmShelf shelf{};
};

}  // namespace wander::compare
