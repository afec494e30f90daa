// A film that is known exactly is called so, wherever a reference is named.
#include "lab/reference_name.h"
#include "lab/wording.h"
#include "tests/lab/compare/compare_command.h"

namespace wander::test {
namespace {

TEST(ReferenceName, IsWhatIsKnownOfIt) {
  EXPECT_EQ(name_of_reference(std::string("exact: diffuse surfaces, solved")), "exact");
  EXPECT_EQ(name_of_reference(std::string("the mean of 2 runs")), "the mean of 2 runs");
  Rendering rendering;
  rendering.method = "bdpt";
  rendering.samples = 2'000'000;
  rendering.warnings = {"exact: no"};
  EXPECT_EQ(name_of_reference(rendering), "bdpt, 2 M samples");
  rendering.method = "reference";
  EXPECT_EQ(name_of_reference(rendering), "exact");
}

TEST(WorkInWords, TellsStepsFromSamples) {
  Rendering rendering;  // also of a film.nc, which does not say how many chains there were
  rendering.samples = 300'000;
  rendering.method = "bdpt";
  EXPECT_EQ(work_in_words(rendering), "300 k samples");
  rendering.method = "mlt";
  EXPECT_EQ(work_in_words(rendering), "300 k mutations");
  rendering.pooling = PoolingRecord{.samples = 711'000};
  EXPECT_EQ(work_in_words(rendering), "300 k mutations, 711 k samples");
}

TEST_F(CompareCommand, CallsAnExactReferenceExact) {
  const Outcome made = compare(std::string(tiny) + " -o out");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_HAS(made.err, "  reference exact\n");
  EXPECT_HAS(contents(folder / "out/report.html"), ">reference: exact<");
  ASSERT_EQ(shell("\"$WANDER\" render box.json -m pt -b 2k -o run -q").exit_code, 0);
  const std::string with = " --reference out/reference.json";
  ASSERT_EQ(shell("\"$WANDER\" plot run" + with + " -o film.svg").exit_code, 0);
  EXPECT_HAS(contents(folder / "film.svg"), ">reference: exact<");
  EXPECT_HAS(shell("\"$WANDER\" inspect run" + with).out, "against the reference (exact)\n");
  const std::string inspected = shell("\"$WANDER\" inspect out/reference.json").out;
  EXPECT_TRUE(inspected.starts_with("reference: exact: diffuse")) << inspected;
  for (const char* wrong : {"0 samples", "nan", "warning"})
    EXPECT_EQ(inspected.find(wrong), std::string::npos) << inspected;
  ASSERT_EQ(shell("\"$WANDER\" plot out/reference.json -o exact.svg").exit_code, 0);
  EXPECT_EQ(contents(folder / "exact.svg").find("0 samples"), std::string::npos);
  EXPECT_HAS(compared(std::string(tiny) + with)["reference"]["origin"].get<std::string>(),
             "exact: out/reference.json");
}

}  // namespace
}  // namespace wander::test
