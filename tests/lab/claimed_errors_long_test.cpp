// Error bars against what films vary by, as claimed_errors_test.cpp, of every method that has chains and
// of the chains' own films: within 3 %, with errors of the ratio of about 1 %.
#include <gtest/gtest.h>

#include "tests/support/claimed_errors.h"

namespace wander::test {
namespace {

class ErrorsOfManyFilms : public ::testing::TestWithParam<RunsOfAMethod> {};
INSTANTIATE_TEST_SUITE_P(
    Methods, ErrorsOfManyFilms,
    ::testing::Values(RunsOfAMethod{"article-1", "mlt", 30'000, 250},
                      RunsOfAMethod{"article-1", "mlt", 30'000, 250, FilmParts::chains},
                      RunsOfAMethod{"article-1", "pssmlt", 30'000, 250},
                      RunsOfAMethod{"article-1", "pssmlt", 30'000, 250, FilmParts::chains},
                      RunsOfAMethod{"article-1", "mmlt", 30'000, 250},
                      RunsOfAMethod{"article-1", "mmlt", 30'000, 250, FilmParts::chains}));

TEST_P(ErrorsOfManyFilms, AreThoseThatTheyClaim) { expect_true_claims(GetParam(), 0.03); }

}  // namespace
}  // namespace wander::test
