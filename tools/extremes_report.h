// What `wander check --extremes` found, in words and as a JSON document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/symmetries.h"

namespace wander {

struct ExtremesReport {
  std::string scene_name{}, scene_sha256{};
  std::uint64_t samples = 0, seed = 1;
  std::vector<SymmetryCheck> checks{};

  // No film differs, and there was one.
  bool passed() const;
  std::size_t with(SymmetryVerdict verdict) const;
};

std::string text_of(const ExtremesReport& report);
nlohmann::ordered_json json_of(const ExtremesReport& report);

}  // namespace wander
