#include "records/film_columns.h"

#include <fstream>
#include <stdexcept>

namespace wander {

using nlohmann::ordered_json;

void require_parts_of(const Rendering& rendering) {
  if (!rendering.pooling) return;
  const std::size_t size = rendering.pooling->film_of_samples.size();
  if (size != 0 && size != rendering.film.value.size())
    throw std::runtime_error("the list of what samples carry differs in length from the film");
}

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
  using Event = ordered_json::parse_event_t;
  const auto level = static_cast<std::size_t>(depth);
  if (event == Event::key) {
    place_.resize(level);
    place_.back() = parsed.get<std::string>();
  }
  if (!limit_.keeps(depth, event)) return false;
  // At the level of a list's elements there are as many keys as lists they are in.
  if (event != Event::value || place_.empty() || place_.front() != "film" ||
      level != place_.size() + 1)
    return true;
  if (place_.size() == 2) return !take(film_, place_.back(), parsed);
  if (place_.size() != 3) return true;
  if (place_[1] == "chains") return !take(chains_, place_.back(), parsed);
  return place_[1] != "samples" || !take(samples_, place_.back(), parsed);
}

bool FilmColumns::take(Lists& lists, const std::string& name, const ordered_json& parsed) {
  const bool is_number = parsed.is_number() || parsed.is_null();
  const auto number = [&] { return parsed.is_null() ? not_known : parsed.get<double>(); };
  if (name == "value" && is_number)
    lists.value.push_back(number());
  else if (name == "standard_error" && is_number)
    lists.standard_error.push_back(number());
  else if (name == "reliable" && parsed.is_boolean())
    lists.reliable.push_back(parsed.get<bool>());
  else
    return false;
  return true;
}

void FilmColumns::move_to(Rendering& rendering) {
  FilmEstimate& film = rendering.film;
  if (film_.standard_error.size() != film_.value.size() ||
      film_.reliable.size() != film_.value.size() || !film.value.empty())
    throw std::runtime_error("the film's lists differ in length");
  film.value = std::move(film_.value);
  film.standard_error = std::move(film_.standard_error);
  film.reliable = std::move(film_.reliable);
  if (rendering.pooling) rendering.pooling->film_of_samples = std::move(samples_.value);
  require_parts_of(rendering);
  if (!rendering.chains_film) return;
  if (chains_.value.size() != film.value.size() ||
      (!chains_.standard_error.empty() && chains_.standard_error.size() != film.value.size()))
    throw std::runtime_error("the lists of the chains' film differ in length");
  rendering.chains_film->value = std::move(chains_.value);
  rendering.chains_film->standard_error = std::move(chains_.standard_error);
}

}  // namespace wander
