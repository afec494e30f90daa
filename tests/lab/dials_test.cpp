// The table of dials: words, ranges, and that each dial takes effect where it belongs.
#include "lab/dials.h"

#include <nlohmann/json.hpp>

#include "lab/engine.h"
#include "lab/failure.h"
#include "mutations/perturbation.h"
#include "tests/support/expect.h"
#include "tests/support/test_scenes.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

Dials turned(std::string_view word, std::string_view text) {
  Dials dials;
  find_dial(word).set(dials, text);
  return dials;
}

TEST(Dials, AreFoundByTheirWords) {
  for (const Dial& dial : dials()) {
    EXPECT_EQ(&find_dial(dial.word), &dial);
    EXPECT_EQ(dial.option().substr(0, 2), "--");
    EXPECT_LACKS(dial.option(), "_");
  }
  EXPECT_EQ(find_dial("large_step").option(), "--large-step");
  EXPECT_THROW(find_dial("large_stop"), UsageError);
}

TEST(Dials, AreInTheOrderOfTheirIdsAndEachOfSomeMethod) {
  for (std::size_t i = 0; i < dials().size(); ++i) {
    const Dial& dial = dials()[i];
    EXPECT_EQ(dial.id, static_cast<DialId>(i)) << dial.word;
    EXPECT_TRUE(std::ranges::any_of(methods(), [&](const Method& m) { return dial.is_of(m); }));
  }
  EXPECT_EQ(dials().size(), static_cast<std::size_t>(DialId::maps) + 1);
}

TEST(Dials, TakeWhatIsInTheirRange) {
  EXPECT_EQ(turned("precision", "float").precision, Precision::of_float);
  EXPECT_EQ(turned("precision", "double").precision, Precision::of_double);
  EXPECT_EQ(turned("large_step", "0.25").large_step, 0.25);
  EXPECT_EQ(turned("large_step", "1e-9").large_step, 1e-9);
  EXPECT_EQ(turned("target", "even").chains.target, Target::even);
  EXPECT_EQ(turned("target", "light").chains.target, Target::light);
  EXPECT_EQ(turned("kernel", "0.001").kernel, 0.001);
  EXPECT_EQ(turned("kernel", "100").kernel, 100);
  EXPECT_EQ(turned("kernel", "auto").kernel, std::nullopt);
  EXPECT_EQ(turned("by_length", "on").film.by_length, Keep::always);
  EXPECT_EQ(turned("maps", "on").film.maps, Keep::always);
}

TEST(Dials, RefuseWhatIsNot) {
  for (const char* text : {"half", "single", "Float", "64", ""})
    EXPECT_THROW(turned("precision", text), UsageError) << text;
  for (const char* text : {"Even", "dark", "on", ""})
    EXPECT_THROW(turned("target", text), UsageError) << text;
  for (const char* text : {"0", "1", "-0.1", "1.5", "nan", "inf", "0.3x", ""})
    EXPECT_THROW(turned("large_step", text), UsageError) << text;
  for (const char* text : {"0", "0.0009", "100.1", "-1", "nan", "inf", "two", ""})
    EXPECT_THROW(turned("kernel", text), UsageError) << text;
  for (const char* text : {"off", "1", ""}) EXPECT_THROW(turned("maps", text), UsageError) << text;
}

TEST(Dials, AreRefusedByMethodsThatDoNotHaveThem) {
  for (const char* word : {"large_step", "kernel"}) {
    for (const char* method : {"mlt", "pssmlt", "mmlt"})
      EXPECT_NO_THROW(require_dial(find_dial(word), find_method(method)));
    for (const char* method : {"pt", "lt", "bdpt", "pt-naive", "lt-naive"})
      EXPECT_THROW(require_dial(find_dial(word), find_method(method)), UsageError);
  }
  for (const Method& method : methods())
    EXPECT_NO_THROW(require_dial(find_dial("precision"), method));
}

// ---- ranges of moves

TEST(Kernels, ScaleTheirRangesAndEndWhereTheirDomainEnds) {
  const Kelemen usual, near = usual.scaled(0.01), far = usual.scaled(100);
  EXPECT_DOUBLE_EQ(near.smallest, usual.smallest / 100);
  EXPECT_DOUBLE_EQ(near.largest, usual.largest / 100);
  EXPECT_DOUBLE_EQ(far.smallest, usual.smallest * 100);
  EXPECT_EQ(far.largest, 0.5);
  EXPECT_LT(far.smallest, far.largest);
  const PerturbationRange range, wide = range.scaled(100);
  EXPECT_EQ(wide.position.largest, 1);
  EXPECT_EQ(wide.angle.largest, std::numbers::pi);
  EXPECT_LT(wide.position.smallest, wide.position.largest);
  EXPECT_LT(wide.angle.smallest, wide.angle.largest);
  EXPECT_EQ(range.scaled(1).angle.largest, range.angle.largest);
}

