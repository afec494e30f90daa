#include "lab/world_checks.h"

namespace wander {

template void check_family<Flatland>(const description::Scene&, const Family&,
                                     const InvarianceOptions&, const Run&,
                                     const std::function<void(KernelCheck)>&);

}  // namespace wander
