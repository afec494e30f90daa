// The methods: the one table of what each is, from which the command line, its help and messages,
// the checks, the comparison and the record of a run are fed.
//
// A new method is an entry of the table (method.cpp) and a file that makes its run.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/description.h"
#include "lab/dial_set.h"
#include "lab/world_list.h"

namespace wander {

struct Estimator;  // lab/estimate.h
class LiveRun;     // lab/live_run.h
template <World W>
struct Stage;  // lab/stage.h

template <World W>
using MakeRun = std::unique_ptr<LiveRun> (*)(const Stage<W>&);

// How a method makes its run in each world, from a type with a static make<W>(stage).
template <class List>
struct RunMakers;
template <World... Ws>
struct RunMakers<WorldList<Ws...>> {
  std::tuple<MakeRun<Ws>...> makers;

  template <class Kind>
  static constexpr RunMakers of() {
    return {{&Kind::template make<Ws>...}};
  }
};
template <class Kind>
inline constexpr RunMakers<Worlds> made_by = RunMakers<Worlds>::of<Kind>();

// What a chain of the method walks through.
enum class ChainState {
  none,               // there is no chain: samples are independent
  path,               // a path, changed in path space
  numbers_of_path,    // the random numbers of one path
  numbers_of_sample,  // the random numbers of a whole sample, which is many paths
};

// What the steps of pssmlt and mmlt deposit (mlt/primary/primary_estimator.h).
enum class StepEstimator { usual, kelemen, expected };

// In `check`.
enum class CheckRole { none, reference, compared };

// Why not, in words that follow the name of the method; empty where it can.
using WhyNot = std::string_view (*)(const description::Scene&);

struct Method {
  std::string_view name, summary;
  ChainState state;
  DialSet dials;
  RunMakers<Worlds> run;
  const Estimator* estimator = nullptr;  // of a method by independent samples of paths
  CheckRole check = CheckRole::none;
  bool makes_references = false;  // for `compare`, where it is worth most
  StepEstimator usual_estimator = StepEstimator::expected;
  WhyNot why_impossible;  // it can render no scene such as this
  WhyNot why_blind;       // it renders this scene, but does not see all of its light

  constexpr bool is_markov_chain() const { return state != ChainState::none; }
  // Recorded by `trace`: a state is one path.
  constexpr bool is_traced() const {
    return state == ChainState::path || state == ChainState::numbers_of_path;
  }
  // A step can be taken apart: it is proposed in path space.
  constexpr bool is_replayed() const { return state == ChainState::path; }
  bool sees_all_light(const description::Scene& scene) const { return why_blind(scene).empty(); }
};

std::span<const Method> methods();
// Throws UsageError, with the nearest name, where there is no such method.
const Method& find_method(std::string_view name);

// Those of which it holds, in the order of the table.
template <class Holds>
std::vector<const Method*> methods_that(Holds&& holds) {
  std::vector<const Method*> found;
  for (const Method& method : methods())
    if (holds(method)) found.push_back(&method);
  return found;
}

// "mlt, pssmlt and mmlt"
std::string in_words(std::span<const Method* const> methods, std::string_view last_link = "and");

// All others are held against it.
const Method& reference_method();
// Those that `check` holds against the reference.
std::vector<const Method*> checked_methods();
// What `trace` records; the first is the usual one.
std::vector<const Method*> traced_methods();

}  // namespace wander
