// How a method by Markov chains makes its run: chains on a stage, with kernels that are adapted or not.
#pragma once

#include <memory>

#include "lab/chain_run.h"
#include "lab/drive.h"
#include "lab/stage.h"

namespace wander {

// `Chains` is the Group of the run; scaled(factor) is the kernel whose small moves go so many times
// as far as usual.
template <class Chains, World W, class KernelOf>
std::unique_ptr<LiveRun> chain_run(const Stage<W>& stage, const KernelOf& scaled) {
  const Dials& dials = stage.job.dials();
  ChainSettings settings = dials.chains;
  settings.film = dials.film;
  const auto made = [&](const auto& kernel) {
    return std::make_unique<ChainRun<Transport<W>, Chains>>(
        stage.job.method().name.data(), stage.space, kernel, stage.execution,
        fitted(settings, stage.execution.session().budget));
  };
  return dials.kernel ? made(scaled(*dials.kernel)) : made(Adaptable<KernelOf>{scaled});
}

}  // namespace wander
