#include "scenes/format/texture_file.h"

#include <fmt/format.h>
#include <png.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace wander {

namespace {

constexpr std::uint64_t most_texels = std::uint64_t{1} << 27;
// More than deflate reaches: a header may promise any size, and memory is spent only on what the file can hold.
constexpr int best_compression = 2048;

// libpng ends what it is at by a jump: the functions that it is called from hold nothing that would
// have to be destroyed.
class PngFile {
 public:
  explicit PngFile(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "rb")) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, end, pass_over);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (file_ == nullptr || info_ == nullptr) problem_ = "it cannot be opened";
  }
  ~PngFile() {
    png_destroy_read_struct(&png_, &info_, nullptr);
    if (file_ != nullptr) std::fclose(file_);
  }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  // False: there is a problem, told in our own words and not in those of the library.
  bool read_header() {
    if (problem_ != nullptr) return false;
    problem_ = "its header is not that of one";
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, file_);
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_strip_alpha(png_);
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    problem_ = "its data are damaged or cut short";
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::uint64_t width() const { return png_get_image_width(png_, info_); }
  std::uint64_t height() const { return png_get_image_height(png_, info_); }
  int channels() const { return png_get_channels(png_, info_); }
  int bits() const { return png_get_bit_depth(png_, info_); }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  std::uint64_t bytes() const { return height() * row_bytes(); }
  const char* problem() const { return problem_; }

 private:
  [[noreturn]] static void end(png_structp png, png_const_charp) { png_longjmp(png, 1); }
  static void pass_over(png_structp, png_const_charp) {}

  std::FILE* file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  const char* problem_ = nullptr;
};

// Of numbers from 0 to `most`.
std::vector<double> decoded(int most) {
  std::vector<double> values(static_cast<std::size_t>(most) + 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = linear_of_srgb(static_cast<double>(i) / most);
  return values;
}

template <class Value>
bool read_texels(PngFile& file, std::vector<Value>& values) {
  values.resize(file.height() * file.row_bytes() / sizeof(Value));
  std::vector<png_bytep> rows(file.height());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = reinterpret_cast<png_bytep>(values.data()) + i * file.row_bytes();
  return file.read_rows(rows.data());
}

}  // namespace

double linear_of_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::shared_ptr<const Texture> read_texture(const std::filesystem::path& path) {
  std::error_code problem;
  const auto status = std::filesystem::status(path, problem);
  if (status.type() == std::filesystem::file_type::not_found)
    throw TextureFileError("there is no such file; check the path");
  if (!std::filesystem::is_regular_file(status))
    throw TextureFileError("this is no file of data; name a PNG file");
  PngFile file(path);
  const auto refuse = [&] {
    throw TextureFileError(fmt::format("this is no PNG that can be read ({})", file.problem()) +
                           "; a texture is a PNG file");
  };
  if (!file.read_header()) refuse();
  if (file.width() * file.height() > most_texels)
    throw TextureFileError(
        fmt::format("the picture is too large; a texture may have {} texels", most_texels));
  if (file.bytes() > std::uintmax_t{best_compression} * std::filesystem::file_size(path, problem))
    throw TextureFileError(
        "this is no PNG that can be read (its header promises more than the file holds); a texture "
        "is a PNG file");
  Texture::Picture picture;
  picture.width = static_cast<int>(file.width());
  picture.height = static_cast<int>(file.height());
  picture.channels = file.channels();
  picture.meaning = decoded(file.bits() == 16 ? 65535 : 255);
  if (!(file.bits() == 16 ? read_texels(file, picture.words) : read_texels(file, picture.bytes)))
    refuse();
  return std::make_shared<const Texture>(std::move(picture));
}

}  // namespace wander
