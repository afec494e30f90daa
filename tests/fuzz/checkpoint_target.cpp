#include "lab/checkpoint.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "lab/packing.h"
#include "records/seal.h"
#include "tests/fuzz/own_version.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

namespace {

// FORMAT "\n" HEADER "\n" STATE SIZE: the state is packed here, and the whole sealed.
std::string file_of(std::string_view input) {
  const std::string text = of_this_version(input);
  const std::size_t header = std::min(text.find('\n'), text.size() - 1) + 1;
  const std::size_t state = std::min(text.find('\n', header), text.size() - 1) + 1;
  const std::size_t size =
      std::max(state, text.size() - std::min(text.size(), sizeof(std::uint64_t)));
  std::string file = text.substr(0, state);
  const ByteSink sink = [&file](std::string_view piece) { file += piece; };
  Packing packing(sink);
  packing.add(std::string_view(text).substr(state, size - state));
  packing.end();
  return sealed(file + text.substr(size));
}

}  // namespace

const Target checkpoint_target{
    "checkpoint", [](std::string_view bytes, const std::filesystem::path& folder) {
      write_bytes(checkpoint_in(folder), bytes.empty() ? std::string() : file_of(bytes));
      read_checkpoint(folder, "compute the run anew");
    }};

}  // namespace wander::fuzz
