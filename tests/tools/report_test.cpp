// The report of a comparison: one page that any parser reads, whatever was measured.
#include "tools/report/report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "tests/tools/comparison_maker.h"
#include "tests/tools/figure_checks.h"

namespace wander {
namespace {

using compare::Comparison;

const Comparison& usual() {
  static const Comparison made = test::make_comparison({});
  return made;
}

TEST(Report, X) {
  if (const char* out = std::getenv("REPORT_OUT")) {
    std::string o = out;
    const auto save = [&](const std::string& name, const Comparison& c) {
      std::ofstream(o + "/" + name + ".html") << report_html(c);
    };
    Comparison a = test::make_comparison({"gallery:mirror-dish", {"mlt", "bdpt", "pssmlt", "mmlt", "pt", "lt"}, {20000, 80000}, 4});
    save("six", a);
    save("usual", usual());
    save("one", test::make_comparison({"gallery:article-1", {"mlt"}, {20000}, 1}));
    save("bdpt", test::make_comparison({"gallery:article-1", {"bdpt"}, {20000}, 2}));
    save("large", test::repeated(test::with_bins(a, 100), 8, 6, 16));
    save("bins1", test::with_bins(usual(), 1));
    save("bins1000", test::with_bins(a, 1000));
  }
}

}  // namespace
}  // namespace wander
