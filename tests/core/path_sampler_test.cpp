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

template <World W>
void for_each_sample(const char* name, Roulette roulette, const TechniqueSet& set, int count,
                     auto&& look) {
  description::Scene described = open_scene(name).scene;
  described.max_vertices = std::max(described.max_vertices, 12);
  const auto scene = build_scene<W>(described);
  const Transport<W> space(*scene, roulette);
  PathSampler<Transport<W>> sampler(space, set, Heuristic::power);
  Rng numbers(1, Purpose::test, 0);
  for (int i = 0; i < count; ++i) {
    numbers.start(static_cast<std::uint64_t>(i));
    look(space, sampler, numbers, static_cast<std::uint64_t>(i));
  }
}

template <World W>
void expect_measured_as_a_whole(const char* name, const TechniqueSet& set, int count) {
  int paths = 0;
  for_each_sample<W>(name, Roulette::by_albedo, set, count,
                     [&](const auto& space, auto& sampler, Rng& numbers, auto) {
                       sampler.sample(numbers, [&](const JoinedPath<W>& x, int s, double weight) {
                         ++paths;
                         std::vector<Vertex<W>> vertices;
                         for (int i = 0; i < x.size(); ++i) vertices.push_back(x[i]);
                         const Path<W>& whole = x.whole();
                         for (int i = 0; i < x.size(); ++i) {
                           const Vertex<W>& vertex = vertices[static_cast<std::size_t>(i)];
                           ASSERT_EQ(vertex.place.position, whole[i].place.position)
                               << name << ": " << i;
                           ASSERT_EQ(vertex.event, whole[i].event) << name << ": " << i;
                         }
                         const auto sides = sides_of(space, whole, s, {set, Heuristic::power});
                         ASSERT_EQ(weight, weighted_contribution(whole, s, sides))
                             << name << ": " << whole.size() << ' ' << s;
                         for (int k = 0; k < W::channels; ++k)
                           ASSERT_NEAR(x.colour()[k], colour(whole)[k], 1e-12);
                       });
                     });
  EXPECT_GT(paths, 100) << name;
}

TEST(PathSampler, WeighsAPathByItsSidesAsAWhole) {
  for (const char* name :
       {"gallery:slit", "gallery:lens", "gallery:frosted", "gallery:mirror-dish"})
    expect_measured_as_a_whole<Flatland>(name, all_techniques, 4000);
  expect_measured_as_a_whole<SpacelandColour>("gallery:cornell-glass", all_techniques, 400);
}

// How many techniques there are behind an edge depends on the length of the path where they are limited.
TEST(PathSampler, WeighsAPathAmongFewTechniques) {
  for (const TechniqueSet& set : {TechniqueSet{.most_light = 1}, TechniqueSet{.most_sensor = 1},
                                  TechniqueSet{.most_light = 3, .most_sensor = 3}})
    for (const char* name : {"gallery:frosted", "gallery:furnace"})
      expect_measured_as_a_whole<Flatland>(name, set, 4000);
}

TEST(PathSampler, MakesEachPathAgainAlone) {
  std::size_t paths = 0;
  for (const char* name : {"gallery:slit", "gallery:lens", "gallery:frosted"})
    for (const Roulette roulette : {Roulette::off, Roulette::by_albedo})
      for_each_sample<Flatland>(name, roulette, all_techniques, 200,
                                [&](const auto&, auto& sampler, Rng& numbers, std::uint64_t i) {
                                  std::vector<Found> all, again;
                                  const auto keep_in = [](std::vector<Found>& found) {
                                    return
                                        [&](const JoinedPath<Flatland>& x, int s, double weight) {
                                          found.push_back({x.size(), s, weight});
                                        };
                                  };
                                  sampler.sample(numbers, keep_in(all));
                                  for (const Found& one : all) {
                                    numbers.start(i);
                                    sampler.sample_only(one.technique, one.vertices - one.technique,
                                                        numbers, keep_in(again));
                                  }
                                  ASSERT_EQ(all, again) << name << ", sample " << i;
                                  paths += all.size();
                                });
  EXPECT_GT(paths, 1000u);
}

// A source that counts takes as many without the connections.
TEST(PathSampler, DrawsTheNumbersOfASampleAlone) {
  struct Counted {
    Rng numbers;
    std::vector<double> taken;
    double uniform() { return taken.emplace_back(numbers.uniform()); }
    int choose(int count) { return static_cast<int>(uniform() * count); }
  };
  for (const char* name : {"gallery:lens", "gallery:slit"})
    for_each_sample<Flatland>(name, Roulette::off, all_techniques, 200,
                              [&](const auto&, auto& sampler, Rng& numbers, auto) {
                                Counted whole{numbers, {}}, alone{numbers, {}};
                                sampler.sample(whole,
                                               [](const JoinedPath<Flatland>&, int, double) {});
                                sampler.draw(alone);
                                ASSERT_GT(whole.taken.size(), 2u);
                                ASSERT_EQ(whole.taken, alone.taken);
                              });
}

}  // namespace
}  // namespace wander::test::path_sampler_test
