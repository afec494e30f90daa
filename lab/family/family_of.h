// The mutations of a job.  Only the files of this folder know their types; the rest of the program is
// the same for any family.
#pragma once

#include "lab/job.h"
#include "mutations/catalogue.h"

namespace wander {

inline Family family_of(const Job& job) {
  return make_family(job.family(), requires_of(job.scene()));
}
// With small moves that go so many times as far.
inline Family family_of(const Job& job, double kernel) {
  return make_family(job.family(kernel), requires_of(job.scene()));
}

}  // namespace wander
