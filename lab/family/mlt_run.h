// mlt in one world, with the family of mutations.
#pragma once

#include "lab/chain_methods.h"
#include "lab/chains_on_stage.h"
#include "lab/family/family_of.h"

namespace wander {

template <World W>
std::unique_ptr<LiveRun> MltMethod::make(const Stage<W>& stage) {
  return chain_run<PathGroup<Transport<W>, Family>>(
      stage, [&job = stage.job](double factor) { return family_of(job, factor); });
}

}  // namespace wander
