// SHA-256, by which texts and files are told from others.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace wander {

// 64 hexadecimal digits in lower case.
std::string sha256(std::string_view text);
// Throws std::runtime_error if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

// The same of a text that comes in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view piece);
  std::string digest();  // once

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace wander
