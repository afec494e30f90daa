// What `wander check` found, in words and as a JSON document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mlt/kernel_check.h"
#include "tools/method_check.h"

namespace wander {

struct CheckReport {
  std::string scene_name{}, scene_sha256{};
  std::uint64_t samples = 0, method_samples = 0, seed = 1;
  int steps = 0;
  double false_alarm = 0;  // of the whole command
  std::vector<KernelCheck> mutations{};
  std::vector<MethodCheck> methods{};

  bool passed() const;
};

std::string text_of(const CheckReport& report);
nlohmann::ordered_json json_of(const CheckReport& report);

}  // namespace wander
