#include "lab/method_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/engine.h"
#include "mlt/seeds/nothing_found.h"

namespace wander {

namespace {

// Methods with the same seed share their random walks; their films would not be independent.
Session with_own_numbers(Session session, std::uint64_t method) {
  session.seed += 0x9E3779B97F4A7C15 * (method + 1);
  return session;
}

constexpr int longest_side = 16;

// An image is compared in larger pixels, which fewer samples make reliable.
description::Scene in_large_pixels(description::Scene scene) {
  const auto enlarge = [](std::vector<int>& resolution) {
    const int side = *std::ranges::max_element(resolution);
    if (resolution.size() == 2 && side > longest_side)
      for (int& pixels : resolution) pixels = std::max(1, pixels * longest_side / side);
  };
  if (scene.camera) enlarge(scene.camera->resolution);
  for (description::Shape& shape : scene.shapes)
    if (shape.sensor) enlarge(shape.sensor->resolution);
  return scene;
}

MethodCheck untested(std::string method, std::string reason) {
  return {.method = std::move(method), .reason = std::move(reason)};
}

Measurement measured(const FilmEstimate& film, std::size_t bin) {
  return {film.value[bin], film.standard_error[bin], film.degrees_of_freedom};
}

// Two values of this sum could be so different that the test tells them apart.
bool could_disagree(const Measurement& a, const Measurement& b, double rate) {
  return student_threshold(rate, welch(a, b).degrees) *
             std::hypot(a.standard_error, b.standard_error) <
         a.value + b.value;
}

}  // namespace

MethodCheck compare_films(std::string method, const FilmEstimate& film,
                          const FilmEstimate& reference, double false_alarm) {
  std::vector<std::size_t> reliable, bins;
  for (std::size_t i = 0; i < film.value.size(); ++i)
    if (film.reliable[i] && reference.reliable[i]) reliable.push_back(i);
  if (reliable.empty())
    return untested(std::move(method),
                    "no bin of both films is reliable; a larger --samples may make some so");
  std::vector<Measurement> a, b;
  for (const std::size_t i : reliable) {
    const Measurement one = measured(film, i), other = measured(reference, i);
    if (!could_disagree(one, other, sidak_rate(false_alarm, reliable.size()))) continue;
    a.push_back(one);
    b.push_back(other);
    bins.push_back(i);
  }
  if (bins.empty())
    return untested(
        std::move(method),
        fmt::format("where both films are reliable, in {} of {} bins, their errors rest on too few "
                    "groups of chains to decide anything; a larger --samples may help",
                    reliable.size(), film.value.size()));
  Decision decision = welch_tests(a, b, false_alarm);
  decision.worst = bins[decision.worst];
  return {.method = std::move(method),
          .verdict = decision.passed ? Verdict::passed : Verdict::failed,
          .decision = decision,
          .bins = film.value.size()};
}

std::vector<MethodCheck> check_methods(const Job& job, const Session& session, double false_alarm,
                                       const std::function<void()>& done) {
  Dials dials = job.dials();
  dials.chains.film_parts = FilmParts::chains;  // a film that samples make, too, would hide a flaw
  const Job seen(in_large_pixels(job.scene()), job.method(), dials);
  const Rendering reference = render(seen.usual(reference_method()), with_own_numbers(session, 0));
  done();
  std::vector<MethodCheck> checks;
  for (const Method* method : checked_methods()) {
    const std::string name(method->name);
    if (const std::string_view why = method->why_blind(job.scene()); !why.empty()) {
      checks.push_back(untested(name, fmt::format("it {}", why)));
    } else {
      try {
        const Rendering rendering =
            render(seen.by(*method), with_own_numbers(session, checks.size() + 1));
        checks.push_back(compare_films(name, rendering.film, reference.film, false_alarm));
      } catch (const NoLightFound& dark) {
        checks.push_back(untested(name, dark.what()));
      }
    }
    done();
  }
  return checks;
}

}  // namespace wander
