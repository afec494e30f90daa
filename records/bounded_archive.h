// What reads the bytes of cereal's BinaryOutputArchive, whoever wrote them: no more memory is taken for a
// list than the bytes can hold, and what is wrong is told in our own words.
#pragma once

#include <algorithm>
#include <cereal/cereal.hpp>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace wander {

class ArchiveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class BoundedArchive : public cereal::InputArchive<BoundedArchive, cereal::AllowEmptyClassElision> {
 public:
  explicit BoundedArchive(std::string_view bytes) : InputArchive(this), bytes_(bytes) {}

  void take(void* to, std::size_t size) {
    require(size);
    std::copy_n(bytes_.data(), size,
                static_cast<char*>(to));  // of an empty list: nothing, to nowhere
    bytes_.remove_prefix(size);
  }
  // That so many bytes are left.
  void require(std::size_t size) const {
    if (size > bytes_.size()) throw ArchiveError("it ends too early");
  }

 private:
  std::string_view bytes_;
};

template <class Number>
requires std::is_arithmetic_v<Number>
void load(BoundedArchive& archive, Number& number) { archive.take(&number, sizeof number); }
// A flag is a byte that may hold anything.
inline void load(BoundedArchive& archive, bool& flag) {
  unsigned char byte = 0;
  archive.take(&byte, 1);
  flag = byte != 0;
}
template <class Value>
void load(BoundedArchive& archive, cereal::NameValuePair<Value>& pair) {
  archive(pair.value);
}
// Of which each element is one byte at the least.
template <class Size>
void load(BoundedArchive& archive, cereal::SizeTag<Size>& tag) {
  archive(tag.size);
  archive.require(static_cast<std::size_t>(tag.size));
}
template <class Data>
void load(BoundedArchive& archive, cereal::BinaryData<Data>& data) {
  archive.take(data.data, static_cast<std::size_t>(data.size));
}

}  // namespace wander

CEREAL_REGISTER_ARCHIVE(wander::BoundedArchive)
