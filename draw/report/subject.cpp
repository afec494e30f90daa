#include "draw/report/subject.h"

#include <algorithm>

#include "draw/figure/film_series.h"
#include "scenes/format/scene_file.h"

namespace wander::report {

std::vector<std::string> Subject::labels() const {
  std::vector<std::string> labels;
  for (const Contender& contender : runs().contenders) labels.push_back(contender.label);
  return labels;
}

std::string Subject::unit_of_bins() const { return figure::film_axes(scene).value.unit; }

std::vector<const Run*> Subject::replicates(std::size_t contender, std::size_t budget) const {
  std::vector<const Run*> found;
  for (const Run& run : runs().runs)
    if (run.contender == contender && run.budget == budget) found.push_back(&run);
  std::ranges::sort(found, {}, &Run::replicate);
  return found;
}

std::vector<Cell> Subject::cells(std::size_t contender) const {
  std::vector<Cell> found;
  for (const Cell& cell : comparison.cells)
    if (cell.contender == contender && cell.replicates > 0) found.push_back(cell);
  return found;
}

const Rendering* Subject::details(std::size_t contender) const {
  if (contender >= runs().details.size()) return nullptr;
  const Rendering& rendering = runs().details[contender];
  return rendering.film.value.empty() ? nullptr : &rendering;
}

description::Scene scene_of(const Comparison& comparison) {
  const Provenance& provenance = comparison.runs.provenance;
  return parse_scene(provenance.scene_text, provenance.scene_name).scene;
}

WholeReplicates::WholeReplicates(const Subject& subject, std::size_t contender,
                                 std::size_t budget) {
  for (const Run* run : subject.replicates(contender, budget)) {
    const bool is_here = !run->film.value.empty() || !subject.runs().shelf;
    if (!is_here) {
      lent_.push_back(*run);
      lent_.back().film = subject.runs().shelf(*run);
    }
    runs_.push_back(is_here ? run : &lent_.back());
  }
}

std::vector<std::size_t> chain_contenders(const Subject& subject) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k); details && !details->mutations.empty())
      found.push_back(k);
  return found;
}

}  // namespace wander::report
