// Figures as others take them: an SVG document as a PNG image or as a page of PDF, drawn by librsvg
// and Cairo.
#pragma once

#include <string>
#include <string_view>

#include "draw/figure/svg.h"

namespace wander::figure {

// In points, as the document says.  Throws std::runtime_error if it is none.
Vector size_of(std::string_view svg_document);

// Opaque, with `dpi` pixels to the inch and a note of that: placed on a page, the image is as large
// as the figure.
std::string to_png(std::string_view svg_document, double dpi);

// One page of the size of the figure, without a date: the same figure gives the same bytes.
std::string to_pdf(std::string_view svg_document);

// Neither side of an image may have more pixels.
inline constexpr double most_pixels = 32767;

}  // namespace wander::figure
