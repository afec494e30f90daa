// The samples of the seed pass of some groups, for others of the same space and seed, whose chains go otherwise:
// they do not depend on the kernel, and are not made twice.
#pragma once

#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "lab/archived_sums.h"

namespace wander {

class CopiedSeeds {
 public:
  CopiedSeeds() = default;
  // Between two samples of the seed pass.
  template <class Groups>
  explicit CopiedSeeds(Groups& groups) {
    std::ostringstream bytes;
    cereal::BinaryOutputArchive archive(bytes);
    groups.serialize_seeds(archive);
    bytes_ = std::move(bytes).str();
  }

  // To groups of which nothing has been made.
  template <class Groups>
  void give(Groups& groups) const {
    std::istringstream bytes(bytes_);
    cereal::BinaryInputArchive archive(bytes);
    groups.serialize_seeds(archive);
  }

 private:
  std::string bytes_;
};

}  // namespace wander
