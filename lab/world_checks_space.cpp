#include "lab/world_checks.h"

namespace wander {

template void check_in<Spaceland>(const Job&, const InvarianceOptions&, const Run&,
                                  const KernelChecked&);

}  // namespace wander
