// Counts what this thread allocates, in a program that is linked with it.
#pragma once

namespace wander::test {

// Counts from its beginning to its end; one at a time.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;

  long count() const;
};

}  // namespace wander::test
