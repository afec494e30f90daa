#include "tools/figure_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "draw/figure/rendition.h"
#include "lab/failure.h"
#include "records/atomic_file.h"
#include "tools/output_place.h"

namespace wander {
namespace {

namespace fs = std::filesystem;

struct Ending {
  std::string_view ending;
  FigureForm form;
};
constexpr std::array endings{Ending{".svg", FigureForm::svg}, Ending{".png", FigureForm::png},
                             Ending{".pdf", FigureForm::pdf}};

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_stream(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return is_standard_output(path) ||
         (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

FigureForm form_of(const fs::path& path, std::string_view also) {
  if (is_stream(path)) return FigureForm::svg;
  const auto found = std::ranges::find(endings, ending_of(path), &Ending::ending);
  if (found != endings.end()) return found->form;
  throw UsageError(
      fmt::format("{}: a figure is SVG, PNG or PDF, and its name ends in .svg, .png "
                  "or .pdf{}",
                  path.string(), also));
}

std::string image(const FigureFile& file, std::string_view svg) {
  const figure::Vector size = figure::size_of(svg) * file.dpi / 72.;
  if (std::max(size.x, size.y) > figure::most_pixels)
    throw UsageError(
        fmt::format("{}: the image would have {:.0f} x {:.0f} pixels; a smaller --dpi "
                    "or --width keeps both below {:.0f}",
                    file.path.string(), size.x, size.y, figure::most_pixels));
  return figure::to_png(svg, file.dpi);
}

}  // namespace

FigureFile figure_file(const fs::path& path, std::optional<double> dpi, std::string_view also) {
  FigureFile file{.path = path, .form = form_of(path, also)};
  if (dpi && file.form != FigureForm::png)
    throw UsageError(fmt::format("--dpi is for FILE.png; {} has no pixels", path.string()));
  file.dpi = dpi.value_or(file.dpi);
  return file;
}

void write_figure(const FigureFile& file, std::string_view svg_document) {
  switch (file.form) {
    case FigureForm::svg:
      return write_output(file.path, svg_document);
    case FigureForm::png:
      return write_file(file.path, image(file, svg_document));
    case FigureForm::pdf:
      return write_file(file.path, figure::to_pdf(svg_document));
  }
}

}  // namespace wander
