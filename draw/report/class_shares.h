// Where chains spend their time: the share of their steps that begin at paths of each class.
#pragma once

#include "draw/report/html.h"
#include "draw/report/subject.h"

namespace wander::report {

void write_class_shares(Html& html, const Subject& subject);

}  // namespace wander::report
