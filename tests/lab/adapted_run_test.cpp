// Runs that adapt their kernel: what is chosen fits the scene, is a matter of the seed alone, and is all
// that the adaptation leaves behind.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lab/drive.h"
#include "lab/run_state.h"
#include "lab/scene_source.h"
#include "lab/world_methods.h"
#include "records/run_json.h"

namespace wander::test {
namespace {

using nlohmann::ordered_json;

// For which a run adapts; it need not be spent.
constexpr std::uint64_t enough = 1 << 19;
constexpr std::uint64_t seeds = 64, steps = 20'000;  // of each slice, and of all chains
constexpr int chains = 1;

Session session_of(std::uint64_t budget, int threads) {
  Session session;
  session.budget = SampleBudget{budget};
  session.threads = threads;
  return session;
}

// A run with all that it needs.
struct Made {
  Made(const description::Scene& scene, const char* method, const Dials& dials,
       std::uint64_t budget = enough, int threads = 2)
      : session(session_of(budget, threads)),
        job(scene, find_method(method), dials),
        run(methods.make()) {}

  Made& after_seeds() {
    run->seed(seeds);
    return *this;
  }
  Rendering at_the_end() {
    run->start(chains);
    run->advance(steps);
    return run->findings();
  }

  Session session;
  Job job;
  Run execution{session};
  WorldMethods<Flatland> methods{job, execution};
  std::unique_ptr<LiveRun> run;
};

Dials with(FilmParts parts, std::optional<double> kernel = {}) {
  return {.chains = {.film_parts = parts}, .kernel = kernel};
}
description::Scene in_gallery(const char* name) {
  return open_scene(std::string(gallery_prefix) + name).scene;
}

// Every number of run.json but times.
ordered_json numbers_of(const Rendering& rendering) {
  ordered_json json = to_json(RunRecord{rendering, {}});
  for (const char* fact : {"threads", "seconds", "cpu_seconds", "seed_seconds"}) json.erase(fact);
  json["chains"].erase("ess_per_second");
  for (auto& [name, mutation] : json["mutations"].items()) mutation.erase("seconds");
  return json;
}
void expect_same(const ordered_json& a, const ordered_json& b) {
  EXPECT_EQ(ordered_json::diff(a, b), ordered_json::array());
}

TEST(AdaptedRun, MovesAsFarAsSuitsTheScene) {
  const auto chosen = [](const char* scene, const char* method) {
    Made made(in_gallery(scene), method, with(FilmParts::chains));
    return made.after_seeds().at_the_end().adaptation->kernel;
  };
  EXPECT_GE(chosen("mirror-dish", "mlt"), 4) << "a wide caustic";
  EXPECT_GE(chosen("mirror-dish", "pssmlt"), 4);
  EXPECT_LE(chosen("corridor", "mlt"), 0.25) << "mirror images of a small lamp";
}

TEST(AdaptedRun, HasTheBitsOfOneWithTheFactorThatItFound) {
  for (const char* method : {"mlt", "pssmlt", "mmlt"})
    for (const FilmParts parts : {FilmParts::chains, FilmParts::pooled}) {
      Made adapted(in_gallery("corridor"), method, with(parts));
      const Rendering found = adapted.after_seeds().at_the_end();
      ASSERT_TRUE(found.adaptation);
      ordered_json numbers = numbers_of(found);
      numbers.erase("adaptation");
      Made given(in_gallery("corridor"), method, with(parts, found.adaptation->kernel));
      expect_same(numbers, numbers_of(given.after_seeds().at_the_end()));
    }
}

// The wrong twin: with another factor the chains have other bits.
TEST(AdaptedRun, HasNotTheBitsOfAnotherFactor) {
  Made adapted(in_gallery("mirror-dish"), "mlt", with(FilmParts::chains)),
      usual(in_gallery("mirror-dish"), "mlt", with(FilmParts::chains, 1));
  EXPECT_NE(adapted.after_seeds().at_the_end().film.value,
            usual.after_seeds().at_the_end().film.value);
}

TEST(AdaptedRun, HasTheSameBitsForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    Made made(in_gallery("corridor"), "mlt", with(FilmParts::pooled), enough, threads);
    return numbers_of(made.after_seeds().at_the_end());
  };
  expect_same(run(1), run(3));
}

TEST(AdaptedRun, IsCarriedOnWithTheSameBits) {
  for (const FilmParts parts : {FilmParts::chains, FilmParts::pooled}) {
    Made first(in_gallery("corridor"), "mlt", with(parts)),
        second(in_gallery("corridor"), "mlt", with(parts)),
        early(in_gallery("corridor"), "mlt", with(parts));
    const std::string unadapted = state_of(*early.run);
    first.after_seeds();
    restore(*second.run, state_of(*first.run));
    restore(*early.run, unadapted);
    const Rendering whole = first.at_the_end();
    ASSERT_NE(whole.adaptation->kernel, 1);
    expect_same(numbers_of(second.at_the_end()), numbers_of(whole));
    expect_same(numbers_of(early.after_seeds().at_the_end()), numbers_of(whole));
    restore(*second.run, state_of(*first.run));
    expect_same(numbers_of(second.run->findings()), numbers_of(whole));
  }
}

TEST(AdaptedRun, OfASmallBudgetKeepsTheUsualFactor) {
  Made small(in_gallery("corridor"), "mlt", with(FilmParts::pooled), enough - 1),
      large(in_gallery("corridor"), "mlt", with(FilmParts::pooled));
  EXPECT_EQ(small.after_seeds().at_the_end().adaptation, Adaptation{});
  EXPECT_GE(large.after_seeds().at_the_end().adaptation->tried.size(), 3u);
}

TEST(AdaptedRun, LeftToSamplesKeepsTheUsualFactor) {
  Made easy(in_gallery("mirror-dish"), "mlt", with(FilmParts::pooled));
  EXPECT_EQ(easy.after_seeds().at_the_end().adaptation, Adaptation{});
}

TEST(AdaptedRun, IsNoneWhereTheFactorIsGiven) {
  Made given(in_gallery("corridor"), "mlt", with(FilmParts::pooled, 1));
  EXPECT_FALSE(given.after_seeds().at_the_end().adaptation);
}

}  // namespace
}  // namespace wander::test
