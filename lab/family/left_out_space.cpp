#include "lab/family/left_out.h"

namespace wander {

template std::unique_ptr<LiveRun> MltMethod::make(const Stage<Spaceland>&);

}  // namespace wander
