// What a comparison of images shows of a contender at the decisive budget, made while the films of
// its replicates are there:
//
//   film    of the first replicate: what one run of that time looks like
//   error   per pixel, √( (Σ_c mean_r (x_rc - I_c)² - Σ_c e_c²) / (Σ_c I_c² + n (0.01 mean I)²) ),
//           over replicates r and channels c, n of them
//   z       per pixel, of luminance: (mean_r x_r - I) / √(s²/R + e²), with s the standard deviation
//           over replicates; not known of a single one
#pragma once

#include <optional>

#include "draw/figure/image_maps.h"
#include "draw/report/subject.h"

namespace wander::report {

struct ContenderImage {
  std::size_t contender = 0;
  Run run{};
  std::size_t replicates = 0;
  figure::PixelMap error{}, z{};
};

// None where there is no run.
std::optional<ContenderImage> image_of(const Subject& subject, std::size_t contender);

}  // namespace wander::report
