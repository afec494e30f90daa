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

// As of a run that was interrupted before its chains could be compared.
TEST(Summary, HasNoTableOfChainsWithoutRows) {
  EXPECT_LACKS(summary_of(of_chains({.name = "log_f"})), "R-hat");
}

}  // namespace
}  // namespace wander::test
