// What a step and a sample cost as paths get longer, shapes more and chains more.
#pragma once

namespace wander {

void register_scaling();

}  // namespace wander
