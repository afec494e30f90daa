// The table of methods is told in full wherever methods are told of, and no name is taken for
// another: help, completions, README and every verb.
#include "lab/method.h"

#include <set>

#include "core/requirements.h"
#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/replay.h"
#include "lab/trace.h"
#include "scenes/format/build_scene.h"
#include "tests/support/coloured_box.h"
#include "tests/support/test_scenes.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<const Method*>& methods) {
  Names names;
  for (const Method* method : methods) names.emplace_back(method->name);
  return names;
}

// The paragraph that begins so.
std::string paragraph(const std::string& text, const std::string& begin) {
  const std::size_t at = text.find(begin);
  return at == std::string::npos ? "" : text.substr(at, text.find("\n\n", at) - at);
}

TEST(Methods, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    EXPECT_EQ(&find_method(method.name), &method);
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
  }
}

TEST(Methods, AnUnknownNameIsAnsweredWithTheNearest) {
  try {
    find_method("bdtp");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(),
              std::string("unknown method \"bdtp\"; did you mean \"bdpt\"? "
                          "allowed are pt, lt, bdpt, mlt, pssmlt, mmlt, pt-naive, lt-naive"));
  }
}

TEST(Methods, DoInTraceAndCheckWhatTheirStateAllows) {
  EXPECT_EQ(names_of(traced_methods()), (Names{"mlt", "mmlt"}));
  EXPECT_EQ(names_of(checked_methods()), (Names{"pt", "lt", "mlt"}));
  EXPECT_EQ(reference_method().name, "bdpt");
  const description::Scene scene = diffuse_room();
  EXPECT_THROW(trace({scene, find_method("pssmlt")}, {}, {}), std::logic_error);
  EXPECT_THROW(replay({scene, find_method("mmlt")}, {}, 0, 0), std::logic_error);
}

TEST(Methods, InWords) {
  EXPECT_EQ(in_words({}), "");
  EXPECT_EQ(in_words(traced_methods()), "mlt and mmlt");
  EXPECT_EQ(in_words(checked_methods(), "or"), "pt, lt or mlt");
}

// A scene that asks for this world.
description::Scene scene_of(const WorldKind& world) {
  if (world.dimension == 2) return diffuse_room();
  return world.channels == 3 ? coloured_box() : channel_of(coloured_box(), 0);
}

TEST(Methods, OfEveryKindAreRenderedInEveryWorldUnderTheirNames) {
  Session session;
  session.budget = SampleBudget{2'000};
  session.threads = 2;
  for (const Method& method : methods())
    for (const Engine& engine : engines()) {
      if (!method.why_impossible(scene_of(engine.world)).empty()) continue;
      const Job job(scene_of(engine.world), method, {.precision = engine.world.precision});
      ASSERT_EQ(job.world(), engine.world);
      const Rendering rendering = render(job, session);
      EXPECT_EQ(rendering.method, method.name);
      EXPECT_EQ(rendering.precision, name_of(engine.world.precision));
      EXPECT_EQ(rendering.film.shape, film_shape(job.scene()));
    }
}

// ---- jobs

TEST(Jobs, AreResolvedOnce) {
  description::Scene scene = diffuse_room();
  const int longest = scene.max_vertices;
  EXPECT_EQ(Job(scene, find_method("pt")).scene().max_vertices, longest);
  const Job job(scene, find_method("pssmlt"), {.max_vertices = longest + 3});
  EXPECT_EQ(job.scene().max_vertices, longest + 3);
  EXPECT_EQ(job.usual(find_method("bdpt")).scene().max_vertices, longest + 3);
  EXPECT_EQ(job.estimator(), StepEstimator::kelemen);
  EXPECT_EQ(job.by(find_method("mmlt")).estimator(), StepEstimator::expected);
}

TEST(Jobs, AreRefusedWhereTheyCannotBeComputed) {
  description::Scene seen = thin_lens_room();
  EXPECT_THROW(Job(seen, find_method("lt-naive")), UsageError);
  EXPECT_NO_THROW(Job(seen, find_method("lt")));
  seen.materials.front().kind = description::Diffuse{{{1e-40, 1e-40, 1e-40}}};
  EXPECT_EQ(why_unfit(seen, find_method("lt-naive"), {.precision = Precision::of_float}).size(),
            2u);
  EXPECT_EQ(
      why_unfit(coloured_box(), find_method("pt"), {.precision = Precision::of_float}).front(),
      "scenes of 3 dimensions in colour cannot be computed in precision float, which is for the "
      "plane; leave --precision out");
}

TEST(FilmShape, IsThatOfTheSceneThatIsBuilt) {
  for (const description::Scene& scene : {diffuse_room(), thin_lens_room(), mirror_and_glass()}) {
    const auto built = build_flatland(scene);
    EXPECT_EQ(film_shape(scene), built->film_shape());
  }
  EXPECT_EQ(film_shape(coloured_box()), (std::vector<int>{4, 6, 3}));
  EXPECT_EQ(build_scene<SpacelandColour>(coloured_box())->film_shape(),
            (std::vector<int>{4, 6, 3}));
  EXPECT_EQ(build_scene<Spaceland>(coloured_box())->film_shape(), (std::vector<int>{4, 6}));
}

// ---- whatever tells of methods

TEST_F(CommandLine, EveryMethodIsInHelpReadmeAndCompletions) {
  const std::string help = wander("render --help").out;
  const std::string list = paragraph(help, "\nMethods:\n");
  const std::string readme =
      paragraph(contents(fs::path(WANDER_SOURCE) / "README.md"), "\nMethods: ");
  const Outcome installed =
      shell("cmake --install '" WANDER_BUILD "' --prefix \"$PWD/usr\" >/dev/null");
  ASSERT_EQ(installed.exit_code, 0) << installed.err;
  for (const Method& method : methods()) {
    EXPECT_HAS(list, "\n  " + std::string(method.name) + " ");
    EXPECT_HAS(list, std::string(method.summary));
    EXPECT_HAS(readme, "`" + std::string(method.name) + "`");
    for (const char* script : {"bash-completion/completions/wander", "zsh/site-functions/_wander",
                               "fish/vendor_completions.d/wander.fish"})
      EXPECT_HAS(" " + contents(folder / "usr/share" / script), " " + std::string(method.name));
  }
}

TEST_F(CommandLine, AMadeUpMethodIsRefusedByEveryVerbThatTakesOne) {
  for (const char* verb : {"render box.json -b 1k -m ", "trace box.json --steps 5 -m ",
                           "compare box.json -b 1k --replicates 2 -m bdpt,"}) {
    for (const char* name : {"mlt2", "MLT", "''"}) {
      const Outcome outcome = wander(std::string(verb) + name + " --json -q");
      EXPECT_EQ(outcome.exit_code, 2) << verb << name;
      EXPECT_HAS(outcome.err, "unknown method ");
    }
  }
}

TEST_F(CommandLine, CompareRefusesAPrecisionThatCannotHoldTheSceneBeforeAnythingIsRun) {
  std::string faint = box;
  faint.replace(faint.find("\"reflectance\": 0.5"), 18, "\"reflectance\": 1e-40");
  write("faint.json", faint);
  const Outcome outcome =
      wander("compare faint.json -m bdpt -b 1k --replicates 2 --dial precision=float -o out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_HAS(outcome.err, "reflectance 1e-40: allowed is 1e-30 to 1; use double");
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace wander::test
