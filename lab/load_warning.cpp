#include "lab/load_warning.h"

#include <fmt/format.h>

#include "lab/wording.h"

namespace wander {

namespace {

constexpr double enough = 0.75;        // of the time of all threads: a run has parts for one
constexpr double least_seconds = 0.1;  // what is missing of less tells nothing

}  // namespace

std::string load_warning(double seconds, double processor_seconds, int threads) {
  const double share = processor_seconds / (seconds * threads);
  if (!(seconds >= least_seconds) || !(share < enough)) return "";
  return fmt::format(
      "the machine was busy: in {} of wall time {} thread{} had only {} of the processor time that "
      "they asked for, so a budget of wall time is no fair measure here; give it in processor "
      "time (-b 30cpu-s) or in samples (-b 5M){}",
      duration_in_words(seconds), threads, threads == 1 ? "" : "s", percent(share),
      threads == 1 ? "" : ", or take fewer threads (-t)");
}

}  // namespace wander
