// What is wrong at one place of an imported file, and the error that holds all of them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace wander {

struct ImportFault {
  std::string file;
  int line = 1, column = 1;  // from 1; columns count characters
  std::string path;          // of the element: /scene/shape[2]/bsdf
  std::string what;          // "what is wrong; remedy"
};

// `FILE:LINE:COL: path: what`
std::string line_of(const ImportFault& fault);

// what() has one line per fault.
class ImportError : public std::runtime_error {
 public:
  explicit ImportError(std::vector<ImportFault> faults);

  const std::vector<ImportFault> faults;
};

}  // namespace wander
