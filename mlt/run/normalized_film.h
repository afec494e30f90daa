// The film of all groups of chains, scaled to a normalization constant of its own estimation:
//   I_j = b · bins · Σ_g F_gj / Σ_g Σ_j F_gj,
// with F_g what group g would say alone.  Its error bars are those of the delete-a-group jackknife,
// in which b changes with the group that is left out, so that they carry the error of b.  A ratio
// has a bias of the order of one over the samples of the seed pass; GroupsFilm (deposit.h) has
// none, but all the noise of the seed pass.
#pragma once

#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/group_findings.h"
#include "mlt/run/normalization.h"

namespace wander {

FilmEstimate normalized_film(std::span<const GroupFindings> groups, const Constant& constant,
                             std::vector<int> shape);

}  // namespace wander
