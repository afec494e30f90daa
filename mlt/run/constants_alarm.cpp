#include <fmt/format.h>

#include <cmath>
#include <map>

#include "mlt/run/normalization.h"
#include "statistics/number_text.h"

namespace wander {

namespace {

// What the seed pass and the chains say of one part of the light.
struct ShareOfPart {
  double seeds = 0, chains = 0;
};
using SharesOfParts = std::map<std::string, ShareOfPart>;

// By class where the states of the chains have one, else by length.
SharesOfParts parts_of(std::span<const GroupFindings> groups) {
  SharesOfParts parts;
  for (const GroupFindings& group : groups) {
    const auto& evidence = *group.evidence;
    if (!group.classes.empty() || group.scale == 0) {
      for (std::size_t c = 0; c < evidence.classes.size(); ++c)
        parts[name_of_class(evidence.classes.code(c))].seeds += evidence.by_class[c].value();
      for (const ClassLight& each : group.classes)
        parts[name_of_class(each.path_class)].chains += each.light;
      continue;
    }
    const std::vector<double> deposits = group.film->by_length();
    for (std::size_t k = 0; k < deposits.size(); ++k) {
      ShareOfPart& part = parts[fmt::format("of {} vertices", k + 2)];
      part.seeds += group.seeds->sum[k].value();
      part.chains += group.scale * deposits[k];
    }
  }
  return parts;
}

}  // namespace

std::string disagreement_of_constants(std::span<const GroupFindings> groups,
                                      const Constants& constants) {
  const Constant &seeds = constants.seed_pass, &bridge = constants.bridge;
  if (!bridge.failure.empty()) return {};
  const double error = std::hypot(seeds.b.standard_error, bridge.b.standard_error);
  const double difference = bridge.b.value - seeds.b.value;
  // Where both know b, they differ by what rounding leaves of the sums.
  const double rounding = 1e-9 * std::abs(seeds.b.value);
  if (!(std::abs(difference) > largest_disagreement * error + rounding)) return {};
  const SharesOfParts parts = parts_of(groups);
  ShareOfPart total;
  for (const auto& [name, part] : parts) {
    total.seeds += part.seeds;
    total.chains += part.chains;
  }
  std::string worst;
  double largest = 0;
  for (const auto& [name, part] : parts) {
    const double by_seeds = seeds.b.value * part.seeds / total.seeds;
    const double by_chains = bridge.b.value * part.chains / total.chains;
    if (std::abs(by_chains - by_seeds) <= largest) continue;
    largest = std::abs(by_chains - by_seeds);
    worst = fmt::format("{} ({} by the seed pass, {} by the chains)", name, number_text(by_seeds),
                        number_text(by_chains));
  }
  return fmt::format(
      "the estimates of b contradict each other: {} by bridge sampling, {} by the mean of "
      "the seed pass, {:.1f} standard errors apart, most of it in paths {}; {}",
      number_text(bridge.b.value, 4), number_text(seeds.b.value, 4), std::abs(difference) / error,
      worst,
      difference < 0
          ? "the chains have missed light that the seed pass found: believe neither, and "
            "take other mutations or a larger budget"
          : "the seed pass has missed light that the chains found: take a longer one");
}

}  // namespace wander
