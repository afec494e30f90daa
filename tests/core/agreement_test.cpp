// Every way to sample a path gives the same film: each technique (s,t) alone against a
// deterministic solution, the estimators against each other in a room of all materials, with
// Russian roulette and without.  False-alarm rate 1e-9 per decision.
#include <gtest/gtest.h>

#include "core/exact/radiosity.h"
#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"

namespace wander::test::agreement_test {

using namespace exact;
namespace {

Estimator family(int s, int t) {
  return {"", TechniqueSet{s, s, t, t}, Roulette::off, Heuristic::balance};
}

// Paths of n vertices, as sampled with s of them from the light, against ∫ solved on a mesh.
TEST(SingleTechniques, AgreeWithTheRadiosityOfEachLength) {
  const SceneMaker room = open_room(5);
  const auto scene = room.build();
  const RadiositySolution exact = solve_radiosity(radiosity_scene(room.description()));
  std::uint64_t seed = 0;
  for (int n = 2; n <= 5; ++n)
    for (int s = 0; s <= n; ++s) {
      const auto film = sample_film(*scene, family(s, n - s), 150'000, ++seed);
      const auto& of_length = exact.film().by_vertices[static_cast<std::size_t>(n) - 2];
      EXPECT_TRUE(passes(matches(film.total, of_length))) << "s = " << s << ", t = " << n - s;
      std::vector<double> wrong = of_length;  // control: a fifth too much
      for (double& value : wrong) value *= 1.2;
      EXPECT_TRUE(rejects(matches(film.total, wrong))) << "s = " << s << ", t = " << n - s;
    }
}

TEST(Estimators, AgreeWithTheRadiosityOfEachLength) {
  const SceneMaker room = open_room(6);
  const auto scene = room.build();
  const RadiositySolution exact = solve_radiosity(radiosity_scene(room.description()));
  for (const Estimator& estimator : estimators()) {
    const auto film = sample_film(*scene, estimator, 150'000, 1);
    std::vector<Compared> all;
    for (const auto& [n, bins] : film.by_vertices)
      for (std::size_t i = 0; i < bins.size(); ++i)
        all.push_back(
            compared(bins[i], exact.film().by_vertices[static_cast<std::size_t>(n) - 2][i]));
    for (std::size_t i = 0; i < film.total.size(); ++i)
      all.push_back(compared(film.total[i], exact.film().mean_irradiance[i]));
    EXPECT_TRUE(passes(largest_z_test(all, usual_false_alarm))) << estimator.name;
  }
}

TEST(Estimators, AgreeAmongAllMaterialsForEachLength) {
  const auto scene = full_room(8).build();
  std::vector<SampledFilm> films;
  for (const Estimator& estimator : estimators())
    films.push_back(sample_film(*scene, estimator, 100'000, films.size() + 1));
  for (std::size_t a = 0; a < films.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(passes(agree(films[a], films[b])))
          << estimators()[a].name << " and " << estimators()[b].name;
}

// Control: a room in which the glass is a little denser.
TEST(Estimators, TellRoomsApart) {
  const auto scene = full_room(8).build();
  description::Scene other = full_room(8).description();
  for (auto& material : other.materials)
    if (auto* glass = std::get_if<description::Dielectric>(&material.kind))
      glass->interior_index = 1.6;
  const auto& bdpt = find_estimator("bdpt");
  EXPECT_TRUE(rejects(agree(sample_film(*scene, bdpt, 150'000, 1),
                            sample_film(*build_flatland(other), bdpt, 150'000, 2))));
}

// Walks that end by roulette, with densities that do not know of it.
class Forgetful : public Transport<Flatland> {
 public:
  explicit Forgetful(const Scene<Flatland>& scene)
      : Transport(scene, Roulette::off), playing_(scene, Roulette::by_albedo) {}
  double survival(const Vertex<Flatland>& v) const { return playing_.survival(v); }

 private:
  Transport<Flatland> playing_;
};

TEST(RussianRoulette, ChangesNoExpectation) {
  const auto scene = full_room(12).build();
  for (const auto name : {"pt", "lt", "bdpt"}) {
    Estimator with = find_estimator(name), without = with;
    with.roulette = Roulette::by_albedo;
    without.roulette = Roulette::off;
    const auto reference = sample_film(*scene, without, 40'000, 1);
    EXPECT_TRUE(passes(agree(sample_film(*scene, with, 40'000, 2), reference))) << name;
    EXPECT_TRUE(rejects(agree(
        sample_film_in(Forgetful(*scene), with.techniques, with.heuristic, 40'000, 2), reference)))
        << name;
  }
}

TEST(Heuristics, ChangeNoExpectation) {
  const auto scene = full_room(6).build();
  Estimator balance = find_estimator("bdpt"), power = balance;
  balance.heuristic = Heuristic::balance;
  power.heuristic = Heuristic::power;
  EXPECT_TRUE(passes(
      agree(sample_film(*scene, balance, 40'000, 1), sample_film(*scene, power, 40'000, 2))));
}

}  // namespace
}  // namespace wander::test::agreement_test
