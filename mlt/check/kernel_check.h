// The test of invariance for every mutation of a mixture: each alone, with the whole weight on it,
// and all of them mixed.
#pragma once

#include <string>
#include <vector>

#include "mlt/check/invariance.h"

namespace wander {

enum class Verdict { passed, failed, untested };

struct KernelCheck {
  std::string name;  // of the mutation, or `mixture`
  InvarianceReport report;
};

// Untested: none of the decisions had anything to compare.
Verdict verdict_of(const InvarianceReport& report);

// Indices of the mutations that a mixture can select.
template <class Kernel>
std::vector<std::size_t> selectable(const Kernel& mixture) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < Kernel::count; ++i)
    if (mixture.weights()[i] > 0) indices.push_back(i);
  return indices;
}

// Calls done(check) for each mutation, and at last for the mixture if it is one of several.
template <class Space, class Kernel, class Done>
void check_kernels(const Space& space, const Kernel& mixture, const Starts<Space>& starts,
                   const InvarianceOptions& options, const Run& run, Done&& done) {
  const auto check = [&](std::string name, const Kernel& kernel) {
    done(KernelCheck{std::move(name), InvarianceTest(space, kernel, starts, options).run(run)});
  };
  const std::vector<std::size_t> indices = selectable(mixture);
  for (const std::size_t i : indices) check(std::string(Kernel::names[i]), mixture.only(i));
  if (indices.size() > 1) check("mixture", mixture);
}

}  // namespace wander
