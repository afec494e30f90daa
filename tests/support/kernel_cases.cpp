#include "tests/support/kernel_cases.h"

#include "mutations/catalogue.h"

namespace wander::test {

namespace {

using Flat = Transport<Flatland>;

bool everywhere(const Requirements&) { return true; }
// Where the sensor sees no specular vertex behind one that scatters, it cannot act.
bool behind_scattering(const Requirements& scene) { return Multichain::left_out(scene).empty(); }

// Most kernels change every function of a path.  The caustic perturbation keeps the sensor's vertex
// of all but the shortest paths, and few paths are made for the multi-chain perturbation.
constexpr std::size_t most = 30, some = 20, few = 8;

// `make` gives the kernel for paths of up to so many vertices.
template <class Make>
KernelCase of(const char* name, Make make, std::size_t fewest_comparisons = most,
              std::function<bool(const Requirements&)> acts = everywhere) {
  return {name,
          [make](const Flat& space, const InvarianceOptions& options) {
            const auto kernel = make(space.max_vertices());
            return test_invariance(space, kernel, options);
          },
          fewest_comparisons, std::move(acts)};
}

// Far enough to reach other walls, other media and other lobes.
constexpr PerturbationRange wide{.position{1e-3, 0.4}, .angle{1e-3, 0.7}};

}  // namespace

std::vector<KernelCase> kernel_cases() {
  return {of("Bidirectional", [](int) { return alone(Bidirectional{}); }),
          of("PrimarySmall", [](int) { return alone(PrimarySmall{}); }),
          of("PrimaryLarge", [](int longest) { return alone(PrimaryLarge(longest)); }),
          of("Lens", [](int) { return alone(Lens{}); }),
          of(
              "Caustic", [](int) { return alone(Caustic{}); }, some),
          of(
              "Multichain", [](int) { return alone(Multichain{}); }, few, behind_scattering),
          of("Family", [](int longest) { return make_family({}, longest); })};
}

std::vector<KernelCase> wide_perturbations() {
  return {of("Lens", [](int) { return alone(Lens{wide}); }),
          of(
              "Caustic", [](int) { return alone(Caustic{wide}); }, some),
          of(
              "Multichain", [](int) { return alone(Multichain{wide}); }, few, behind_scattering)};
}

std::vector<RoomKernel> acting_in(const std::vector<NamedRoom>& rooms,
                                  const std::vector<KernelCase>& kernels) {
  std::vector<RoomKernel> pairs;
  for (const NamedRoom& room : rooms)
    for (const KernelCase& kernel : kernels)
      if (kernel.acts(requires_of(room.make()))) pairs.push_back({room.name, room.make, kernel});
  return pairs;
}

}  // namespace wander::test
