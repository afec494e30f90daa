// What is printed of a run when it is over.
#include "tools/summary.h"

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

Rendering of_chains(const FunctionalRecord& functional) {
  Rendering rendering{.method = "mlt", .samples = 100, .film = {.shape = {1}, .value = {1}}};
  rendering.film.standard_error = {0.1};
  rendering.film.reliable = {true};
  rendering.chains_record = ChainsRecord{.draws = 4, .functionals = {functional}};
  return rendering;
}

TEST(Summary, HasATableOfChains) {
  const std::string text = summary_of(of_chains({.name = "log_f", .r_hat = 1.25}));
  EXPECT_HAS(text, "R-hat");
  EXPECT_HAS(text, "1.250");
}

TEST(Summary, CountsOneAndMany) {
  Rendering rendering = of_chains({.name = "log_f"});
  rendering.samples = 1;
  rendering.seconds = 2;
  rendering.chains = rendering.groups = rendering.threads = 1;
  const std::string one = summary_of(rendering);
  EXPECT_HAS(one, "mlt: 1 sample in 2 s");
  EXPECT_HAS(one, "; 1 thread, seed 1; 1 chain in 1 group\n");
  rendering.chains = rendering.groups = rendering.threads = 1024;
  EXPECT_HAS(summary_of(rendering), "; 1024 threads, seed 1; 1024 chains in 1024 groups\n");
}

// As of a run that was interrupted before its chains could be compared.
TEST(Summary, HasNoTableOfChainsWithoutRows) {
  EXPECT_LACKS(summary_of(of_chains({.name = "log_f"})), "R-hat");
}

}  // namespace
}  // namespace wander::test
