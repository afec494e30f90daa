// Every kernel that must leave f invariant: each mutation alone, and all of them mixed.  A new
// mutation is one line more in kernel_cases.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/transport.h"
#include "tests/support/invariance.h"

namespace wander::test {

struct KernelCase {
  std::string name;
  std::function<InvarianceReport(const Transport<Flatland>&, const InvarianceOptions&)> test;
};
std::vector<KernelCase> kernel_cases();

}  // namespace wander::test
