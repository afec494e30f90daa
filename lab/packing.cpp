#include "lab/packing.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <streambuf>

namespace wander {

namespace {

class PieceBuffer : public std::streambuf {
 public:
  explicit PieceBuffer(const ByteSink& sink) : sink_(sink) {
    setp(bytes_.data(), bytes_.data() + bytes_.size());
  }

 protected:
  int_type overflow(int_type byte) override {
    sync();
    if (!traits_type::eq_int_type(byte, traits_type::eof())) sputc(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }
  int sync() override {
    sink_({pbase(), static_cast<std::size_t>(pptr() - pbase())});
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    return 0;
  }

 private:
  const ByteSink& sink_;
  std::array<char, 1 << 16> bytes_;
};

}  // namespace

void write_through(const ByteSink& sink, const std::function<void(std::ostream&)>& write) {
  PieceBuffer buffer(sink);
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);  // what the sink throws is passed on
  write(stream);
  stream.flush();
}

struct Packing::Stream {
  z_stream state{};
  std::array<char, 1 << 16> packed{};
};

// States are mostly zeros, of what has not yet happened: little effort packs them well.
Packing::Packing(const ByteSink& file) : file_(file), stream_(std::make_unique<Stream>()) {
  if (deflateInit(&stream_->state, Z_BEST_SPEED) != Z_OK)
    throw std::runtime_error("the state of the run cannot be compressed");
}
Packing::~Packing() { deflateEnd(&stream_->state); }

void Packing::add(std::string_view bytes) {
  constexpr std::size_t most = std::numeric_limits<uInt>::max();
  for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size()))) {
    stream_->state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_->state.avail_in = static_cast<uInt>(std::min(most, bytes.size()));
    deflate(Z_NO_FLUSH);
  }
}

void Packing::end() { deflate(Z_FINISH); }

// All that has been added; with Z_FINISH, to the end of the stream.
void Packing::deflate(int flush) {
  z_stream& state = stream_->state;
  do {
    state.next_out = reinterpret_cast<Bytef*>(stream_->packed.data());
    state.avail_out = static_cast<uInt>(stream_->packed.size());
    ::deflate(&state, flush);
    file_({stream_->packed.data(), stream_->packed.size() - state.avail_out});
  } while (state.avail_out == 0);
}

}  // namespace wander
