// The method of docs/extending.md, in both worlds: its film is that of bidirectional path tracing
// within the errors that both state, and that of a coin which counts its sides twice is not.
//
// False alarms: 1e-9 per decision.
#include "docs/examples/toss.h"

#include <gtest/gtest.h>

#include "lab/drive.h"
#include "lab/engine.h"
#include "lab/method_check.h"
#include "scenes/format/build_scene.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

constexpr double false_alarm = 1e-9;

Session session_of(std::uint64_t seed) {
  Session session;
  session.budget = SampleBudget{200'000};
  session.seed = seed;
  session.threads = 2;
  return session;
}

template <World W>
Rendering tossed(const description::Scene& description) {
  const auto scene = build_flatland<W>(description);
  const Transport<W> space(*scene, Roulette::off);
  const Session session = session_of(7);
  Run execution(session);
  const Job job(description, find_method("pt"));
  const auto run = Toss::make<W>({job, execution, *scene, space});
  return drive(*run, execution);
}

FilmEstimate reference_of(const description::Scene& description) {
  return render(Job(description, reference_method()), session_of(8)).film;
}

TEST(OwnMethod, AgreesWithTheOthers) {
  for (const auto room : {diffuse_room, mirror_and_glass, curved_ends}) {
    const FilmEstimate reference = reference_of(room());
    for (const Rendering& rendering : {tossed<Flatland>(room()), tossed<FlatlandSingle>(room())}) {
      EXPECT_EQ(rendering.method, Toss::name);
      EXPECT_EQ(rendering.samples, 200'000u);
      const MethodCheck check = compare_films("toss", rendering.film, reference, false_alarm);
      EXPECT_EQ(check.verdict, Verdict::passed) << check.decision.detail;
    }
  }
}

// As if each side of the coin were there for all of the light.
TEST(OwnMethod, IsCaughtWhenItCountsBothSides) {
  Rendering rendering = tossed<Flatland>(diffuse_room());
  for (double& value : rendering.film.value) value *= 2;
  for (double& error : rendering.film.standard_error) error *= 2;
  EXPECT_EQ(
      compare_films("toss", rendering.film, reference_of(diffuse_room()), false_alarm).verdict,
      Verdict::failed);
}

}  // namespace
}  // namespace wander::test
