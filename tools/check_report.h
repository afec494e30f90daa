// What `wander check` found, in words and as a JSON document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/method_check.h"
#include "mlt/check/kernel_check.h"

namespace wander {

// How many decisions there were; a mutation is decided three times, a film once.
struct TestCounts {
  std::size_t passed = 0, failed = 0, not_made = 0;
};

// Tests of one mutation or method that had nothing to decide upon.
struct NotTested {
  std::string name;
  std::vector<std::string> tests;  // "after one step"
  std::string reason;
};

struct CheckReport {
  std::string scene_name{}, scene_sha256{};
  std::uint64_t samples = 0, method_samples = 0, seed = 1;
  int steps = 0;
  double false_alarm = 0;  // of the whole command
  std::vector<KernelCheck> mutations{};
  std::vector<MethodCheck> methods{};

  // No test failed, and there was one.
  bool passed() const;
  TestCounts counts() const;
  std::vector<NotTested> not_tested() const;
};

std::string text_of(const CheckReport& report);
nlohmann::ordered_json json_of(const CheckReport& report);

}  // namespace wander
