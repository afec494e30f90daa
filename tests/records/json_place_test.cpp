#include "records/json_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "records/bounded_archive.h"
#include "records/rendering_archive.h"

namespace wander {
namespace {

const nlohmann::ordered_json document = parsed_json(
    R"({"film": {"shape": [2, 3.5], "value": [1, null], "a/b": "x"}, "seed": 18446744073709551615})");

template <class Reading>
std::string fault_of(Reading&& reading) {
  try {
    reading(JsonPlace(document));
  } catch (const JsonPlaceError& error) {
    return error.what();
  }
  return "none";
}

TEST(JsonPlaces, AreReadWhereTheyAreAsTheyShouldBe) {
  const JsonPlace place(document);
  EXPECT_EQ(place.at("seed").get<std::uint64_t>(), 18446744073709551615U);
  const std::vector<double> values = place.at("film").numbers_if("value");
  EXPECT_EQ(values[0], 1);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(place.numbers_if("value").empty());
}

TEST(JsonPlaces, AreToldInOurOwnWords) {
  EXPECT_EQ(fault_of([](const JsonPlace& p) { p.at("film").at("error"); }),
            "/film/error: it is missing");
  EXPECT_EQ(fault_of([](const JsonPlace& p) { p.at("film").at("shape").get<std::vector<int>>(); }),
            "/film/shape/1: a whole number from -2147483648 to 2147483647 is expected");
  EXPECT_EQ(fault_of([](const JsonPlace& p) { p.at("film").at("a/b").number(); }),
            "/film/a~1b: a number is expected");
  EXPECT_EQ(fault_of([](const JsonPlace& p) { p.at("seed").get<int>(); }),
            "/seed: a whole number from -2147483648 to 2147483647 is expected");
  EXPECT_EQ(fault_of([](const JsonPlace&) { parsed_json("{\n  \"a\": }"); }),
            "line 2, column 8: this is no JSON");
}

TEST(BoundedArchives, TakeNoMemoryThatTheBytesCannotFill) {
  const std::string whole = archived(std::vector<double>{1, 2});
  EXPECT_EQ(from_archive<std::vector<double>>(whole), (std::vector<double>{1, 2}));
  std::string promising = whole;
  promising[5] = '\x7f';
  EXPECT_THROW(from_archive<std::vector<double>>(promising), ArchiveError);
  EXPECT_THROW(from_archive<std::vector<double>>(whole.substr(0, whole.size() - 1)), ArchiveError);
}

}  // namespace
}  // namespace wander
