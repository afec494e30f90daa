#include "lab/world_checks.h"

namespace wander {

template void check_in<SpacelandColour>(const Job&, const InvarianceOptions&, const Run&,
                                        const KernelChecked&);

}  // namespace wander
