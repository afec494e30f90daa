#include "draw/report/html.h"

#include <fmt/format.h>

namespace wander::report {

Html::Scope Html::open(std::string_view tag, figure::Attributes attributes) {
  begin(tag, attributes);
  return {*this, tag};
}

void Html::element(std::string_view tag, std::string_view text, figure::Attributes attributes) {
  begin(tag, attributes);
  out_ += fmt::format("{}</{}>\n", figure::escaped(text), tag);
}

void Html::begin(std::string_view tag, figure::Attributes attributes) {
  out_ += fmt::format("<{}", tag);
  for (const figure::Attribute& attribute : attributes)
    out_ += fmt::format(" {}=\"{}\"", attribute.name, figure::escaped(attribute.value));
  out_ += '>';
}

}  // namespace wander::report
