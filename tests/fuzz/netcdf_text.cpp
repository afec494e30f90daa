#include "tests/fuzz/netcdf_text.h"

#include <charconv>
#include <cstdint>
#include <map>
#include <sstream>
#include <vector>

#include "records/netcdf.h"

namespace wander::fuzz {

namespace {

using netcdf::Error;
using netcdf::Writer;

constexpr std::size_t most_values = 100'000;  // that are written

template <class Number>
Number number_of(std::string_view word) {
  Number number{};
  std::from_chars(word.data(), word.data() + word.size(), number);
  return number;
}

std::vector<std::string> list_of(const std::string& word) {
  std::vector<std::string> list;
  std::istringstream items(word == "-" ? "" : word);
  for (std::string item; std::getline(items, item, ',');) list.push_back(item);
  return list;
}

class NetcdfText {
 public:
  void add(const std::string& line) {
    std::istringstream words(line);
    std::string what, name, rest;
    words >> what >> name;
    const auto next = [&] {
      std::string word;
      words >> word;
      return word;
    };
    if (what == "group") {
      group_ = root_.group(name);
      lengths_.clear();
    } else if (what == "dimension") {
      const auto length = number_of<std::size_t>(next());
      group_.dimension(name, length);
      lengths_[name] = length;
    } else if (what == "text") {
      std::getline(words >> std::ws, rest);
      group_.attribute(name, std::string_view(rest));
    } else if (what == "whole") {
      group_.attribute(name, number_of<std::int64_t>(next()));
    } else if (what == "number") {
      group_.attribute(name, number_of<double>(next()));
    } else if (what == "empty") {
      const auto dimensions = list_of(next());
      group_.numbers_in_parts(name, dimensions, std::vector<std::size_t>(dimensions.size(), 1), "");
    } else if (what == "words") {
      const auto dimensions = list_of(next());
      const auto meanings = list_of(next());
      group_.variable(name, dimensions, values<std::int32_t>(dimensions, next()), meanings, "");
    } else {
      add_variable(what, name, list_of(next()), next());
    }
  }
  std::string take() { return root_.take(); }

 private:
  void add_variable(const std::string& what, const std::string& name,
                    const Writer::Dimensions& dimensions, const std::string& numbers) {
    if (what == "doubles")
      group_.variable(name, dimensions, values<double>(dimensions, numbers), "");
    if (what == "ints")
      group_.variable(name, dimensions, values<std::int32_t>(dimensions, numbers), "");
    if (what == "flags")
      group_.flags(name, dimensions, values<std::uint8_t>(dimensions, numbers), "");
  }

  template <class Number>
  std::vector<Number> values(const Writer::Dimensions& dimensions, const std::string& numbers) {
    std::size_t size = 1;
    for (const std::string& dimension : dimensions) {
      if (!lengths_.contains(dimension)) throw Error("an unknown dimension");
      const std::size_t length = lengths_.at(dimension);
      if (length > most_values || (size *= length) > most_values) throw Error("too many values");
    }
    const std::vector<std::string> given = list_of(numbers);
    std::vector<Number> values(size);
    for (std::size_t i = 0; i < size && !given.empty(); ++i)
      values[i] = number_of<Number>(given[i % given.size()]);
    return values;
  }

  Writer root_ = Writer::create(0), group_ = root_;
  std::map<std::string, std::size_t> lengths_;  // of the dimensions of the group
};

}  // namespace

std::string netcdf_of(std::string_view text) {
  NetcdfText file;
  std::istringstream lines{std::string(text)};
  try {
    for (std::string line; std::getline(lines, line);) file.add(line);
  } catch (const Error&) {
    file.take();  // which closes it
    throw;
  }
  return file.take();
}

}  // namespace wander::fuzz
