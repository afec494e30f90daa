// Bytes on their way into a file: from an ostream to whoever takes pieces, and packed by zstd.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "records/atomic_file.h"

namespace wander {

// write(ostream), whose bytes go to `sink` piece by piece.
void write_through(const ByteSink& sink, const std::function<void(std::ostream&)>& write);

// One frame of zstd [RFC 8878] of all that is added.
class Packing {
 public:
  explicit Packing(const ByteSink& file);
  ~Packing();
  Packing(const Packing&) = delete;
  Packing& operator=(const Packing&) = delete;

  void add(std::string_view bytes);
  void end();

 private:
  struct Stream;

  const ByteSink& file_;
  std::unique_ptr<Stream> stream_;
};

// What became this frame, if it has this size; none if it has not, or if this is no frame.  Throws std::bad_alloc.
std::optional<std::string> unpacked(std::string_view frame, std::uint64_t size);

}  // namespace wander
