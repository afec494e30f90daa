// Bytes on their way into a file: from an ostream to whoever takes pieces, and packed by zlib.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <string_view>

#include "records/atomic_file.h"

namespace wander {

// write(ostream), whose bytes go to `sink` piece by piece.
void write_through(const ByteSink& sink, const std::function<void(std::ostream&)>& write);

// The zlib stream of all that is added, as zlib's uncompress() reads it.
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
  void deflate(int flush);

  const ByteSink& file_;
  std::unique_ptr<Stream> stream_;
};

}  // namespace wander
