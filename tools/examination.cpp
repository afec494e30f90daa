#include "tools/examination.h"

namespace wander {

void Examination::part(const std::function<void()>& look) {
  try {
    look();
  } catch (...) {
    found_.push_back(std::current_exception());
  }
}

void Examination::require_passed() const {
  if (!is_passed()) throw Failures(found_);
}

}  // namespace wander
