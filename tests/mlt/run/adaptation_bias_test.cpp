// A kernel that is chosen by chains that are then thrown away leaves the target invariant; one that goes
// on adapting to its own chain does not.
//
// The target is a number on the circle, the move Kelemen's.  Chains start as draws of the target, so that
// after any number of steps they are draws of it still.  False alarms: 1e-9.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/rng.h"
#include "mlt/run/adaptation.h"
#include "mutations/kelemen.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

constexpr std::uint32_t chains = 20'000;
constexpr int steps = 30;

// Steep on one side.
double target(double u) { return u < 0.1 ? 1 : 0.02; }
constexpr double total = 0.1 * 1 + 0.9 * 0.02;

double draw(Rng& random) {
  const bool is_bright = random.uniform() < 0.1 / total;
  return is_bright ? 0.1 * random.uniform() : 0.1 + 0.9 * random.uniform();
}

class Walk {
 public:
  explicit Walk(Rng& random) : random_(random), u_(draw(random)) {}

  // Accepted?
  bool step(double factor) {
    const double v = Kelemen{}.scaled(factor).move(u_, random_).u;
    if (!(random_.uniform() * target(u_) < target(v))) return false;
    u_ = v;
    return true;
  }
  double place() const { return u_; }

 private:
  Rng& random_;
  double u_;
};

// By the spread of a chain of its own, over ten bins.
double adapted(Rng& random) {
  KernelSearch search;
  while (const auto factor = search.next()) {
    constexpr int windows = 4;
    Walk walk(random);
    WindowSpread spread(10);
    for (int w = 0; w < windows; ++w) {
      std::array<double, 10> shares{};
      for (std::uint64_t i = 0; i < steps_of_window; ++i) {
        walk.step(*factor);
        shares[static_cast<std::size_t>(10 * walk.place())] += 1.0 / steps_of_window;
      }
      spread.add(shares);
    }
    search.tell(spread.value());
  }
  return search.found().kernel;
}

// In the bright part?
template <class Go>
Decision bright_after(Go&& go) {
  Moments bright;
  for (std::uint32_t k = 0; k < chains; ++k) {
    Rng random(3, Purpose::test, k);
    random.start(0);
    bright.add(go(random) < 0.1 ? 1 : 0);
  }
  return t_test(bright, 0.1 / total, usual_false_alarm);
}

TEST(AdaptedKernel, OfChainsThatAreThrownAwayLeavesTheTargetInvariant) {
  EXPECT_TRUE(passes(bright_after([](Rng& random) {
    const double factor = adapted(random);
    Walk walk(random);
    for (int i = 0; i < steps; ++i) walk.step(factor);
    return walk.place();
  })));
}

// The wrong twin, as one would write it: farther after a move, less far after a refusal.
TEST(AdaptedKernel, ThatNeverStopsAdaptingIsCaught) {
  EXPECT_TRUE(rejects(bright_after([](Rng& random) {
    double factor = 1;
    Walk walk(random);
    for (int i = 0; i < steps; ++i)
      factor = std::clamp(walk.step(factor) ? factor * ratio_of_kernels : factor / ratio_of_kernels,
                          smallest_kernel, largest_kernel);
    return walk.place();
  })));
}

}  // namespace
}  // namespace wander::test
