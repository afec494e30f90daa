// Numbers as people write them, wherever one is read and not typed: in summaries, tables, warnings
// and on the axes of figures.  Input, JSON and tables of full precision keep what a program reads.
#pragma once

#include <string>

namespace wander {

// So many significant digits, without the zeros that end them: "1470", "0.5", "3.2·10⁻⁵", "−2".
// Plain from 0.0001 up to ten million; "unknown" and "∞" for what is not finite.
std::string number_text(double value, int digits = 3);

std::string superscript(int value);  // "⁻¹²"

}  // namespace wander
