// How much memory a run takes, told before it begins.
#pragma once

#include <string>

#include "lab/job.h"
#include "work/memory.h"

namespace wander {

// In bytes.  Where all of it is needed at once, and where it goes; measured use is between half of
// it and the whole (tests/lab/memory_need_test.cpp).
struct MemoryNeed {
  double program = 0;  // itself, and the scene
  double films = 0;    // what samples and chains deposit, and what is kept per place
  double chains = 0;   // their states and draws
  double end = 0;      // what comes out, while it is made
  double files = 0;    // the same, while it is written; the rest is gone by then

  double most() const;
};

MemoryNeed memory_need(const Job& job, int threads);

// "1.4 GB: films 0.9, ..."
std::string memory_in_words(const MemoryNeed& need);
// Why the run would not fit, and what to do about it; empty if it does.
std::string why_too_large(const Job& job, const MemoryNeed& need, const AvailableMemory& available);

// Beyond this a run says how much it takes.
inline constexpr double much_memory = 0x1p30;

}  // namespace wander
