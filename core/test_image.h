#pragma once
#include <vector>
#include "core/raster.h"
namespace wander {
struct TestImage {
  Raster raster;
  std::vector<double> weights;
  double weight(int bin) const { return weights[raster.cell(bin)]; }
};
inline const TestImage* the_test_image = nullptr;
}
