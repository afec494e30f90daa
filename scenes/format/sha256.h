// SHA-256, the identity of a scene's text.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace wander {

// 64 hexadecimal digits in lower case.
std::string sha256(std::string_view text);

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
