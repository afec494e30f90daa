// A JSON document written piece by piece, in the layout of nlohmann::json::dump.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "records/atomic_file.h"

namespace wander {

class JsonText {
 public:
  using Json = nlohmann::ordered_json;

  JsonText(int indent, const ByteSink& file)
      : indent_(static_cast<std::size_t>(indent)), file_(file) {}

  void open_object() {
    file_("{");
    has_entries_.push_back(false);
  }
  void close_object() {
    const bool had_entries = has_entries_.back();
    has_entries_.pop_back();
    if (had_entries) file_(line());
    file_("}");
  }
  JsonText& key(const std::string& name) {
    file_((has_entries_.back() ? "," : "") + line() + text_of(name) + ": ");
    has_entries_.back() = true;
    return *this;
  }
  void value(const Json& json) { file_(text_of(json)); }
  // at(i) for i below `size`: scalars.
  template <class At>
  void array(std::size_t size, At&& at) {
    if (size == 0) return file_("[]");
    file_("[");
    has_entries_.push_back(true);
    const std::string begin = line();
    for (std::size_t i = 0; i < size; ++i) {
      if (i > 0) file_(",");
      file_(begin);
      file_(Json(at(i)).dump());
    }
    has_entries_.pop_back();
    file_(line() + "]");
  }

 private:
  std::string line() const { return '\n' + std::string(indent_ * has_entries_.size(), ' '); }
  // A string of JSON has no ends of lines.
  std::string text_of(const Json& json) const {
    const std::string text =
        json.dump(static_cast<int>(indent_), ' ', false, Json::error_handler_t::replace);
    std::string indented;
    for (const char c : text) c == '\n' ? indented += line() : indented += c;
    return indented;
  }

  std::size_t indent_;
  const ByteSink& file_;
  std::vector<bool> has_entries_;  // of the objects that are open
};

}  // namespace wander
