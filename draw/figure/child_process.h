// Work whose libraries may end the program, done in a process of its own, which alone ends.
#pragma once

#include <functional>
#include <string>

namespace wander::figure {

// What `work` returns.  Throws std::runtime_error with the words of what it throws, with
// `given_up` and the signal that ended it; what libraries print meanwhile is lost.
std::string in_a_child(const std::function<std::string()>& work, const std::string& given_up);

}  // namespace wander::figure