// ---- effects

Rendering render_with(std::string_view method, const Dials& dials) {
  Session session;
  session.budget = SampleBudget{15'000};
  session.threads = 2;
  return render({mirror_and_glass(), find_method(method), dials}, session);
}
const MutationRecord& record(const Rendering& rendering, std::string_view name) {
  return *std::ranges::find(rendering.mutations, name, &MutationRecord::name);
}

// The chains of a kernel with another share reject the share of this one.
TEST(LargeStep, IsTheShareOfLargeStepsOfEveryChain) {
  for (const char* method : {"mlt", "pssmlt", "mmlt"}) {
    for (const double share : {0.05, 0.8}) {
      const Rendering r = render_with(method, {.mutations = {{"primary", 1}}, .large_step = share});
      const std::uint64_t large = record(r, "primary_large").proposed;
      const std::uint64_t all = large + record(r, "primary_small").proposed;
      EXPECT_TRUE(passes(binomial_test(large, all, share, usual_false_alarm))) << method;
      EXPECT_TRUE(rejects(binomial_test(large, all, default_large_step, usual_false_alarm)));
    }
  }
}

TEST(Kernel, OfShortMovesIsAcceptedMoreOftenThanOfLongOnes) {
  for (const char* method : {"mlt", "pssmlt", "mmlt"}) {
    const Rendering near = render_with(method, {.kernel = 0.01}),
                    far = render_with(method, {.kernel = 20});
    for (const char* move : {"primary_small", "lens", "caustic", "multichain"}) {
      if (move != std::string_view("primary_small") && method != std::string_view("mlt")) continue;
      EXPECT_GT(record(near, move).mean_acceptance, record(far, move).mean_acceptance + 0.1)
          << method << ", " << move;
    }
  }
}

// ---- the command line

TEST_F(CommandLine, DialsAreOptionsOfRenderTraceAndCheck) {
  const std::string dials = " --precision float --large-step 0.5 --kernel 2 --max-vertices 3";
  const Outcome render = wander("render box.json -m mlt -b 20k --json -q" + dials);
  EXPECT_EQ(render.exit_code, 0) << render.err;
  EXPECT_EQ(json::parse(render.out)["precision"], "float");
  for (const char* method : {"mlt", "mmlt"}) {
    const std::string trace = std::string("trace box.json -q --steps 50 --json -m ") + method;
    const Outcome plain = wander(trace), with = wander(trace + dials);
    EXPECT_EQ(with.exit_code, 0) << with.err;
    EXPECT_NE(plain.out, with.out);
  }
  const Outcome check = wander("check box.json --samples 5k --mutations primary=1" + dials);
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_HAS(check.out, "primary_large");
}

TEST_F(CommandLine, DialsThatDoNotFitAreExitTwoAndSayWhy) {
  EXPECT_HAS(wander("render box.json -m bdpt --json --kernel 2").err, "bdpt does not have it");
  EXPECT_HAS(wander("render box.json -m mlt --json --large-step 1").err, "above 0 and below 1");
  EXPECT_HAS(wander("trace box.json -m mmlt --json --mutations lens=1").err,
             "--mutations is for mlt; mmlt does not have it");
  EXPECT_HAS(wander("render box.json -m mmlt --json --chains 64").err,
             "--chains is for mlt and pssmlt; mmlt does not have it");
  EXPECT_HAS(wander("render box.json -m pt --json --precision flaot").err,
             "did you mean \"float\"?");
  json scene = json::parse(box);
  scene["materials"]["wall"]["reflectance"] = 1e-40;
  write("faint.json", scene.dump(1));
  for (const char* verb : {"render -m pt", "trace", "check"}) {
    const std::string word(verb);
    const Outcome outcome = wander(word + " faint.json --json --precision float");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_HAS(outcome.err, "reflectance 1e-40: allowed is 1e-30 to 1; use double");
  }
  EXPECT_EQ(wander("render faint.json -m pt -b 1k --json -q").exit_code, 0);
}

}  // namespace
}  // namespace wander::test
