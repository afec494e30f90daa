// Figures in a page: SVG documents that become elements of it, each with a caption.
#pragma once

#include <string>
#include <string_view>

#include "draw/report/html.h"

namespace wander::report {

// The <svg> element of a document that draw/figure made, its ids behind a prefix so that several
// can stand in one page, and named by its own title and description for screen readers.
std::string embedded(std::string_view svg_document, const std::string& prefix);

// All colours of charts follow the page, dark or light.  Pictures keep their tones and what is
// drawn on these; axes, legends and ground follow the page.
enum class Ground { page, paper };
// As wide as the page, or a column of it.
enum class Breadth { page, column };

// The caption says what is shown and how to read it.
void write_figure(Html& html, std::string_view svg_document, std::string_view caption,
                  Ground ground = Ground::page, Breadth breadth = Breadth::page);

}  // namespace wander::report
