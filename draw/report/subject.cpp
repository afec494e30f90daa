#include "draw/report/subject.h"

#include <algorithm>

#include "scenes/format/scene_file.h"

namespace wander::report {

std::vector<std::string> Subject::labels() const {
  std::vector<std::string> labels;
  for (const Contender& contender : runs().contenders) labels.push_back(contender.label);
  return labels;
}

std::vector<const Run*> Subject::replicates(std::size_t contender) const {
  std::vector<const Run*> found;
  for (const Run& run : runs().runs)
    if (run.contender == contender && run.budget == last_budget()) found.push_back(&run);
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

Subject subject_of(const Comparison& comparison) {
  const Provenance& provenance = comparison.runs.provenance;
  return {comparison, parse_scene(provenance.scene_text, provenance.scene_name).scene};
}

std::vector<std::size_t> chain_contenders(const Subject& subject) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k); details && !details->mutations.empty())
      found.push_back(k);
  return found;
}

}  // namespace wander::report
