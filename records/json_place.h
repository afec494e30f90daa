// A value of a JSON document with its place there, for readers of our own files: what is not as it
// should be is told with its place and in our own words, "/film/shape: it is missing".
//
//   const JsonPlace run(document);
//   film.shape = run.at("film").at("shape").get<std::vector<int>>();
//
// The document outlives its places.
#pragma once

#include <concepts>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wander {

// what() = "POINTER: what is wrong"
class JsonPlaceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <class Value>
concept JsonScalar = std::same_as<Value, bool> || std::same_as<Value, std::string> ||
    std::same_as<Value, double> || std::same_as<Value, int> || std::same_as<Value, std::uint64_t>;

class JsonPlace {
 public:
  explicit JsonPlace(const nlohmann::ordered_json& value, std::string pointer = {})
      : value_(&value), pointer_(std::move(pointer)) {}

  // Of an object.
  JsonPlace at(std::string_view key) const;
  std::optional<JsonPlace> find(std::string_view key) const;  // none where there is no such key
  template <class Value>
  Value value(std::string_view key, Value otherwise) const {
    const auto found = find(key);
    return found ? found->get<Value>() : otherwise;
  }
  std::vector<std::pair<std::string, JsonPlace>> members() const;

  // Of a list.
  std::vector<JsonPlace> elements() const;
  // Null stands for what is not known, NaN.
  std::vector<double> numbers() const;
  double number() const;

  // The same of what an object may lack: nothing, or NaN.
  std::vector<JsonPlace> elements_if(std::string_view key) const;
  std::vector<double> numbers_if(std::string_view key) const;
  double number_if(std::string_view key) const;

  template <class Value>
  Value get() const {
    Value value;
    read(value);
    return value;
  }
  template <JsonScalar Value>
  operator Value() const {
    return get<Value>();
  }

  [[noreturn]] void refuse(std::string_view what) const;

 private:
  void read(bool& value) const;
  void read(int& value) const;
  void read(std::uint64_t& value) const;
  void read(double& value) const;
  void read(std::string& value) const;
  void read(std::vector<bool>& values) const;
  template <class Value>
  void read(std::vector<Value>& values) const {
    for (const JsonPlace& element : elements()) values.push_back(element.get<Value>());
  }
  template <class Value>
  void read(std::map<std::string, Value>& values) const {
    for (const auto& [key, member] : members()) values[key] = member.template get<Value>();
  }
  JsonPlace inside(const nlohmann::ordered_json& value, std::string_view token) const;

  const nlohmann::ordered_json* value_;
  std::string pointer_;
};

// A text that is no JSON is refused with the place where it ceases to be: "line 2, column 7: ...".
nlohmann::ordered_json parsed_json(std::string_view text);

}  // namespace wander
