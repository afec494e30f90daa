#include "tests/support/kernel_cases.h"

#include "mutations/catalogue.h"

namespace wander::test {

namespace {

using Flat = Transport<Flatland>;

// `make` gives the kernel for paths of up to so many vertices.
template <class Make>
KernelCase of(const char* name, Make make) {
  return {name, [make](const Flat& space, const InvarianceOptions& options) {
            const auto kernel = make(space.max_vertices());
            return test_invariance(space, kernel, options);
          }};
}

}  // namespace

std::vector<KernelCase> kernel_cases() {
  return {of("Bidirectional", [](int) { return alone(Bidirectional{}); }),
          of("PrimarySmall", [](int) { return alone(PrimarySmall{}); }),
          of("PrimaryLarge", [](int longest) { return alone(PrimaryLarge(longest)); }),
          of("Lens", [](int) { return alone(Lens{}); }),
          of("Caustic", [](int) { return alone(Caustic{}); }),
          of("Multichain", [](int) { return alone(Multichain{}); }),
          of("Family", [](int longest) { return make_family({}, longest); })};
}

}  // namespace wander::test
