// The switches of bugs: included before all code of a copy of the tree that `sites.py` or `../switched.py` rewrote.
// The environment says which one bug is on, WANDER_BUG=7, and where each process notes which switches it came by,
// WANDER_BUGS_PASSED=FOLDER.  Where a constant is computed by the compiler there is no bug, and nobody comes by.
#pragma once

#include <unistd.h>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>

namespace wander_bugs {

constexpr int most = 65536;

inline int chosen() {
  const char* text = std::getenv("WANDER_BUG");
  return text == nullptr ? -1 : std::atoi(text);
}

class Passed {
 public:
  ~Passed() {
    const char* folder = std::getenv("WANDER_BUGS_PASSED");
    if (folder == nullptr) return;
    std::FILE* file =
        std::fopen((std::string(folder) + "/" + std::to_string(getpid())).c_str(), "a");
    if (file == nullptr) return;
    for (int id = 0; id < most; ++id)
      if (seen[id] != 0) std::fprintf(file, "%d\n", id);
    std::fclose(file);
  }
  unsigned char seen[most] = {};
};

inline const int active = chosen();
inline Passed passed;

constexpr bool on(int id) {
  if (std::is_constant_evaluated()) return false;
  if (passed.seen[id] == 0) passed.seen[id] = 1;  // reads are shared among threads
  return active == id;
}

// An operator and what the bug puts in its place, where that has the same type; else there is no bug.
#define WANDER_BUGS_OPERATOR(NAME, RIGHT, WRONG)                        \
  template <class A, class B>                                           \
  constexpr auto NAME(int id, const A& a, const B& b) {                 \
    if constexpr (requires {                                            \
                    { a WRONG b } -> std::same_as<decltype(a RIGHT b)>; \
                  })                                                    \
      if (on(id)) return a WRONG b;                                     \
    return a RIGHT b;                                                   \
  }
WANDER_BUGS_OPERATOR(add, +, -)
WANDER_BUGS_OPERATOR(subtract, -, +)
WANDER_BUGS_OPERATOR(multiply, *, /)
WANDER_BUGS_OPERATOR(divide, /, *)
WANDER_BUGS_OPERATOR(remainder, %, *)
#undef WANDER_BUGS_OPERATOR

#define WANDER_BUGS_ASSIGNMENT(NAME, RIGHT, WRONG)           \
  template <class A, class B>                                \
  constexpr decltype(auto) NAME(int id, A&& a, const B& b) { \
    if constexpr (requires { a WRONG b; })                   \
      if (on(id)) return a WRONG b;                          \
    return a RIGHT b;                                        \
  }
WANDER_BUGS_ASSIGNMENT(add_to, +=, -=)
WANDER_BUGS_ASSIGNMENT(subtract_from, -=, +=)
WANDER_BUGS_ASSIGNMENT(multiply_by, *=, /=)
WANDER_BUGS_ASSIGNMENT(divide_by, /=, *=)
#undef WANDER_BUGS_ASSIGNMENT

// At the boundary the other answer; of floating numbers that changes nothing that happens.
#define WANDER_BUGS_ORDER(NAME, RIGHT, WRONG)                                     \
  template <class A, class B>                                                     \
  constexpr bool NAME(int boundary, int negated, const A& a, const B& b) {        \
    if constexpr (!std::is_floating_point_v<A> && !std::is_floating_point_v<B> && \
                  requires { a WRONG b; })                                        \
      if (boundary >= 0 && on(boundary)) return a WRONG b;                        \
    if (negated >= 0 && on(negated)) return !(a RIGHT b);                         \
    return a RIGHT b;                                                             \
  }
WANDER_BUGS_ORDER(less, <, <=)
WANDER_BUGS_ORDER(less_equal, <=, <)
WANDER_BUGS_ORDER(greater, >, >=)
WANDER_BUGS_ORDER(greater_equal, >=, >)
#undef WANDER_BUGS_ORDER

template <class A>
constexpr A number(int id, A value) {
  if (!on(id)) return value;
  if constexpr (std::is_floating_point_v<A>)
    return value == A{0} ? A{1} : value * A{1.125};
  else
    return static_cast<A>(value + 1);
}

template <class A>
constexpr auto negative(int id, const A& a) {
  if constexpr (std::same_as<decltype(-a), std::remove_cvref_t<A>>)
    if (on(id)) return -(-a);
  return -a;
}

}  // namespace wander_bugs
