#include "python/binding/listening.h"

#include <chrono>
#include <future>
#include <utility>

namespace wander::python {

namespace nb = nanobind;

namespace {
constexpr std::chrono::milliseconds between_looks(30);
}

void Listening::tell(const ProgressReport& report) {
  const std::lock_guard lock(mutex_);
  told_ = Told{report, report.phase};
}

Session Listening::session(std::uint64_t seed, int threads) {
  return {.seed = seed,
          .threads = threads,
          .interrupted = &is_stopped(),
          .report = [this](const ProgressReport& report) { tell(report); }};
}

void Listening::listen() {
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    std::optional<Told> told;
    {
      const std::lock_guard lock(mutex_);
      told = std::exchange(told_, std::nullopt);
    }
    if (told && !progress_.is_none())
      progress_(told->report.fraction, told->report.samples, told->report.seconds, told->phase);
  } catch (nb::python_error& error) {
    stop();
    if (error.matches(PyExc_KeyboardInterrupt))
      heard_interrupt_ = true;
    else if (!raised_)
      raised_.emplace(std::move(error));
  }
}

void Listening::carry_out(const std::function<void()>& work) {
  std::future<void> done = std::async(std::launch::async, work);
  const auto is_done = [&] {
    const nb::gil_scoped_release release;
    return done.wait_for(between_looks) == std::future_status::ready;
  };
  while (!is_done()) listen();
  listen();
  done.get();
  if (raised_) throw nb::python_error(std::move(*raised_));
}

}  // namespace wander::python
