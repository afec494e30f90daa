// What is wrong, or doubtful, at one place of a scene file.
#pragma once

#include <string>

namespace wander {

struct Fault {
  int line = 1, column = 1;   // from 1; columns count characters, not bytes
  std::string pointer, what;  // JSON pointer, `/` for the whole document; "what is wrong; remedy"
};

}  // namespace wander
