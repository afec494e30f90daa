// A picture on a surface, which says what is reflected there: linear, Rec. 709, one channel or three.
//
// (u, v) = (0, 0) is its lower left corner and (1, 1) its upper right one; it is repeated beyond.
// Between the centres of texels, which are at (i + ½) / size, it is bilinear.  Texels are kept as the
// file has them, in 16 bits a channel at most, beside a table of what they mean.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace wander {

class Texture {
 public:
  struct Picture {
    int width = 0, height = 0, channels = 1;
    std::vector<std::uint8_t> bytes{};  // row 0 on top; one of the two is empty
    std::vector<std::uint16_t> words{};
    std::vector<double> meaning{};  // of each byte or word
  };

  explicit Texture(Picture picture);

  bool is_coloured() const { return picture_.channels == 3; }
  // Grey is three equal channels.
  std::array<double, 3> at(std::array<double, 2> uv) const;
  const std::array<double, 3>& mean() const { return mean_; }

 private:
  double texel(int x, int y, int channel) const;

  Picture picture_;
  std::array<double, 3> mean_{};
};

}  // namespace wander
