// Metropolis light transport, in order.  Read this file first.
//
//   scene → seed pass → seeds and b → chains × mixture of mutations → steps → {film, statistics}
//
// chain_run.h has the run itself, which knows no budget; drive.h brings it to the end of one.
#pragma once

#include "lab/chain_run.h"
#include "lab/drive.h"

namespace wander {

// `Chains` is a Group, made of a space and the kernel of its chains.
template <class Space, Group Chains>
class ChainRenderer {
 public:
  template <class Kernel>
  ChainRenderer(const Space& space, const Kernel& kernel, const Session& session,
                const ChainSettings& settings)
      : run_(session), chains_("", space, kernel, run_, fitted(settings, session.budget)) {}

  Rendering render(const char* method) {
    Rendering rendering = drive(chains_, run_);
    rendering.method = method;
    return rendering;
  }

 private:
  Run run_;
  ChainRun<Space, Chains> chains_;
};

// Chains of a kernel in path space; other groups are named by the caller.
template <class Space, class Kernel>
ChainRenderer(const Space&, const Kernel&, const Session&, ChainSettings)
    -> ChainRenderer<Space, PathGroup<Space, Kernel>>;

}  // namespace wander
