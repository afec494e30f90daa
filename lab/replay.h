// One step of a chain, made again and taken apart: every factor of
//   a(x→y) = min(1, f(y) T(y→x) / (f(x) T(x→y))),  T(x→y) = s_m(x) T_m(x→y),
// where s_m is the probability that the mixture selects mutation m (mixture.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/shown_chains.h"
#include "mlt/run/path_group.h"

namespace wander {

struct ReplayedVertex {
  std::vector<double> position;
  Event event = Event::scattering;
  double value = 0;     // Le, f_s or We
  double geometry = 0;  // of the edge towards the sensor; of no meaning at the last vertex
  double from_light = 0, from_sensor = 0;  // densities per unit of area
};

struct ReplayedPath {
  std::string path_class;
  std::vector<ReplayedVertex> vertices;
  std::vector<double> film;  // in [0,1)
  Scaled f;
};

// What exists only with a proposal.
struct ReplayedProposal {
  ReplayedPath y;
  Scaled forward, reverse;                  // T(x→y), T(y→x)
  double selection_x = 0, selection_y = 0;  // s_m(x), s_m(y)
  double decider = 0;                       // the uniform number: accepted where it is below a
};

struct Replay {
  int chain = 0;
  std::uint64_t step = 0;
  std::string mutation;
  Reason reason = Reason::none;
  double acceptance = 0;
  ReplayedPath x;
  std::optional<ReplayedProposal> proposal;
};

// Random numbers that remember the last uniform one, which a step compares with a.
class WatchedRng : public Rng {
 public:
  explicit WatchedRng(const Rng& random) : Rng(random) {}
  double uniform() { return last_ = Rng::uniform(); }
  double last() const { return last_; }

 private:
  double last_ = 0;
};

template <class Space>
ReplayedPath replayed(const Space& space, const Path<typename Space::Universe>& x) {
  using W = typename Space::Universe;
  ReplayedPath path{path_class(x), {}, {}, x.contribution};
  for (int i = 0; i < x.size(); ++i) {
    const Vertex<W>& v = x[i];
    path.vertices.push_back({{}, v.event, v.value, v.geometry, v.from_light, v.from_sensor});
    for (int k = 0; k < W::dimension; ++k)
      path.vertices.back().position.push_back(static_cast<double>(v.place.position[k]));
  }
  for (const auto u : space.film_position(x)) path.film.push_back(static_cast<double>(u));
  return path;
}

// Throws NothingComputed if it is interrupted.
template <class Space, class Kernel>
Replay replay(const Space& space, const Kernel& kernel, const Session& session, int chain_index,
              std::uint64_t step_index, ChainSettings settings) {
  using W = typename Space::Universe;
  Run run(session);
  const ShownChains<Space, PathChains<Space, Kernel>> shown(space, kernel, run, settings);
  auto chain = shown.chain(chain_index);
  for (std::uint64_t i = 0; i < step_index; ++i) {
    chain.step([](const Step<W>&) {});
    if (i % 1024 != 0) continue;
    if (run.is_interrupted()) throw NothingComputed("the step that is to be shown");
    run.report(
        {static_cast<double>(i) / static_cast<double>(step_index), i, run.seconds(), "sampling"});
  }
  Replay replay;
  replay.chain = chain_index;
  replay.step = step_index;
  WatchedRng random(chain.random);
  chain.step(random, [&](const Step<W>& step) {
    const auto m = static_cast<std::size_t>(step.mutation);
    replay.mutation = Kernel::names[m];
    replay.reason = step.reason;
    replay.acceptance = step.acceptance;
    replay.x = replayed(space, step.current);
    const Proposal* p = std::get_if<Proposal>(&step.outcome);
    if (p == nullptr) return;
    replay.proposal = {replayed(space, step.proposed),
                       p->forward,
                       p->reverse,
                       kernel.probabilities(space, step.current)[m],
                       kernel.probabilities(space, step.proposed)[m],
                       random.last()};
  });
  return replay;
}

}  // namespace wander
