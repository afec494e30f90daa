#include "scenes/import/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scenes/format/json_text.h"
#include "scenes/format/texture_file.h"
#include "scenes/import/number_words.h"
#include "scenes/import/spectrum.h"
#include "scenes/import/texture.h"

namespace wander {

namespace {

Colour grey(double value) { return {value, value, value}; }

// #rrggbb
std::optional<Colour> hexadecimal(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return {};
  Colour result{};
  for (std::size_t i = 1; i < 7; ++i) {
    const auto digit =
        std::string_view("0123456789abcdef").find(static_cast<char>(std::tolower(text[i])));
    if (digit == std::string_view::npos) return {};
    result[(i - 1) / 2] = 16 * result[(i - 1) / 2] + static_cast<double>(digit);
  }
  for (double& channel : result) channel /= 255;
  return result;
}

std::optional<Colour> one_or_three(std::string_view text) {
  if (const auto colour = hexadecimal(text)) return colour;
  const auto numbers = numbers_in(text);
  if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) return {};
  if (numbers->size() == 1) return grey(numbers->front());
  return Colour{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

// False: these are no numbers, or no longer wavelength than the one before.
bool add(Spectrum& spectrum, std::string_view wavelength, std::string_view value) {
  const auto at = number_in(wavelength), much = number_in(value);
  if (!at || !much || (!spectrum.empty() && *at <= spectrum.back().first)) return false;
  spectrum.emplace_back(*at, *much);
  return true;
}

// 400:0.1, 500:0.2
std::optional<Spectrum> spectrum_in(std::string_view text) {
  Spectrum spectrum;
  for (const std::string_view word : words_in(text)) {
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) return {};
    if (!add(spectrum, word.substr(0, colon), word.substr(colon + 1))) return {};
  }
  if (spectrum.empty()) return {};
  return spectrum;
}

// A wavelength and a value on each line; what follows a # is passed over.
std::optional<Spectrum> spectrum_in(std::istream& file) {
  Spectrum spectrum;
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, '\r', ' ');
    const auto words = words_in(std::string_view(line).substr(0, line.find('#')));
    if (words.empty()) continue;
    if (words.size() != 2 || !add(spectrum, words[0], words[1])) return {};
  }
  if (spectrum.empty()) return {};
  return spectrum;
}

Colour of_spectrum_file(const XmlElement& element, Light light, const ImportContext& context) {
  const std::string name = element.attribute("filename");
  const std::filesystem::path path = context.file(element, name);
  if (path.empty()) return grey(0);
  std::ifstream file(path);
  if (const auto spectrum = spectrum_in(file)) {
    context.diagnosis.inexact(element, "a spectrum over wavelengths", "its colour");
    return colour_of(*spectrum, light);
  }
  context.diagnosis.fault(element,
                          fmt::format("{} is no spectrum; each of its lines gives a wavelength and "
                                      "a value, in growing order",
                                      excerpt(name)));
  return grey(0);
}

Colour of_spectrum(const XmlElement& element, Light light, const ImportContext& context) {
  if (element.has("filename")) return of_spectrum_file(element, light, context);
  const std::string text = element.attribute("value");
  if (const auto spectrum = spectrum_in(text)) {
    context.diagnosis.inexact(element, "a spectrum over wavelengths", "its colour");
    return colour_of(*spectrum, light);
  }
  // The white of version 0.x is that of the screen, D65.
  const bool is_tinted = light == Light::emitted && !context.is_old();
  if (const auto value = number_in(text); value && is_tinted) {
    Colour colour = equal_energy();
    for (double& channel : colour) channel *= *value;
    return colour;
  }
  if (const auto colour = one_or_three(text)) return *colour;
  context.diagnosis.fault(
      element, fmt::format("\"{}\" is no spectrum; give one number, or wavelength:value pairs in "
                           "growing order",
                           excerpt(text)));
  return grey(0);
}

}  // namespace

Colour colour_of(const XmlElement& given, Light light, const ImportContext& context) {
  const XmlElement* element = context.resolved(given);
  if (element == nullptr) return grey(0);
  if (element->tag == "texture") return mean_of_texture(*element, context);
  if (element->tag == "spectrum" && element->has("type")) {
    for (const XmlElement& child : element->children)
      if (element->type() == "uniform" && child.attribute("name") == "value")
        return colour_of(child, light, context);
    context.diagnosis.fault(*element,
                            fmt::format("the spectrum \"{}\" is not known; known is uniform, "
                                        "or give a value",
                                        excerpt(element->type())));
    return grey(0);
  }
  if (element->tag == "spectrum") return of_spectrum(*element, light, context);
  const std::string text = element->attribute("value");
  std::optional<Colour> colour = one_or_three(text);
  if (!colour) {
    context.diagnosis.fault(
        *element, fmt::format("\"{}\" is no colour; give one number or three", excerpt(text)));
    return grey(0);
  }
  if (element->tag == "srgb") std::ranges::transform(*colour, colour->begin(), linear_of_srgb);
  return *colour;
}

nlohmann::ordered_json json_of(const Colour& colour) {
  if (colour[0] == colour[1] && colour[1] == colour[2]) return colour[0];
  return colour;
}

}  // namespace wander
