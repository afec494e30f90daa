// What all sections of a report speak of: the comparison, its scene, and what follows from both.
#pragma once

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

  // The replicates of a contender at the last budget.
  std::vector<const Run*> replicates(std::size_t contender) const;
  // Empty where there is no such cell.
  std::vector<Cell> cells(std::size_t contender) const;
  // The whole record of the first replicate at the last budget; null where it is missing.
  const Rendering* details(std::size_t contender) const;
};

Subject subject_of(const Comparison& comparison);

// Contenders whose records of chains exist.
std::vector<std::size_t> chain_contenders(const Subject& subject);

// As wide as a page of a journal; narrower on screens that are.
inline constexpr double figure_width = figure::style::page_width;

}  // namespace wander::report
