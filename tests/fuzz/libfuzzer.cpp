// One program of libFuzzer: WANDER_FUZZ_TARGET names its target.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wander::fuzz;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto fault = breach(WANDER_FUZZ_TARGET, bytes)) {
    std::fprintf(stderr, "%s\n", fault->c_str());
    std::abort();
  }
  return 0;
}
