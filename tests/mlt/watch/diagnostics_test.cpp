// The diagnostics of chains against ArviZ 0.23.4, on draws of a generator that every language has;
// and against what is known of autoregressive chains.
#include "mlt/watch/diagnostics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace wander::test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// x ← φ x + (u - 1/2), from x = 0, with a linear congruential u of its own in each chain.
Draws autoregressive(double phi, std::size_t chains, std::size_t length) {
  Draws draws{chains, length, {}};
  for (std::size_t c = 0; c < chains; ++c) {
    std::uint64_t state = 1442695040888963407u + c * 7919u;
    double x = 0;
    for (std::size_t i = 0; i < length; ++i) {
      state = 6364136223846793005u * state + 1442695040888963407u;
      x = phi * x + (static_cast<double>(state >> 11) * 0x1p-53 - 0.5);
      draws.values.push_back(x);
    }
  }
  return draws;
}

Draws mapped(Draws draws, const std::function<double(std::size_t chain, double)>& f) {
  for (std::size_t i = 0; i < draws.values.size(); ++i)
    draws.values[i] = f(i / draws.length, draws.values[i]);
  return draws;
}

Draws sine_with_ramps() {
  Draws draws{4, 100, {}};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 100; ++i) draws.values.push_back(std::sin(0.7 * i + c) + 0.01 * i * c);
  return draws;
}

Draws with_stuck_chain() {
  Draws draws = autoregressive(0.5, 4, 1000);
  std::fill(draws.values.begin() + 3000, draws.values.end(), draws.values[3000]);
  return draws;
}

// What arviz.rhat, ess and mcse say.
struct Vector {
  const char* name;
  Draws draws;
  double rank_r_hat, split_r_hat;
  double bulk, tail, mean, sd, median, q10;
  double mcse_mean, mcse_sd, mcse_median;
};

std::vector<Vector> vectors() {
  const auto floor = [](std::size_t, double x) { return std::floor(4 * x); };
  const auto binary = [](std::size_t, double x) { return x > 0.4 ? 1.0 : 0.0; };
  const auto heavy = [](std::size_t c, double x) { return c == 3 ? 10 * x : x; };
  const auto shifted = [](std::size_t c, double x) { return c == 3 ? x + 1 : x; };
  return {
      {"phi 0.9", autoregressive(0.9, 4, 1000), 1.01497635148327, 1.01517880895038,
       250.297750920714, 546.990633220989, 249.417672085141, 518.72067743039, 316.445014381256,
       517.47306250262, 0.0409785167500812, 0.0188907968382499, 0.0427554685163716},
      {"phi 0", autoregressive(0, 4, 1000), 0.999715459843853, 0.99991261976199, 3971.89653560612,
       3472.47785163849, 4020.51720326097, 3873.63256407353, 4070.55875805193, 4151.65066226645,
       0.00452308580434169, 0.00208048499729645, 0.00742215171710031},
      {"phi -0.5", autoregressive(-0.5, 4, 1000), 1.00027301430185, 0.999311299311161,
       13899.293721074, 3999.29937702179, 12700.0425312001, 2527.73120608002, 6489.09647769887,
       4623.85378141247, 0.00292712677867758, 0.00369888594918111, 0.00506493175596067},
      {"sine with ramps", sine_with_ramps(), 1.39623208062512, 1.43764949710926, 22.0444959326831,
       32.1952512704476, 17.6523876331727, 107.681143673198, 143.184166840858, 206.02573242977,
       0.25212179780889, 0.0676842541098686, 0.0834733056750073},
      {"one chain is stuck", with_stuck_chain(), 1.12409181955523, 1.06893349457733,
       156.370729863387, 1710.23333111502, 56.1397609575866, 57.0682140597215, 11.890674083557,
       372.779282834445, 0.0402505949943508, 0.0256647626279346, 0.123756993036327},
      {"an odd number of draws", autoregressive(0.5, 3, 101), 1.05340944199377, 1.05570788452874,
       47.7153414531579, 160.460650169041, 44.4265685799631, 191.77840424211, 74.1351621164115,
       176.356360643825, 0.0514449829248408, 0.0139277071366303, 0.0597442259664467},
      {"ties", mapped(autoregressive(0.7, 4, 250), floor), 1.0280298963485, 1.02907348899475,
       178.815771663608, 346.541346358993, 175.168222162999, 331.878587900032, 230.977743681469,
       346.541346358993, 0.128188993076568, 0.0570067741020276, 0.5},
      {"two values", mapped(autoregressive(0.9, 5, 300), binary), 1.06036200200375,
       1.06036200200375, 131.298829437428, 131.298829437428, 131.298829437428, 131.298829437427,
       131.298829437428, 131.298829437428, 0.039338864865446, 0.0189087001429989, 0},
      {"one wide chain", mapped(autoregressive(0, 4, 1000), heavy), 1.38677126954961,
       1.00092506252965, 3912.05949272226, 29.220997489526, 3940.47578081674, 8.27174060026641,
       4078.6011731072, 12.162937804061, 0.023306569930336, 0.608867220287661, 0.0111818139166223},
      {"one shifted chain", mapped(autoregressive(0, 4, 500), shifted), 1.52734696998704,
       1.88362201851504, 7.27040466135414, 29.5423842684535, 5.73251304137164, 10.1537230358569,
       11.7915570772016, 271.96055723366, 0.213620635551242, 0.100848723719299, 0.180416594412177},
      {"one chain", autoregressive(0.5, 1, 200), none, none, 43.6391748961549, 93.8319181673125,
       42.6058752061454, 104.925873015307, 60.675452072118, 111.236937473566, 0.0559116957874898,
       0.0211212955668554, 0.0746370295664336},
      {"5 draws", autoregressive(0.5, 2, 5), 1.04623385539302, 0.873119819612312, 7.22471989593555,
       7.22471989593555, 7.22471989593555, 7.22471989593555, 7.22471989593555, 7.22471989593555,
       0.0814802117730465, 0.0421015929274958, 0.136764683262739},
      {"4 draws", autoregressive(0.5, 4, 4), 1.36589088408796, 1.30747706116482, 19.2659197224948,
       19.2659197224948, 19.2659197224948, 19.2659197224948, 19.2659197224948, 19.2659197224948,
       0.0603015322240323, 0.0365653636556227, 0.0967588174891408},
      {"7 draws", autoregressive(0.5, 4, 7), 1.23537845641362, 1.19761595004626, 33.1250698010785,
       33.1250698010785, 33.1250698010785, 33.1250698010785, 33.1250698010785, 33.1250698010785,
       0.0467869668599611, 0.0323130966779741, 0.0923626871325715},
      {"8 draws", autoregressive(0.5, 3, 8), 1.48952184839047, 1.49524753249542, 33.1250698010785,
       33.1250698010785, 33.1250698010785, 33.1250698010785, 33.1250698010785, 33.1250698010785,
       0.047676288338611, 0.0336393575838908, 0.122693891334898},
      {"12 draws", autoregressive(0.5, 2, 12), 1.36991991698507, 1.56373184274896, 10.5323670073805,
       11.7391304347826, 8.52323077471956, 10.530352386149, 22.3434991974318, 18.9274447949527,
       0.118886999184342, 0.0746375353224129, 0.116435934112976},
  };
}

