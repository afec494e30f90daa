// GCC 12 warns without cause in what valijson inlines: of std::regex when it sanitizes, of
// std::string::replace at -O3.  For the whole file: templates are instantiated at its end.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wrestrict"
#endif

#include "tests/support/schema_verdict.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace wander::test {

bool conforms(const JsonDocument& document, const char* schema_text) {
  using valijson::adapters::NlohmannJsonAdapter;
  const auto schema_json = nlohmann::json::parse(schema_text);
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(schema_json), schema);
  // valijson knows no ordered_json.  Without a list of results it stops at the first fault.
  const nlohmann::json target(*document.root().value);
  return valijson::Validator().validate(schema, NlohmannJsonAdapter(target), nullptr);
}

}  // namespace wander::test
