// What a bidirectional sample hands on: each path has the weight that it has as a whole, whatever of it was
// known before, and comes again alone, bit for bit.
#include "core/path_sampler.h"

#include <gtest/gtest.h>

#include <vector>

#include "lab/scene_source.h"
#include "scenes/format/build_scene.h"

namespace wander::test::path_sampler_test {
namespace {

struct Found {
  int vertices, technique;
  double weight;
  bool operator==(const Found&) const = default;
};

// Segments, glass, rough glass and mirrors; space, in colour, before a lens.
template <World W>
void for_each_sample(const char* name, Roulette roulette, int count, auto&& look) {
  description::Scene described = open_scene(name).scene;
  described.max_vertices = std::max(described.max_vertices, 12);
  const auto scene = build_scene<W>(described);
  const Transport<W> space(*scene, roulette);
  PathSampler<Transport<W>> sampler(space, all_techniques, Heuristic::power);
  Rng numbers(1, Purpose::test, 0);
  for (int i = 0; i < count; ++i) {
    numbers.start(static_cast<std::uint64_t>(i));
    look(space, sampler, numbers, static_cast<std::uint64_t>(i));
  }
}

template <World W>
void expect_measured_as_a_whole(const char* name, int count) {
  int paths = 0;
  for_each_sample<W>(
      name, Roulette::by_albedo, count, [&](const auto& space, auto& sampler, Rng& numbers, auto) {
        sampler.sample(numbers, [&](const JoinedPath<W>& x, int s, double weight) {
          ++paths;
          const auto sides = sides_of(space, x.whole(), s, {all_techniques, Heuristic::power});
          ASSERT_EQ(weight, weighted_contribution(x.whole(), s, sides))
              << name << ": " << x.size() << ' ' << s;
          for (int k = 0; k < W::channels; ++k)
            ASSERT_NEAR(x.colour()[k], colour(x.whole())[k], 1e-12);
        });
      });
  EXPECT_GT(paths, 100) << name;
}

TEST(PathSampler, WeighsAPathByItsSidesAsAWhole) {
  for (const char* name :
       {"gallery:slit", "gallery:lens", "gallery:frosted", "gallery:mirror-dish"})
    expect_measured_as_a_whole<Flatland>(name, 4000);
  expect_measured_as_a_whole<SpacelandColour>("gallery:cornell-glass", 400);
}

TEST(PathSampler, MakesEachPathAgainAlone) {
  for (const char* name : {"gallery:slit", "gallery:lens", "gallery:frosted"})
    for (const Roulette roulette : {Roulette::off, Roulette::by_albedo})
      for_each_sample<Flatland>(
          name, roulette, 200, [&](const auto&, auto& sampler, Rng& numbers, std::uint64_t i) {
            std::vector<Found> all, again;
            const auto keep_in = [](std::vector<Found>& found) {
              return [&](const JoinedPath<Flatland>& x, int s, double weight) {
                found.push_back({x.size(), s, weight});
              };
            };
            sampler.sample(numbers, keep_in(all));
            for (const Found& one : all) {
              numbers.start(i);
              sampler.sample_only(one.technique, one.vertices - one.technique, numbers,
                                  keep_in(again));
            }
            ASSERT_EQ(all, again) << name << ", sample " << i;
          });
}

// A source that counts takes as many without the connections.
TEST(PathSampler, DrawsTheNumbersOfASampleAlone) {
  struct Counted {
    Rng numbers;
    std::vector<double> taken;
    double uniform() { return taken.emplace_back(numbers.uniform()); }
    int choose(int count) { return static_cast<int>(uniform() * count); }
  };
  for_each_sample<Flatland>(
      "gallery:lens", Roulette::off, 200, [&](const auto&, auto& sampler, Rng& numbers, auto) {
        Counted whole{numbers, {}}, alone{numbers, {}};
        sampler.sample(whole, [](const JoinedPath<Flatland>&, int, double) {});
        sampler.draw(alone);
        ASSERT_EQ(whole.taken, alone.taken);
      });
}

}  // namespace
}  // namespace wander::test::path_sampler_test
