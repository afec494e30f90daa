#include "records/seal.h"

#include "scenes/format/sha256.h"

namespace wander {

namespace {

std::string seal_with(const std::string& digest) { return std::string(seal_mark) + digest + "\n"; }
std::string seal_of(std::string_view bytes) { return seal_with(sha256(bytes)); }

}  // namespace

std::string sealed(std::string bytes) {
  const std::string seal = seal_of(bytes);
  return std::move(bytes) + seal;
}

void write_sealed(const FileWriter& bytes, const ByteSink& file) {
  Sha256 hash;
  bytes([&](std::string_view piece) {
    hash.add(piece);
    file(piece);
  });
  file(seal_with(hash.digest()));
}

std::optional<std::string_view> unsealed(std::string_view file) {
  if (file.size() < seal_size) return std::nullopt;
  const std::string_view bytes = file.substr(0, file.size() - seal_size);
  if (file.substr(bytes.size()) != seal_of(bytes)) return std::nullopt;
  return bytes;
}

}  // namespace wander
