// Renderings by pssmlt and mmlt, with either estimator or a twin of one.
#pragma once

#include "lab/render.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/catalogue.h"
#include "mutations/kelemen.h"

namespace wander::test {

template <template <class, class, class> class Chains, class Estimator>
Rendering render_primary(const Scene<Flatland>& scene, const Session& session,
                         const ChainSettings& settings = {}) {
  using Space = Transport<Flatland>;
  const Space space(scene, Roulette::off);
  const PrimaryKernel<Kelemen> kernel{Kelemen{}, default_large_step};
  return ChainRenderer<Space, Chains<Space, Kelemen, Estimator>>(space, kernel, session, settings)
      .render("primary");
}

// The four that the program offers, by name.
struct PrimaryMethod {
  const char* name;
  Rendering (*render)(const Scene<Flatland>&, const Session&, const ChainSettings&);
};
inline constexpr PrimaryMethod primary_methods[] = {
    {"pssmlt_expected", &render_primary<PssmltGroup, ExpectedValues>},
    {"pssmlt_kelemen", &render_primary<PssmltGroup, KelemenWeights>},
    {"mmlt_expected", &render_primary<MmltGroup, ExpectedValues>},
    {"mmlt_kelemen", &render_primary<MmltGroup, KelemenWeights>}};

inline Session budget_of(std::uint64_t samples, std::uint64_t seed = 1) {
  Session session;
  session.budget = SampleBudget{samples};
  session.seed = seed;
  session.threads = 2;
  return session;
}

}  // namespace wander::test
