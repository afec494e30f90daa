// The course of a comparison: renderings one after the other, all threads on each, with one account
// of how far all of them together are.
#pragma once

#include <chrono>
#include <string>

#include "core/description.h"
#include "lab/engine.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander::compare {

class Course {
 public:
  // Threads, interruption and report are those of `common`; `effort` is the sum of all budgets that
  // are to come (effort_of).
  Course(const description::Scene& scene, const Session& common, double effort);

  // What is still to come, better known than at the beginning; the bar does not go back.
  void expect(double effort) { effort_ = done_ + effort; }

  // `what` stands beside the bar: "bdpt 4s, replicate 3 of 8".
  Rendering render(const Job& job, const Budget& budget, std::uint64_t seed,
                   const std::string& what);

  // Of the runs that make a reference: all dials as usual.
  Job usual(const Method& method) const { return {scene_, method}; }
  const description::Scene& scene() const { return scene_; }

  bool is_interrupted() const { return common_.interrupted && common_.interrupted->load(); }

 private:
  double seconds() const;

  const description::Scene& scene_;
  Session common_;
  double effort_, done_ = 0;
  double fraction_ = 0;  // that was reported last
  std::uint64_t samples_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace wander::compare
