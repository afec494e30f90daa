#include "lab/family/mlt_run.h"

namespace wander {

template std::unique_ptr<LiveRun> MltMethod::make(const Stage<FlatlandSingle>&);

}  // namespace wander
