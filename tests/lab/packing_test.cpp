// What is packed comes back as it was, whatever its pieces; what is no frame, or of another size, does not.
#include "lab/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <ostream>

namespace wander::test::packing_test {
namespace {

std::string packed(std::string_view bytes, std::size_t piece) {
  std::string frame;
  const ByteSink sink = [&](std::string_view part) { frame += part; };
  Packing packing(sink);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
    packing.add(bytes.substr(0, piece));
  packing.end();
  return frame;
}

// Zeros, then bytes in which nothing repeats.
std::string state(std::size_t zeros, std::size_t others) {
  std::string bytes(zeros, '\0');
  std::uint64_t number = 7;
  for (std::size_t i = 0; i < others; ++i) {
    number = number * 6364136223846793005U + 1442695040888963407U;
    bytes += static_cast<char>(number >> 56);
  }
  return bytes;
}

TEST(Packing, GivesBackWhatWasAdded) {
  for (const std::string& bytes :
       {std::string(), std::string("a"), state(0, 300000), state(1 << 20, 1000)})
    for (const std::size_t piece : {std::size_t{1000}, std::size_t{1} << 16, bytes.size() + 1})
      EXPECT_EQ(unpacked(packed(bytes, piece), bytes.size()), bytes)
          << bytes.size() << " in pieces of " << piece;
}

TEST(Packing, MakesZerosSmallAndTheRestHardlyLarger) {
  EXPECT_LT(packed(state(1 << 20, 0), 1 << 16).size(), 1000u);
  EXPECT_LT(packed(state(0, 1 << 20), 1 << 16).size(), (1u << 20) + 1000);
}

TEST(Packing, TakesNothingElseForAFrame) {
  const std::string bytes = state(1000, 1000), frame = packed(bytes, 500);
  EXPECT_FALSE(unpacked("no frame at all", 100));
  EXPECT_FALSE(unpacked(frame, bytes.size() - 1));
  EXPECT_FALSE(unpacked(frame, bytes.size() + 1));
  EXPECT_FALSE(unpacked(frame, std::numeric_limits<std::uint64_t>::max())) << "and takes no room";
  EXPECT_FALSE(unpacked(std::string_view(frame).substr(0, frame.size() - 1), bytes.size()));
  EXPECT_FALSE(unpacked(frame + "x", bytes.size()));
}

TEST(Packing, WritesThroughAStreamInOrder) {
  std::string written;
  const std::string bytes = state(100, 200000);
  write_through([&](std::string_view piece) { written += piece; },
                [&](std::ostream& stream) {
                  for (const char byte : bytes.substr(0, 3)) stream.put(byte);
                  stream.write(bytes.data() + 3, static_cast<std::streamsize>(bytes.size() - 3));
                });
  EXPECT_EQ(written, bytes);
}

}  // namespace
}  // namespace wander::test::packing_test
