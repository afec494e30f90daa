// The sections of a report, in their order.  Each writes what stands below its heading.
#pragma once

#include "draw/report/html.h"
#include "draw/report/subject.h"

namespace wander::report {

void write_verdict(Html& html, const Subject& subject);
void write_scene(Html& html, const Subject& subject);
void write_films(Html& html, const Subject& subject);
// Of images, in the place of films.
void write_pictures(Html& html, const Subject& subject);
void write_spread(Html& html, const Subject& subject);
void write_errors(Html& html, const Subject& subject);
void write_acceptance(Html& html, const Subject& subject);
void write_mixing(Html& html, const Subject& subject);
void write_energy(Html& html, const Subject& subject);
void write_normalization(Html& html, const Subject& subject);
void write_provenance(Html& html, const Subject& subject);

}  // namespace wander::report
