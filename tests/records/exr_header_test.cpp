// The header of an EXR film, before the library reads it: attributes of any program pass, and none that
// promises what the file does not hold.
#include "records/exr_header.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfPreviewImage.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTimeCodeAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace wander::test::exr_header_test {
namespace {

namespace fs = std::filesystem;

class ExrHeader : public ::testing::Test {
 protected:
  ExrHeader() {
    std::string name = (fs::temp_directory_path() / "wander-header-XXXXXX").string();
    folder = mkdtemp(name.data());
    path = folder / "film.exr";
  }
  ~ExrHeader() override { fs::remove_all(folder); }

  // One pixel, and in its header what programs of pictures write.
  void film_of_others(unsigned width = 2, unsigned height = 3) const {
    Imf::Header header(1, 1);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.insert("up", Imf::V3fAttribute({0, 0, 1}));
    header.insert("worldToCamera", Imf::M44fAttribute(Imath::M44f()));
    header.insert("timeCode", Imf::TimeCodeAttribute(Imf::TimeCode()));
    header.insert("views", Imf::StringVectorAttribute({"left", "right"}));
    header.setPreviewImage(Imf::PreviewImage(width, height));
    Imf::OutputFile file(path.c_str(), header);
    float pixel = 1;
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixel), 4, 4));
    file.setFrameBuffer(buffer);
    file.writePixels(1);
  }
  std::string bytes() const {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  // The first byte after a word and so many others is now this one.
  void spoil(const std::string& whole, const std::string& after, std::size_t more,
             char byte) const {
    std::string spoilt = whole;
    const std::size_t at = whole.rfind(after);  // a name may be that of its type
    ASSERT_NE(at, std::string::npos) << after;
    spoilt[at + after.size() + more] = byte;
    std::ofstream(path, std::ios::binary) << spoilt;
  }

  fs::path folder, path;
};

TEST_F(ExrHeader, OfOtherProgramsPasses) {
  film_of_others();
  EXPECT_NO_THROW(require_plausible_header(path));
}

TEST_F(ExrHeader, OfAnEmptyPreviewPasses) {
  film_of_others(0, 0);
  EXPECT_NO_THROW(require_plausible_header(path));
}

TEST_F(ExrHeader, OfATypeThatNobodyKnowsPasses) {
  film_of_others();
  std::string whole = bytes();
  const std::size_t at = whole.find("v3f");
  ASSERT_NE(at, std::string::npos);
  whole[at] = 'q';
  std::ofstream(path, std::ios::binary) << whole;
  EXPECT_NO_THROW(require_plausible_header(path));
}

TEST_F(ExrHeader, OfAnotherSizeThanItsTypeIsRefused) {
  film_of_others();
  const std::string whole = bytes();
  for (const std::string type : {"v3f", "m44f", "timecode", "preview", "stringvector", "chlist"}) {
    constexpr char another = 2;
    spoil(whole, type + '\0', 0, another);
    EXPECT_THROW(require_plausible_header(path), std::runtime_error) << type;
  }
}

// The size of the attribute is right, and what is counted within it is not.
TEST_F(ExrHeader, OfStringsAndPicturesLongerThanTheirAttributeIsRefused) {
  film_of_others();
  const std::string whole = bytes();
  constexpr std::size_t size = 4;
  for (const std::string type : {"preview", "stringvector"}) {
    spoil(whole, type + '\0', size, 127);
    EXPECT_THROW(require_plausible_header(path), std::runtime_error) << type;
  }
}

// The library takes memory for whole lines of all channels, and for as many lines as are packed together.
TEST_F(ExrHeader, OfMoreThanTheFileCanHoldIsRefused) {
  film_of_others();
  const std::string whole = bytes();
  const std::string window = std::string("dataWindow\0box2i\0", 17);
  const std::string compression = std::string("compression\0compression\0", 24);
  constexpr std::size_t third_of_right = 4 + 8 + 2, value = 4;
  spoil(whole, window, third_of_right, 4);  // 2¹⁸ pixels in a line, of four bytes
  EXPECT_THROW(require_plausible_header(path), std::runtime_error);
  spoil(whole, window, third_of_right, 1);
  EXPECT_NO_THROW(require_plausible_header(path));
  constexpr char of_256_lines = 9, unknown = 77;
  spoil(bytes(), compression, value, of_256_lines);
  EXPECT_THROW(require_plausible_header(path), std::runtime_error);
  spoil(whole, compression, value, unknown);
  EXPECT_THROW(require_plausible_header(path), std::runtime_error);
}

TEST_F(ExrHeader, OfOtherKindsOfFilesIsRefused) {
  film_of_others();
  const std::string whole = bytes();
  for (const char kind : {'\x02', '\x08', '\x10'}) {
    spoil(whole, std::string("\x76\x2f\x31\x01\x02", 5), 0, kind);
    EXPECT_THROW(require_plausible_header(path), std::runtime_error) << int(kind);
  }
}

}  // namespace
}  // namespace wander::test::exr_header_test
