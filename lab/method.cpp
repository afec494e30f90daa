#include "lab/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/requirements.h"
#include "lab/chain_methods.h"
#include "lab/estimate.h"
#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/sample_doubts.h"

namespace wander {

namespace {

using enum DialId;
constexpr DialSet of_all{max_vertices, precision, by_length};
constexpr DialSet of_chains =
    of_all | DialSet{seed_share, film, normalization, large_step, kernel, maps};
constexpr DialSet of_mlt = of_chains | DialSet{mutations, chains, target};
constexpr DialSet of_pssmlt = of_chains | DialSet{estimator, chains};
// There is one chain for each path length in each group.
constexpr DialSet of_mmlt = of_chains | DialSet{estimator};

std::string_view never(const description::Scene&) { return {}; }
std::string_view through_a_camera(const description::Scene& scene) {
  if (!scene.camera) return {};
  return "cannot see through a camera: its light paths must hit the sensor by chance, and no path "
         "hits a pinhole, nor a lens, which is no surface of the scene; use lt, or a sensor shape";
}
// The camera is reached by connections alone, which mirrors and smooth glass forbid.
std::string_view mirrors_seen_by_a_camera(const description::Scene& scene) {
  if (!scene.camera || scene.max_vertices < 3) return {};
  const Requirements needs = requires_of(scene);
  if (needs.specular)
    return "cannot find paths that reach the camera from a mirror or from smooth glass";
  if (needs.narrowest_lobe <= lobe_of_hardly_any)
    return "hardly ever finds paths that reach the camera from a surface that is nearly a mirror "
           "or smooth glass";
  return {};
}

constexpr std::array method_table{
    Method{.name = path_tracing.name,
           .summary = "path tracing from the sensor, with next-event estimation",
           .state = ChainState::none,
           .dials = of_all,
           .run = made_by<IndependentSamples>,
           .estimator = &path_tracing,
           .check = CheckRole::compared,
           .makes_references = true,
           .why_impossible = never,
           .why_blind = never},
    Method{.name = light_tracing.name,
           .summary = "light tracing from the lights, with next-event estimation",
           .state = ChainState::none,
           .dials = of_all,
           .run = made_by<IndependentSamples>,
           .estimator = &light_tracing,
           .check = CheckRole::compared,
           .makes_references = true,
           .why_impossible = never,
           .why_blind = mirrors_seen_by_a_camera},
    Method{.name = bidirectional_path_tracing.name,
           .summary = "bidirectional path tracing",
           .state = ChainState::none,
           .dials = of_all,
           .run = made_by<IndependentSamples>,
           .estimator = &bidirectional_path_tracing,
           .check = CheckRole::reference,
           .makes_references = true,
           .why_impossible = never,
           .why_blind = never},
    Method{.name = "mlt",
           .summary = "Metropolis light transport in path space, all mutations",
           .state = ChainState::path,
           .dials = of_mlt,
           .run = made_by<MltMethod>,
           .check = CheckRole::compared,
           .makes_references = true,
           .why_impossible = never,
           .why_blind = never},
    Method{.name = "pssmlt",
           .summary = "Metropolis in primary sample space, whole bidirectional samples (Kelemen)",
           .state = ChainState::numbers_of_sample,
           .dials = of_pssmlt,
           .run = made_by<PssmltMethod>,
           .makes_references = true,
           .usual_estimator = StepEstimator::kelemen,  // as published
           .why_impossible = never,
           .why_blind = never},
    Method{.name = "mmlt",
           .summary = "multiplexed Metropolis: primary sample space, a chain for each path length",
           .state = ChainState::numbers_of_path,
           .dials = of_mmlt,
           .run = made_by<MmltMethod>,
           .makes_references = true,
           .why_impossible = never,
           .why_blind = never},
    Method{.name = naive_path_tracing.name,
           .summary = "path tracing that must hit a light",
           .state = ChainState::none,
           .dials = of_all,
           .run = made_by<IndependentSamples>,
           .estimator = &naive_path_tracing,
           .why_impossible = never,
           .why_blind = never},
    Method{.name = naive_light_tracing.name,
           .summary = "light tracing that must hit the sensor",
           .state = ChainState::none,
           .dials = of_all,
           .run = made_by<IndependentSamples>,
           .estimator = &naive_light_tracing,
           .why_impossible = through_a_camera,
           .why_blind = never},
};

static_assert(std::ranges::all_of(method_table, [](const Method& m) {
  return !m.name.empty() && !m.summary.empty() && m.why_impossible && m.why_blind;
}));
static_assert(std::ranges::count(method_table, CheckRole::reference, &Method::check) == 1);
static_assert(std::ranges::any_of(method_table, [](const Method& m) { return m.is_traced(); }));

}  // namespace

std::span<const Method> methods() { return method_table; }

const Method& find_method(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Method& method : method_table) {
    if (method.name == name) return method;
    known.push_back(method.name);
  }
  throw UsageError(unknown_word("method", name, known));
}

std::string in_words(std::span<const Method* const> methods, std::string_view last_link) {
  std::string text;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (i > 0) text += i + 1 < methods.size() ? ", " : fmt::format(" {} ", last_link);
    text += methods[i]->name;
  }
  return text;
}

const Method& reference_method() {
  return *std::ranges::find(method_table, CheckRole::reference, &Method::check);
}

std::vector<const Method*> checked_methods() {
  return methods_that([](const Method& m) { return m.check == CheckRole::compared; });
}

std::vector<const Method*> traced_methods() {
  return methods_that([](const Method& m) { return m.is_traced(); });
}

}  // namespace wander
