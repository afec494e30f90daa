// What may be done to a scene that changes no bit of its film but the exponents: lengths times a power
// of two, radiances times one, a quarter turn (of space: about z), a material that nothing is made
// of.  Where a bit changes, somewhere a number that has a unit was compared with one that has
// none, or left the range of its type.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/job.h"
#include "work/session.h"

namespace wander {

struct Variation {
  std::string name;        // "lengths x 2^100"
  double film_factor = 1;  // a power of two
  description::Scene scene;
};

// Those that leave the scene within what scene files may say.
std::vector<Variation> variations_of(const description::Scene& scene);

enum class SymmetryVerdict { same, differs, refused };

// Of one method.
struct SymmetryCheck {
  std::string method, variation;
  Precision precision = Precision::of_double;
  SymmetryVerdict verdict = SymmetryVerdict::same;
  double difference = 0;  // the largest of a value, as a share of the largest value
  std::string reason{};   // why the program refuses to render the variation
};

// Each variation of the job's scene by each method that renders it, in each precision, with the budget
// and seed of the session.  Where the scene itself is refused, nothing is checked.  Calls done() after
// each method, first of double precision, then of single.
std::vector<SymmetryCheck> check_symmetries(const Job& job,
                                            const std::vector<Variation>& variations,
                                            const Session& session,
                                            const std::function<void()>& done);
}  // namespace wander
