// Sums as one block: the bytes are those of the same sums one by one.
#include "lab/archived_sums.h"

#include <gtest/gtest.h>

#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace wander::test::archived_sums_test {
namespace {

template <class... Values>
std::string bytes_of(const Values&... values) {
  std::ostringstream bytes;
  cereal::BinaryOutputArchive archive(bytes);
  (archive(values), ...);
  return std::move(bytes).str();
}

template <class T>
std::string one_by_one(const std::vector<T>& sums) {
  std::string bytes = bytes_of(cereal::make_size_tag(cereal::size_type{sums.size()}));
  for (const T& sum : sums) bytes += bytes_of(sum);
  return bytes;
}

std::vector<Sum> some_sums() {
  std::vector<Sum> sums(5);
  for (double x : {1e20, 1.0, -1e20, 3e-9}) sums[1] += x;  // of which a part is kept apart
  sums[3] += 0.1;
  sums[3] += 0.2;
  return sums;
}

template <class T>
std::vector<T> again(const std::string& bytes) {
  std::istringstream stream(bytes);
  cereal::BinaryInputArchive archive(stream);
  std::vector<T> sums(2);
  archive(sums);
  return sums;
}

TEST(ArchivedSums, HaveTheBytesOfOneAfterTheOther) {
  const std::vector<Sum> sums = some_sums();
  EXPECT_EQ(bytes_of(sums), one_by_one(sums));
  EXPECT_EQ(one_by_one(again<Sum>(bytes_of(sums))), one_by_one(sums));
  const std::vector<BinSums> bins{{0.1, 0.01}, {}, {2, 4}};
  EXPECT_EQ(bytes_of(bins), one_by_one(bins));
  EXPECT_EQ(one_by_one(again<BinSums>(bytes_of(bins))), one_by_one(bins));
}

TEST(ArchivedSums, ThatEndTooEarlyAreRefused) {
  const std::string bytes = bytes_of(some_sums());
  EXPECT_THROW(again<Sum>(bytes.substr(0, bytes.size() - 1)), cereal::Exception);
}

}  // namespace
}  // namespace wander::test::archived_sums_test
