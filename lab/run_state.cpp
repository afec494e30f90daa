#include "lab/run_state.h"

#include <cereal/archives/binary.hpp>
#include <new>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <utility>

namespace wander {

namespace {

// A string that is read without being copied.
class Bytes : public std::streambuf {
 public:
  explicit Bytes(const std::string& text) {
    char* begin = const_cast<char*>(text.data());  // a buffer to read from is not written to
    setg(begin, begin, begin + text.size());
  }
};

// For what a whole state becomes in memory: about its own size.
bool is_room_for(std::size_t bytes) {
  constexpr std::size_t times = 4;
  void* room = ::operator new(bytes* times, std::nothrow);
  ::operator delete(room);
  return room != nullptr;
}

}  // namespace

void write_state(const LiveRun& run, std::ostream& bytes) {
  cereal::BinaryOutputArchive archive(bytes);
  run.save(archive);
}

std::string state_of(const LiveRun& run) {
  std::ostringstream bytes;
  write_state(run, bytes);
  return std::move(bytes).str();
}

void restore(LiveRun& run, const std::string& state) {
  Bytes buffer(state);
  std::istream bytes(&buffer);
  cereal::BinaryInputArchive archive(bytes);
  run.make_room();
  try {
    run.load(archive);
  } catch (const std::bad_alloc&) {
    if (!is_room_for(state.size())) throw;
    throw std::runtime_error("it promises more than it holds");
  } catch (const std::exception&) {  // whose words are those of a library
    throw std::runtime_error("it ends too early, or promises more than it holds");
  }
  if (bytes.peek() != std::istream::traits_type::eof())
    throw std::runtime_error("the state of a run has bytes that are not its own");
}

}  // namespace wander
