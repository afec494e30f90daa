// What a run computed, as Python sees it: the record of a run that was made, read or merged.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <string>

#include "draw/figure/axis.h"
#include "records/run_record.h"

namespace wander::python {

// All views of it keep it.
struct BoundRecord {
  std::shared_ptr<const RunRecord> run;
};

struct BoundFilm {
  std::shared_ptr<const RunRecord> owner;
  const FilmEstimate* film;
};

nanobind::dict quantity_of(const figure::Quantity& quantity);

// As `wander render -o DIR` writes it, but for its checkpoint.
void write_record(const BoundRecord& record, const std::string& directory, bool replaces,
                  double exposure);

}  // namespace wander::python
