#include "records/seal.h"

#include "scenes/format/sha256.h"

namespace wander {

namespace {

constexpr std::string_view mark = "wanderlight-sha256 ";
constexpr std::size_t digits = 64;
constexpr std::size_t seal_size = mark.size() + digits + 1;

std::string seal_of(std::string_view bytes) { return std::string(mark) + sha256(bytes) + "\n"; }

}  // namespace

std::string sealed(std::string bytes) {
  const std::string seal = seal_of(bytes);
  return std::move(bytes) + seal;
}

std::optional<std::string_view> unsealed(std::string_view file) {
  if (file.size() < seal_size) return std::nullopt;
  const std::string_view bytes = file.substr(0, file.size() - seal_size);
  if (file.substr(bytes.size()) != seal_of(bytes)) return std::nullopt;
  return bytes;
}

}  // namespace wander
