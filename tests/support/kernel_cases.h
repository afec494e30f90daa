// Every kernel that must leave f invariant: each mutation alone, and all of them mixed.  A new
// mutation is one line more in kernel_cases.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/requirements.h"
#include "core/transport.h"
#include "tests/support/invariance.h"
#include "tests/support/perturbation_rooms.h"

namespace wander::test {

struct KernelCase {
  std::string name;
  std::function<InvarianceReport(const Transport<Flatland>&, const InvarianceOptions&)> test;
  // How many functions of a path it changes at least, in any room where it acts.
  std::size_t fewest_comparisons;
  std::function<bool(const Requirements&)> acts;
};
std::vector<KernelCase> kernel_cases();
// The perturbations with ranges that reach across a room.
std::vector<KernelCase> wide_perturbations();

// A kernel in a room where it acts.
struct RoomKernel {
  std::string room;
  description::Scene (*make)();
  KernelCase kernel;

  std::string name() const { return room + kernel.name; }
};
std::vector<RoomKernel> acting_in(const std::vector<NamedRoom>& rooms,
                                  const std::vector<KernelCase>& kernels);

}  // namespace wander::test
