// The file of a figure: SVG, PNG or PDF, as its name ends.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace wander {

enum class FigureForm { svg, png, pdf };

struct FigureFile {
  std::filesystem::path path;
  FigureForm form = FigureForm::svg;
  double dpi = 300;  // of PNG
};

// A pipe or device has no ending, and takes SVG.  Throws UsageError where the ending is another or
// `dpi` is said of a file without pixels; `also` ends the list of what is allowed.
FigureFile figure_file(const std::filesystem::path& path, std::optional<double> dpi,
                       std::string_view also = "");

// The one place where a figure is written.
void write_figure(const FigureFile& file, std::string_view svg_document);

}  // namespace wander