void expect_close(double computed, double expected, const char* what) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(computed)) << what << ": " << computed;
  } else {
    EXPECT_NEAR(computed, expected, 1e-9 * std::abs(expected)) << what;
  }
}

TEST(Diagnostics, AreThoseOfArviZ) {
  for (const Vector& v : vectors()) {
    SCOPED_TRACE(v.name);
    expect_close(rank_r_hat(v.draws), v.rank_r_hat, "rank-normalized R-hat");
    expect_close(split_r_hat(v.draws), v.split_r_hat, "split R-hat");
    expect_close(ess_bulk(v.draws), v.bulk, "bulk");
    expect_close(ess_tail(v.draws), v.tail, "tail");
    expect_close(ess_mean(v.draws), v.mean, "mean");
    expect_close(ess_sd(v.draws), v.sd, "sd");
    expect_close(ess_quantile(v.draws, 0.5), v.median, "median");
    expect_close(ess_quantile(v.draws, 0.1), v.q10, "q10");
    expect_close(mcse_mean(v.draws), v.mcse_mean, "MCSE of the mean");
    expect_close(mcse_sd(v.draws), v.mcse_sd, "MCSE of the sd");
    expect_close(mcse_quantile(v.draws, 0.5), v.mcse_median, "MCSE of the median");
  }
}

TEST(Diagnostics, DoNotDependOnUnits) {
  const Draws draws = autoregressive(0.5, 3, 101);
  for (const double factor : {0x1p-900, 0x1p+400}) {
    const Draws scaled = mapped(draws, [&](std::size_t, double x) { return factor * x; });
    EXPECT_EQ(rank_r_hat(scaled), rank_r_hat(draws));
    EXPECT_EQ(ess_tail(scaled), ess_tail(draws));
  }
}

// As many as are sorted by their bits, the least of which are zeros of both signs, a positive one first.
TEST(Diagnostics, AskNotForTheSignOfZero) {
  Draws draws = autoregressive(0.5, 2, 3000);
  for (double& x : draws.values) x = std::max(x, 0.0);
  draws.values.front() = 0;
  Draws signed_zeros = draws;
  for (std::size_t i = 1; i < draws.values.size(); i += 2)
    if (draws.values[i] == 0) signed_zeros.values[i] = -0.0;
  EXPECT_EQ(rank_r_hat(signed_zeros), rank_r_hat(draws));
  EXPECT_EQ(ess_bulk(signed_zeros), ess_bulk(draws));
}

