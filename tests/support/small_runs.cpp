#include "tests/support/small_runs.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "lab/engine.h"
#include "scenes/format/scene_file.h"
#include "tests/support/claimed_errors.h"

namespace wander::test {

namespace {

Job job_of(const SmallRuns& c) {
  const SceneDocument document =
      read_scene_file(std::string(WANDER_SOURCE) + "/scenes/" + c.scene + ".json");
  Dials dials;
  dials.chains.film_parts = FilmParts::chains;
  dials.chains.fewest_seeds = c.seeds;
  dials.kernel = 1;
  return {document.scene, find_method(c.method), dials};
}

Session small_session(std::uint64_t samples, std::uint64_t seed) {
  Session session;
  session.budget = SampleBudget{samples};
  session.seed = seed;
  session.threads = 1;
  return session;
}

std::string state_of_small_run(const Job& job, const Session& session) {
  std::string state;
  const Keeper keeper{[&](const Headway&, const StateWriter& write) {
                        std::ostringstream bytes;
                        write(bytes);
                        state = bytes.str();
                      },
                      0, 0};
  carry_on({}, job, session, keeper);
  return state;
}

Rendering small_run(const Job& job, const SmallRuns& c, std::uint64_t first_seed) {
  if (c.merged == 1) return render(job, small_session(c.samples, first_seed));
  std::vector<StoredRun> runs;
  for (int k = 0; k < c.merged; ++k) {
    const auto number = static_cast<std::uint64_t>(k);
    const Session session = small_session((number + 1) * c.samples, first_seed + number);
    runs.push_back(
        {session.seed, [state = state_of_small_run(job, session)] { return state; }, "none"});
  }
  return merge(job, runs, small_session(0, first_seed));
}

void add_normalization(Claims& claims, const Normalization& b, int max_vertices) {
  for (const auto& [name, estimate] : b.estimates) {
    if (!estimate.failure.empty()) throw std::runtime_error(name + ": " + estimate.failure);
    claims[name].push_back(
        {.value = {estimate.value}, .standard_error = {estimate.standard_error}});
  }
  const auto lengths = static_cast<std::size_t>(max_vertices) - 1;
  FilmEstimate light{.value = std::vector<double>(lengths),
                     .standard_error = std::vector<double>(lengths)};
  for (const LengthShare& share : b.by_length) {
    const auto k = static_cast<std::size_t>(share.vertices) - 2;
    light.value[k] = share.value;
    light.standard_error[k] = share.standard_error;
  }
  claims["by_length"].push_back(std::move(light));
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const SmallRuns& c) {
  out << c.scene << ' ' << c.method;
  return c.merged > 1 ? out << ", " << c.merged << " runs merged" : out;
}

Claims claims_of(const SmallRuns& c) {
  const Job job = job_of(c);
  Claims claims;
  for (int run = 0; run < c.runs; ++run) {
    const Rendering r = small_run(job, c, 100 + static_cast<std::uint64_t>(run * c.merged));
    claims["film"].push_back(r.film);
    if (r.normalization) add_normalization(claims, *r.normalization, job.scene().max_vertices);
  }
  return claims;
}

Claims scaled_errors(Claims claims, double factor) {
  for (auto& [name, runs] : claims)
    for (FilmEstimate& run : runs)
      for (double& error : run.standard_error) error *= factor;
  return claims;
}

Decision claims_test(const Claims& claims, double tolerance, double false_alarm) {
  std::vector<Compared> family;
  std::ostringstream text;
  for (const auto& [name, runs] : claims) {
    const ClaimedRatio ratio = claimed_ratio(runs);
    const double off = std::log(ratio.value), error = ratio.standard_error / ratio.value;
    const double beyond = std::copysign(std::max(0.0, std::abs(off) - tolerance), off);
    // What no run has is not tested.
    family.push_back({ratio.bins > 0 ? beyond / error : INFINITY, error, 1});
    text << (text.tellp() > 0 ? "; " : "") << name << ' ' << ratio.value << " ± "
         << ratio.standard_error << " (" << ratio.bins << ')';
  }
  Decision d = largest_z_test(family, false_alarm);
  d.test = "claimed variances";
  d.visible = std::expm1(d.visible + tolerance);
  d.detail = text.str();
  return d;
}

}  // namespace wander::test
