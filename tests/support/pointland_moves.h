// What a bidirectional mutation chose, read from its choices; and wrong twins of it, which change
// the densities that it claims.  A twin proposes as the mutation does, so each is one forgotten or
// mistaken factor of T(x→y).
#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mutations/bidirectional.h"
#include "tests/support/pointland.h"

namespace wander::test {

// The label (L, M, d → a) of a transition, and the split that made it.
struct Move {
  Bidirectional::Kept kept;
  int deleted, added, split;
};

// The choices of a mutation that proposed y from x, in the order in which it made them.
inline Move move_of(std::span<const int> choices, const PointPath& x, const PointPath& y) {
  std::size_t next = 0;
  const int n = x.size(), deleted = choices[next++];
  int light = 0;
  if (deleted == 0)
    light = 1 + choices[next++];
  else if (deleted < n)
    light = choices[next++] == 1 ? n - deleted : choices[next++];
  const int added = choices[next++];
  const Bidirectional::Kept kept{light, n - deleted - light};
  if (kept.light + added + kept.sensor != y.size())
    throw std::logic_error("the mutation makes its choices in another order than the tests know");
  return {kept, deleted, added, choices[next]};
}

// Passes choices on and remembers them.
template <class Random>
class Remembering {
 public:
  explicit Remembering(Random& random) : random_(&random) {}
  int choose(std::span<const double> pmf) { return remember(random_->choose(pmf)); }
  int choose(int count) { return remember(random_->choose(count)); }
  std::span<const int> choices() const { return choices_; }

 private:
  int remember(int choice) {
    choices_.push_back(choice);
    return choice;
  }
  Random* random_;
  std::vector<int> choices_;
};

// A transition x→y whose densities a twin may spoil.
struct Transition {
  const Graph& graph;
  const PointPath &x, &y;
  Move move;
};

struct BidirectionalTwin {
  static constexpr std::string_view name = "bidirectional twin";
  std::function<void(const Transition&, Proposal&)> spoil;

  double applicability(const Graph&, const PointPath&) const { return 1; }

  template <class Random>
  Proposed propose(const Graph& graph, const PointPath& x, PointPath& y, Random& random) const {
    Remembering<Random> remembering(random);
    Proposed proposed = Bidirectional{}.propose(graph, x, y, remembering);
    if (Proposal* p = std::get_if<Proposal>(&proposed))
      spoil({graph, x, y, move_of(remembering.choices(), x, y)}, *p);
    return proposed;
  }
};

struct NamedTwin {
  std::string name, graph;  // the graph that shows the fault
  std::function<void(const Transition&, Proposal&)> spoil;
};

// The faults D1 … D8, and C1 and C2 of the catalogue of planted bugs.
std::vector<NamedTwin> bidirectional_twins();

}  // namespace wander::test