void expect_unknown(const Draws& draws) {
  EXPECT_TRUE(std::isnan(rank_r_hat(draws)));
  EXPECT_TRUE(std::isnan(split_r_hat(draws)));
  EXPECT_TRUE(std::isnan(ess_bulk(draws)));
  EXPECT_TRUE(std::isnan(ess_tail(draws)));
  EXPECT_TRUE(std::isnan(ess_mean(draws)));
  EXPECT_TRUE(std::isnan(ess_sd(draws)));
  EXPECT_TRUE(std::isnan(mcse_mean(draws)));
  EXPECT_TRUE(std::isnan(mcse_sd(draws)));
  EXPECT_TRUE(std::isnan(mcse_quantile(draws, 0.5)));
  EXPECT_TRUE(std::isnan(autocorrelation_time(draws)));
  EXPECT_TRUE(std::isnan(sokal_autocorrelation_time(draws)));
}

TEST(Diagnostics, OfDrawsThatTellNothingAreNaN) {
  expect_unknown({});
  expect_unknown({4, 100, std::vector<double>(400, 0.1)});
  expect_unknown(autoregressive(0.5, 4, 3));
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {none, infinity, -infinity}) {
    Draws draws = autoregressive(0.5, 4, 100);
    draws.values[250] = bad;
    expect_unknown(draws);
  }
}

// Chains that stand still at different places.
TEST(Diagnostics, OfTrappedChainsAreInfinite) {
  Draws draws{4, 100, std::vector<double>(400, 0.0)};
  std::fill(draws.values.begin() + 300, draws.values.end(), 1.0);
  EXPECT_EQ(split_r_hat(draws), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rank_r_hat(draws), std::numeric_limits<double>::infinity());
}

// τ = (1 + φ) / (1 - φ).  Of n draws, Sokal's estimate has the relative error √(2 (2·5 + 1) τ / n);
// the bound is 5.4 of them, a false alarm of 1e-7 each, were the draws not always the same.
TEST(AutocorrelationTime, OfAutoregressiveChainsIsKnown) {
  for (const double phi : {0.0, 0.5, 0.9}) {
    const Draws draws = autoregressive(phi, 4, 20'000);
    const double tau = (1 + phi) / (1 - phi);
    const double error = std::sqrt(22 * tau / static_cast<double>(draws.values.size()));
    EXPECT_NEAR(sokal_autocorrelation_time(draws), tau, 5.4 * error * tau);
    EXPECT_NEAR(autocorrelation_time(draws), tau, 5.4 * error * tau);
    EXPECT_GT(std::abs(sokal_autocorrelation_time(draws) - 1.5 * tau), 5.4 * error * tau);
  }
}

// φ^t; the bound is 5.4 standard errors of an autocorrelation [Bartlett 1946], the largest of all lags.
TEST(CombinedAutocorrelation, OfAutoregressiveChainsIsKnown) {
  constexpr double phi = 0.8;
  const std::vector<double> rho = combined_autocorrelation(autoregressive(phi, 4, 20'000), 6);
  const double error = std::sqrt((1 + phi * phi) / (1 - phi * phi) / 80'000);
  ASSERT_EQ(rho.size(), 7u);
  EXPECT_EQ(rho[0], 1);
  for (std::size_t t = 1; t < rho.size(); ++t) {
    EXPECT_NEAR(rho[t], std::pow(phi, t), 5.4 * error) << t;
    EXPECT_GT(std::abs(rho[t] - std::pow(0.95 * phi, t)), 5.4 * error) << t;
  }
}

// Half of the variance is between chains, and stays at all lags: the eight halves have a variance of 1/12 each, and so
// has d²/4 · 8/7, that of their means.  The bound is 5.4 standard errors of an autocorrelation.
TEST(CombinedAutocorrelation, StaysHighWhereChainsAreApart) {
  const double d = std::sqrt(7.0 / 24);
  const Draws apart = mapped(autoregressive(0, 4, 20'000),
                             [d](std::size_t chain, double x) { return x + (chain < 2 ? 0 : d); });
  const std::vector<double> rho = combined_autocorrelation(apart, 5);
  for (std::size_t t = 1; t < rho.size(); ++t)
    EXPECT_NEAR(rho[t], 0.5, 5.4 / std::sqrt(80'000)) << t;
  EXPECT_EQ(combined_autocorrelation(Draws{2, 8, std::vector<double>(16, 3.0)}, 5),
            std::vector<double>{});
  Draws trapped{2, 8, std::vector<double>(16, 0.0)};
  std::fill(trapped.values.begin() + 8, trapped.values.end(), 1.0);
  EXPECT_EQ(combined_autocorrelation(trapped, 9), std::vector<double>(4, 1.0))
      << "no lag beyond a half";
}

TEST(AutocorrelationTime, OfChainsThatAreTooShortIsNaN) {
  EXPECT_TRUE(std::isnan(sokal_autocorrelation_time(autoregressive(0.999, 4, 200))));
}

// Draws per event of the mean itself, not of ranks: where few draws carry the mean, the two differ.
TEST(AutocorrelationTime, IsThatOfTheMean) {
  const Draws draws =
      mapped(autoregressive(0.9, 4, 1000), [](std::size_t, double x) { return std::exp(4 * x); });
  EXPECT_DOUBLE_EQ(autocorrelation_time(draws), 4000 / ess_mean(draws));
  EXPECT_GT(std::abs(ess_mean(draws) / ess_bulk(draws) - 1), 0.05);
}

}  // namespace
}  // namespace wander::test
