#include "tools/interruption.h"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace wander {

namespace {

std::atomic<bool> interrupted = false;
std::atomic<std::int64_t> first_signal = 0;  // milliseconds
static_assert(std::atomic<bool>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch such flags");

// One interruption may arrive as two signals: programs such as timeout send it to the process and
// to its group.
constexpr std::int64_t same_interruption = 500;  // milliseconds

std::int64_t milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // std::chrono is not promised to be safe in a handler
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

extern "C" void note_interruption(int signal) {
  if (!interrupted.exchange(true)) {
    first_signal.store(milliseconds());
  } else if (milliseconds() - first_signal.load() > same_interruption) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void leave_at_interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (std::signal(SIGHUP, SIG_DFL) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

const std::atomic<bool>& watch_for_interruption() {
  std::signal(SIGINT, note_interruption);
  std::signal(SIGTERM, note_interruption);
  // Of a terminal that is gone; `nohup` has it ignored.
  if (std::signal(SIGHUP, note_interruption) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  return interrupted;
}

}  // namespace wander
