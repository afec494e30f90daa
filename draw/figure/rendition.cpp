#include "draw/figure/rendition.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "draw/figure/child_process.h"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig keeps its tables of fonts up to the end of the program.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace wander::figure {
namespace {

constexpr double points_per_inch = 72, metres_per_inch = 0.0254;

template <auto release>
struct Release {
  void operator()(auto* object) const { release(object); }
};
using Document = std::unique_ptr<RsvgHandle, Release<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;

[[noreturn]] void fail(std::string_view what) {
  throw std::runtime_error(fmt::format("the figure cannot be drawn: {}", what));
}

[[noreturn]] void fail(GError* error) {
  const std::string what = error ? error->message : "unknown error";
  g_clear_error(&error);
  fail(what);
}

// A font that cannot be opened is replaced by another, or by none, without a word.
void require_open_files() {
  constexpr int most_of_fonts = 16;
  std::array<int, most_of_fonts> files{};
  int count = 0, reason = 0;
  while (count < most_of_fonts && reason == 0) {
    const int file = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (file < 0)
      reason = errno;
    else
      files[static_cast<std::size_t>(count++)] = file;
  }
  while (count > 0) close(files[static_cast<std::size_t>(--count)]);
  if (reason != 0) fail(std::generic_category().message(reason));
}

// The libraries end a program that lacks memory or threads.
std::string drawn_apart(const std::function<std::string()>& draw) {
  return in_a_child(
      [&] {
        require_open_files();
        return draw();
      },
      "the figure cannot be drawn: the library that draws has given up, as it does where memory or "
      "threads "
      "are short");
}

void require_success(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) fail(cairo_status_to_string(status));
}

// A pixel of the document is a point.
Document open_document(std::string_view svg) {
  GError* error = nullptr;
  Document document(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (!document) fail(error);
  rsvg_handle_set_dpi(document.get(), points_per_inch);
  return document;
}

Vector size_of(const Document& document) {
  Vector size;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(document.get(), &size.x, &size.y))
    fail("the document says no size");
  return size;
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void draw(const Document& document, const Surface& surface, Vector size) {
  const Context context(cairo_create(surface.get()));
  // Pixels at the edge that the paper covers in part are white all the same.
  cairo_set_source_rgb(context.get(), 1, 1, 1);
  cairo_paint(context.get());
  const RsvgRectangle page{0, 0, size.x, size.y};
  GError* error = nullptr;
  if (!rsvg_handle_render_document(document.get(), context.get(), &page, &error)) fail(error);
  require_success(cairo_status(context.get()));
}

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(static_cast<std::uint8_t>(value >> shift));
}

// The chunk pHYs of PNG 1.2, section 11.3.5.3, which Cairo does not write.
std::string resolution_chunk(double dpi) {
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / metres_per_inch));
  std::string typed = "pHYs", chunk;
  append_big_endian(typed, per_metre);
  append_big_endian(typed, per_metre);
  typed += '\1';  // the unit is the metre
  boost::crc_32_type crc;
  crc.process_bytes(typed.data(), typed.size());
  append_big_endian(chunk, static_cast<std::uint32_t>(typed.size() - 4));
  chunk += typed;
  append_big_endian(chunk, crc.checksum());
  return chunk;
}

}  // namespace

Vector size_of(std::string_view svg_document) { return size_of(open_document(svg_document)); }

namespace {

std::string png_of(std::string_view svg_document, double dpi) {
  const Document document = open_document(svg_document);
  const Vector points = size_of(document);
  const auto pixels = [&](double length) {
    return std::clamp(std::round(length * dpi / points_per_inch), 1., most_pixels);
  };
  const Vector size{pixels(points.x), pixels(points.y)};
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.x),
                                                   static_cast<int>(size.y)));
  require_success(cairo_surface_status(surface.get()));
  draw(document, surface, size);
  std::string png;
  require_success(cairo_surface_write_to_png_stream(surface.get(), append, &png));
  // After the signature of 8 bytes and the header chunk of 25, where it has to stand.
  png.insert(8 + 25, resolution_chunk(dpi));
  return png;
}

std::string pdf_of(std::string_view svg_document) {
  const Document document = open_document(svg_document);
  const Vector size = size_of(document);
  std::string pdf;
  {
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &pdf, size.x, size.y));
    require_success(cairo_surface_status(surface.get()));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    draw(document, surface, size);
    cairo_surface_finish(surface.get());
    require_success(cairo_surface_status(surface.get()));
  }
  return pdf;
}

}  // namespace

std::string to_png(std::string_view svg_document, double dpi) {
  return drawn_apart([&] { return png_of(svg_document, dpi); });
}

std::string to_pdf(std::string_view svg_document) {
  return drawn_apart([&] { return pdf_of(svg_document); });
}

}  // namespace wander::figure
