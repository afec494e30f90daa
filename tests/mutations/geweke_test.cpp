// "Getting it right" [Geweke 2004] for light paths.  In a Kirchhoff furnace of diffuse walls the
// target knows the reflectances,
//   f(x | ρ) = (1 - ρ_emitter) Π ρ_scatterings × what does not depend on ρ,   ∫ f = const,
// so with the prior ρ_i ~ Beta(a, b) the reflectances, given a path, are again Beta,
//   ρ_i | x ~ Beta(a + scatterings on i, b + [the emitter is on i]).
// Started from an exact pair, {path ← steps given ρ; ρ ← Beta given path} must leave the
// distribution of ρ as it is.  Paths that are too long are rejected with their ρ: the pair is then
// exact for paths of limited length, too.
//
// It sees what a test of the kernel alone cannot: a target that does not mean what it says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/catalogue_kernels.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/kirchhoff.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

using W = Flatland;
constexpr int longest = 12, prior_a = 3, prior_b = 2;
// Walls take turns at a few materials, so that a path scatters on one several times.
constexpr std::size_t materials = 2;
using Reflectances = std::array<double, materials>;

// Beta(a, b) for whole numbers: shares of sums of exponential variables.
double beta(int a, int b, Rng& random) {
  double x = 0, y = 0;
  for (int k = 0; k < a; ++k) x -= std::log(1 - random.uniform());
  for (int k = 0; k < b; ++k) y -= std::log(1 - random.uniform());
  return x / (x + y);
}

Furnace furnace_of(const Reflectances& rho) {
  std::vector<Material<W>> walls;
  for (std::size_t w = 0; w < furnace_walls; ++w) walls.push_back(Diffuse<W>{rho[w % materials]});
  return furnace(std::move(walls), longest);
}

std::size_t material_at(const Vertex<W>& v) {
  return static_cast<std::size_t>(v.place.shape) % materials;
}

enum class Conditional { right, scattering_counted_once, emission_not_counted };

Reflectances given_path(const Path<W>& x, Conditional conditional, Rng& random) {
  std::array<int, materials> scattered{};
  for (int i = 1; i + 1 < x.size(); ++i) ++scattered[material_at(x[i])];
  Reflectances rho{};
  for (std::size_t m = 0; m < materials; ++m) {
    const int scatterings = conditional == Conditional::scattering_counted_once
                                ? std::min(scattered[m], 1)
                                : scattered[m];
    const bool emits = m == material_at(x[0]) && conditional != Conditional::emission_not_counted;
    rho[m] = beta(prior_a + scatterings, prior_b + (emits ? 1 : 0), random);
  }
  return rho;
}

// An exact pair.
Reflectances prior(Path<W>& x, Rng& random) {
  for (;;) {
    Reflectances rho{};
    for (double& r : rho) r = beta(prior_a, prior_b, random);
    if (furnace_of(rho).space.sample(x, random)) return rho;
  }
}

// The moments of ρ and the number of vertices, before and after some sweeps.
template <class Kernel>
Decision geweke(const Kernel& kernel, Conditional conditional, std::uint64_t samples,
                double false_alarm) {
  constexpr int sweeps = 8, steps = 4;
  std::array<Moments, 2 * materials + 1> differences, levels;
  Rng random(4, Purpose::test, 66);
  Path<W> x(longest);
  for (std::uint64_t i = 0; i < samples; ++i) {
    random.start(i);
    const Reflectances before = prior(x, random);
    const int vertices = x.size();
    Reflectances rho = before;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      const Furnace room = furnace_of(rho);
      for (int k = 0; k < x.size(); ++k) room.space.evaluate(x, k);
      Chain<Kirchhoff, Kernel> chain(room.space, kernel, x);
      for (int n = 0; n < steps; ++n) chain.step(random, [](const Step<W>&) {});
      x = chain.current();
      rho = given_path(x, conditional, random);
    }
    for (std::size_t m = 0; m < materials; ++m) {
      differences[2 * m].add(rho[m] - before[m]);
      differences[2 * m + 1].add(rho[m] * rho[m] - before[m] * before[m]);
      levels[2 * m].add(before[m]);
      levels[2 * m + 1].add(before[m] * before[m]);
    }
    differences.back().add(x.size() - vertices);
    levels.back().add(vertices);
  }
  std::array<double, 2 * materials + 1> sizes{};
  std::ranges::transform(levels, sizes.begin(), &Moments::mean);
  return bins_z_test(differences, std::array<double, 2 * materials + 1>{}, false_alarm, sizes);
}

TEST(Geweke, EveryMutationKeepsTheJointDistributionOfPathAndReflectances) {
  const auto kernels = catalogue_kernels(longest);
  for (const auto& [name, kernel] : kernels) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(passes(geweke(kernel, Conditional::right, 4000,
                              usual_false_alarm / static_cast<double>(kernels.size()))));
  }
}

TEST(Geweke, AConditionalThatCountsWronglyIsCaught) {
  const Family family = make_family({}, longest);
  EXPECT_TRUE(
      rejects(geweke(family, Conditional::scattering_counted_once, 20'000, usual_false_alarm)));
  EXPECT_TRUE(rejects(geweke(family, Conditional::emission_not_counted, 4000, usual_false_alarm)));
}

TEST(Geweke, AFlawedKernelIsCaught) {
  const FlawedRatio<Bidirectional> twin{{}, RatioFlaw::inverted};
  EXPECT_TRUE(rejects(geweke(alone(twin), Conditional::right, 4000, usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test
