// What time it is: on the wall, and of the processors.  A run asks its session's clock and no
// other, so that a test can hold the hands.
#pragma once

namespace wander {

// Wall time passes for everybody; processor time is what all threads of this program had together,
// so other work on the machine takes nothing of it.
enum class TimeKind { wall, processor };

// In seconds, since some beginning.
struct Moment {
  double wall = 0, processor = 0;

  double of(TimeKind kind) const { return kind == TimeKind::wall ? wall : processor; }
};

class Clock {
 public:
  virtual ~Clock() = default;
  virtual Moment now() const = 0;
};

// That of the machine.
const Clock& system_clock();

}  // namespace wander
