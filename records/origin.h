// What made a result beside the command: the build of the program, the machine and the time.  These
// are facts of the execution, which two runs with the same bits need not share.
#pragma once

#include <array>
#include <string>

namespace wander {

struct Origin {
  std::string commit;      // of the source, "+changes" where files differ; or "unknown"
  std::string compiler;    // "GNU 12.2.0"
  std::string build_type;  // "Release"
  std::string cpu;         // the model, as the machine says
  std::string date;        // of the execution: UTC, ISO 8601
};

// By the names that every output uses.
struct OriginField {
  const char* name;
  std::string Origin::*member;
};
inline constexpr std::array origin_fields{
    OriginField{"commit", &Origin::commit}, OriginField{"compiler", &Origin::compiler},
    OriginField{"build_type", &Origin::build_type}, OriginField{"cpu", &Origin::cpu},
    OriginField{"date", &Origin::date}};

// Of what this process makes now.
Origin origin_here();

}  // namespace wander
