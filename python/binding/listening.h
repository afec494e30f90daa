// Long work that Python has asked for: it runs on a thread of its own, without the interpreter's
// lock, while the thread that asked listens for Ctrl-C and tells how far the work is.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "work/session.h"

namespace wander::python {

class Listening {
 public:
  // Called with (fraction, samples, seconds, phase) a few times a second; or None.
  explicit Listening(nanobind::object progress) : progress_(std::move(progress)) {}

  // Asks the work to end early.
  void stop() { stopped_ = true; }
  const std::atomic<bool>& is_stopped() const { return stopped_; }
  void tell(const ProgressReport& report);

  // One that is heard here.
  Session session(std::uint64_t seed, int threads);

  // Throws what the work throws, and what Python does while it listens, but for Ctrl-C: that asks
  // the work to end, and is remembered.
  void carry_out(const std::function<void()>& work);
  bool heard_interrupt() const { return heard_interrupt_; }

 private:
  struct Told {
    ProgressReport report;
    std::string phase;
  };
  void listen();

  nanobind::object progress_;
  std::atomic<bool> stopped_ = false;
  bool heard_interrupt_ = false;
  std::optional<nanobind::python_error> raised_;
  std::mutex mutex_;
  std::optional<Told> told_;
};

}  // namespace wander::python
