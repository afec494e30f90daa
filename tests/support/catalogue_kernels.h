// Every kernel of the catalogue by name: each mutation alone, and all mixed.
#pragma once

#include <string>
#include <vector>

#include "mutations/catalogue.h"

namespace wander::test {

struct NamedKernel {
  std::string name;
  Family kernel;
};

inline std::vector<NamedKernel> catalogue_kernels(int max_vertices) {
  const Family family = make_family({}, max_vertices);
  std::vector<NamedKernel> kernels;
  for (std::size_t i = 0; i < Family::count; ++i)
    kernels.push_back({std::string(Family::names[i]), family.only(i)});
  kernels.push_back({"mixture", family});
  return kernels;
}

}  // namespace wander::test
