#include "records/film_columns.h"

#include <fstream>
#include <stdexcept>

namespace wander {

using nlohmann::ordered_json;

ordered_json FilmColumns::read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return ordered_json::parse(
      file,
      [this](int depth, ordered_json::parse_event_t event, ordered_json& parsed) {
        return stays(depth, event, parsed);
      },
      false);
}

bool FilmColumns::stays(int depth, ordered_json::parse_event_t event, const ordered_json& parsed) {
  using enum ordered_json::parse_event_t;
  if (event == key) {
    if (depth == 1) part_ = parsed.get<std::string>();
    list_ = depth == 2 ? parsed.get<std::string>() : std::string();
  }
  if (event != value || depth != 3 || part_ != "film") return true;
  const bool is_number = parsed.is_number() || parsed.is_null();
  const auto number = [&] { return parsed.is_null() ? not_known : parsed.get<double>(); };
  if (list_ == "value" && is_number)
    value_.push_back(number());
  else if (list_ == "standard_error" && is_number)
    standard_error_.push_back(number());
  else if (list_ == "reliable" && parsed.is_boolean())
    reliable_.push_back(parsed.get<bool>());
  else
    return true;
  return false;
}

void FilmColumns::move_to(FilmEstimate& film) {
  if (standard_error_.size() != value_.size() || reliable_.size() != value_.size() ||
      !film.value.empty())
    throw std::runtime_error("the film's lists differ in length");
  film.value = std::move(value_);
  film.standard_error = std::move(standard_error_);
  film.reliable = std::move(reliable_);
}

}  // namespace wander
