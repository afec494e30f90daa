// A scene multiplied by a power of two, or with brighter light, is the same scene: every decision
// of every chain is the same, and so is every bit of the film's mantissas.  There is no absolute
// epsilon in the program.  A scene of segments turned by a quarter behaves the same, too.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/estimate.h"
#include "mlt/run/deposit.h"
#include "mutations/catalogue.h"
#include "scenes/format/build_scene.h"
#include "tests/support/deposits.h"
#include "tests/support/invariance.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

// What a chain did: a hash of its decisions, and what it deposited.
struct Trace {
  std::uint64_t decisions = 0xcbf29ce484222325;
  std::vector<double> film;
  double weight = 0;        // w f/p of its start, in units of b
  Scaled contribution = 0;  // of its last path

  void note(std::uint64_t what) { decisions = (decisions ^ what) * 0x100000001b3; }  // FNV-1a
};

template <World W = Flatland>
Trace trace(const description::Scene& description) {
  const auto scene = build_flatland<W>(description);
  const Transport<W> space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  Trace trace;
  Starts<Transport<W>> starts(space, 1);
  for (std::uint64_t i = 0; !(trace.weight > 0); ++i) trace.weight = starts.draw(i);
  Chain chain(space, family, starts.path());
  GroupFilm film(scene->bins(), scene->max_vertices());
  Rng random(1, Purpose::test, 50);
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    random.start(i);
    chain.step(random, [&](const Step<W>& step) {
      trace.note(static_cast<std::uint64_t>(step.mutation));
      trace.note(static_cast<std::uint64_t>(step.reason));
      trace.note(std::bit_cast<std::uint64_t>(step.acceptance));
      deposit(space, step, space.bin(step.current), film);
    });
  }
  trace.film = film.weights();
  trace.contribution = chain.current().contribution;
  return trace;
}

// The film does not know the size of the scene, and its brightness by a factor alone.
void expect_same(const Trace& a, const Trace& b, double brightness) {
  EXPECT_EQ(a.decisions, b.decisions);
  EXPECT_EQ(a.film, b.film);
  EXPECT_EQ(a.weight * brightness, b.weight);
  EXPECT_EQ(a.contribution.mantissa(), b.contribution.mantissa());
}

FilmEstimate bdpt(const description::Scene& description) {
  Session session;
  session.budget = SampleBudget{5000};
  session.threads = 1;
  const FlatScene scene = build(description);
  for (const Estimator& estimator : estimators())
    if (std::string_view(estimator.name) == "bdpt")
      return estimate(*scene, estimator, session).film;
  throw std::logic_error("no bdpt");
}
void expect_same(const FilmEstimate& a, const FilmEstimate& b, double brightness) {
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    EXPECT_EQ(a.value[i] * brightness, b.value[i]) << "bin " << i;
    EXPECT_EQ(a.standard_error[i] * brightness, b.standard_error[i]) << "bin " << i;
  }
}

constexpr int exponents[] = {-200, -40, -3, 1, 40, 200};

class PowerOfTwo : public ::testing::TestWithParam<int> {
 protected:
  description::Scene scene_ = lit_scenes()[static_cast<std::size_t>(GetParam())].scene;
};
INSTANTIATE_TEST_SUITE_P(Rooms, PowerOfTwo,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(PowerOfTwo, OfSizeChangesNoDecisionOfAChain) {
  const Trace original = trace(scene_);
  for (const int n : exponents) {
    SCOPED_TRACE(n);
    expect_same(original, trace(scaled(scene_, std::ldexp(1.0, n))), 1);
  }
}
TEST_P(PowerOfTwo, OfBrightnessChangesNoDecisionOfAChain) {
  const Trace original = trace(scene_);
  for (const int n : exponents) {
    SCOPED_TRACE(n);
    const double factor = std::ldexp(1.0, n);
    expect_same(original, trace(brightened(scene_, factor)), factor);
  }
}
// Within the range of its exponents a float has no other mantissas, either.
TEST_P(PowerOfTwo, ChangesNoDecisionOfAChainInSinglePrecision) {
  const Trace original = trace<FlatlandSingle>(scene_);
  for (const int n : {-40, -3, 1, 40}) {
    SCOPED_TRACE(n);
    const double factor = std::ldexp(1.0, n);
    expect_same(original, trace<FlatlandSingle>(scaled(scene_, factor)), 1);
    expect_same(original, trace<FlatlandSingle>(brightened(scene_, factor)), factor);
  }
  EXPECT_NE(original.weight, trace(scene_).weight);  // control: it is another precision
}
TEST_P(PowerOfTwo, ChangesNoBitOfABidirectionalFilm) {
  const FilmEstimate original = bdpt(scene_);
  for (const int n : exponents) {
    SCOPED_TRACE(n);
    const double factor = std::ldexp(1.0, n);
    expect_same(original, bdpt(scaled(scene_, factor)), 1);
    expect_same(original, bdpt(brightened(scene_, factor)), factor);
  }
}

// The comparison notices a scene that is not the same.
TEST(NotAPowerOfTwo, ChangesTheRounding) {
  const description::Scene scene = diffuse_room();
  EXPECT_NE(trace(scene).decisions, trace(scaled(scene, 1.1)).decisions);
  EXPECT_NE(trace(scene).decisions, trace(brightened(scene, 1.1)).decisions);
}

// Sums and differences of two products are all that a segment's coordinates meet.
TEST(QuarterTurn, ChangesNoDecisionInASceneOfSegments) {
  description::Scene scene = angular_room();
  const Trace original = trace(scene);
  for (int quarter = 1; quarter < 4; ++quarter) {
    scene = turned(scene);
    expect_same(original, trace(scene), 1);
  }
}

}  // namespace
}  // namespace wander::test
