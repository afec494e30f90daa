#include "lab/packing.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <array>
#include <new>
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

// Of what a function of zstd returns; throws where it had no memory for its tables, which is no fault of what it read.
bool is_fault(std::size_t result) {
  if (!ZSTD_isError(result)) return false;
  if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  return true;
}

}  // namespace

void write_through(const ByteSink& sink, const std::function<void(std::ostream&)>& write) {
  PieceBuffer buffer(sink);
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);  // what the sink throws is passed on
  write(stream);
  stream.flush();
}

struct Packing::Stream {
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context{ZSTD_createCCtx(), &ZSTD_freeCCtx};
  std::array<char, 1 << 17> packed{};

  // All of `bytes`, and to the end of the frame with ZSTD_e_end.
  void pack(std::string_view bytes, ZSTD_EndDirective directive, const ByteSink& file) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    std::size_t left = 0;
    do {
      ZSTD_outBuffer out{packed.data(), packed.size(), 0};
      left = ZSTD_compressStream2(context.get(), &out, &in, directive);
      if (is_fault(left)) throw std::runtime_error("the state of the run cannot be compressed");
      file({packed.data(), out.pos});
    } while (directive == ZSTD_e_end ? left > 0 : in.pos < in.size);
  }
};

// States are zeros, of what has not yet happened, and numbers in which nothing repeats: more effort
// packs them hardly better.
Packing::Packing(const ByteSink& file) : file_(file), stream_(std::make_unique<Stream>()) {
  if (!stream_->context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(stream_->context.get(), ZSTD_c_compressionLevel, -1);
}
Packing::~Packing() = default;

void Packing::add(std::string_view bytes) { stream_->pack(bytes, ZSTD_e_continue, file_); }
void Packing::end() { stream_->pack({}, ZSTD_e_end, file_); }

std::optional<std::string> unpacked(std::string_view frame, std::uint64_t size) {
  constexpr std::uint64_t best_compression = 1 << 16;  // more than zstd reaches
  if (size / best_compression > frame.size()) return std::nullopt;
  std::string bytes(size, '\0');
  const std::size_t found = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
  return !is_fault(found) && found == size ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace wander
