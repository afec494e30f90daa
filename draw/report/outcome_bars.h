// Stacked bars of what became of the proposals of each mutation, with the reasons of refusal.
#pragma once

#include "draw/report/html.h"
#include "draw/report/subject.h"

namespace wander::report {

void write_outcomes(Html& html, const Subject& subject);

}  // namespace wander::report
