// What all sections of a report speak of: the comparison, its scene, and what follows from both.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/axis.h"
#include "draw/figure/marker.h"
#include "lab/compare/comparison.h"

namespace wander::report {

using compare::Cell;
using compare::Comparison;
using compare::Contender;
using compare::Run;
using compare::Runs;

struct Subject {
  const Comparison& comparison;
  description::Scene scene;

  const Runs& runs() const { return comparison.runs; }
  std::size_t contenders() const { return runs().contenders.size(); }
  std::size_t last_budget() const { return runs().budgets.size() - 1; }
  const std::string& label(std::size_t contender) const {
    return runs().contenders[contender].label;
  }
  std::vector<std::string> labels() const;

  // The replicates of a contender, at the last budget unless said otherwise.
  std::vector<const Run*> replicates(std::size_t contender) const {
    return replicates(contender, last_budget());
  }
  std::vector<const Run*> replicates(std::size_t contender, std::size_t budget) const;
  // Films are images.
  bool is_image() const { return scene.dimension == 3; }
  // What a film is made of.
  const char* bins() const { return is_image() ? "numbers" : "bins"; }
  std::string unit_of_bins() const;
  // Empty where there is no such cell.
  std::vector<Cell> cells(std::size_t contender) const;
  // The whole record of the first replicate at the last budget; null where it is missing.
  const Rendering* details(std::size_t contender) const;
};

description::Scene scene_of(const Comparison& comparison);

// The replicates of a contender at a budget with their films, those from the shelf included, for as
// long as it lives.
class WholeReplicates {
 public:
  WholeReplicates(const Subject& subject, std::size_t contender, std::size_t budget);
  WholeReplicates(const WholeReplicates&) = delete;
  WholeReplicates& operator=(const WholeReplicates&) = delete;

  const std::vector<const Run*>& runs() const { return runs_; }

 private:
  std::deque<Run> lent_{};
  std::vector<const Run*> runs_{};
};

// Contenders whose records of chains exist.
std::vector<std::size_t> chain_contenders(const Subject& subject);

// As wide as a page of a journal; narrower on screens that are.
inline constexpr double figure_width = figure::style::page_width;

}  // namespace wander::report
