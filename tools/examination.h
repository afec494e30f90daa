// What is wrong with a command, all of it: each part is looked at whatever became of the others,
// before anything is computed, so that one attempt tells every fault.
#pragma once

#include <exception>
#include <functional>
#include <vector>

namespace wander {

// Thrown when an examination found something; main() tells one after the other.
struct Failures : std::exception {
  explicit Failures(std::vector<std::exception_ptr> found) : found(std::move(found)) {}
  const char* what() const noexcept override { return "the command cannot be carried out"; }

  std::vector<std::exception_ptr> found;
};

class Examination {
 public:
  // Looks at one part; what it throws is kept.
  void part(const std::function<void()>& look);
  bool is_passed() const { return found_.empty(); }
  // Throws Failures if anything was found.
  void require_passed() const;

 private:
  std::vector<std::exception_ptr> found_;
};

}  // namespace wander
