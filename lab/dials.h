// The dials of the trade between speed and accuracy, each by the word under which `render` takes it
// as an option (--large-step 0.3) and `compare` sweeps it (--sweep large_step=0.1,0.3).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lab/method.h"
#include "lab/precision.h"
#include "mlt/run/chain_settings.h"
#include "mutations/family_settings.h"

namespace wander {

struct Dials {
  MutationWeights mutations{};                            // of mlt; empty: auto
  StepEstimator estimator = StepEstimator::usual;         // of pssmlt and mmlt
  std::optional<int> max_vertices{};                      // of the paths; none: what the scene says
  ChainSettings chains{.film_parts = FilmParts::pooled};  // of the Markov chain methods
  Precision precision = Precision::of_double;             // of scattering, densities and sampling
  double large_step = default_large_step;  // of the primary steps, the share that is large
  std::optional<double> kernel{};  // a factor on how far small moves go; none: it is adapted
  FilmLayout film{};               // what is kept of the film

  // Before an adaptation.
  FamilySettings family() const { return {mutations, large_step, kernel.value_or(1)}; }
  bool operator==(const Dials&) const = default;
};

// A dial as the command line knows it.
struct Dial {
  DialId id;
  std::string_view word;   // "large_step"
  std::string_view value;  // what stands for its value in the help: "P"; empty: it is `on`
  std::string help;
  void (*set)(Dials& dials, std::string_view text);  // throws UsageError

  std::string option() const;  // "--large-step"
  bool is_of(const Method& method) const { return method.dials.has(id); }
};
std::span<const Dial> dials();

// Throws UsageError, with the nearest known word, where there is no such dial.
const Dial& find_dial(std::string_view word);
// Throws UsageError if the method does not have the dial.
void require_dial(const Dial& dial, const Method& method);

}  // namespace wander
