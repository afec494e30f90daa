#include "records/version.h"

namespace wander {

const char* program_version() { return WANDER_VERSION; }  // project(VERSION) of the build

}  // namespace wander
