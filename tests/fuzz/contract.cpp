#include "tests/fuzz/contract.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <typeinfo>

#include "lab/failure.h"
#include "records/run_record.h"
#include "scenes/format/json_text.h"
#include "scenes/format/scene_file.h"
#include "scenes/import/import_fault.h"

namespace wander::fuzz {

namespace {

namespace fs = std::filesystem;

// By what the words of libraries are known.
constexpr std::array<std::string_view, 42> library_words{
    // nlohmann, cereal, fmt
    "json.exception", "bytes from input stream", "argument not found",
    // libstdc++
    "std::", "basic_string", "vector::", "stoul", "stoi", "stod", "bad_alloc", "bad_optional",
    "map::at", "_M_", "filesystem error", "basic_ios", "length_error", "variant",
    // netCDF and HDF5
    "NetCDF", "HDF", "H5", "NC_",
    // OpenEXR
    "OpenEXR", "EXR", "image file \"", "Error reading", "Cannot read", "Unexpected end of file",
    "Iex", "Imf", "data window", "scanline", "header attribute",
    // libpng, zlib
    "libpng", "CRC", "IHDR", "IDAT", "PLTE", "Read Error", "incorrect header check",
    // pugixml
    "Error parsing", "mismatch", "No document element"};

// In memory where there is such a place; gone with the process.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    std::error_code none;
    const fs::path parent = fs::is_directory(memory, none) ? memory : fs::temp_directory_path();
    path_ = parent / fmt::format("wanderlight-fuzz-{}", getpid());
    fs::create_directory(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Those that tools/failure_report.cpp turns into exit code 3.
bool is_of_a_file(const std::exception& problem) {
  if (const auto* failure = dynamic_cast<const CommandFailure*>(&problem))
    return failure->code() == ExitCode::invalid_input;
  return dynamic_cast<const SceneFileError*>(&problem) != nullptr ||
         dynamic_cast<const ImportError*>(&problem) != nullptr ||
         dynamic_cast<const RunFileError*>(&problem) != nullptr;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

std::optional<std::string> fault_of_line(const std::string& line, const fs::path& folder) {
  const std::string beginning = folder.string() + "/";
  if (!line.starts_with(beginning) || line.find(": ") == line.npos ||
      line.find(':') > line.find(' '))
    return "it does not begin with its file";
  if (first_bad_byte(line)) return "it is not in UTF-8";
  if (std::ranges::any_of(line, is_control)) return "it has control characters";
  return std::nullopt;
}

// In what a target made of its input: some are sealed, or packed.
bool is_in_a_file(std::string_view word, const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    if (bytes.view().find(word) != std::string_view::npos) return true;
  }
  return false;
}

// A byte is shown as \xcb, and its last letter belongs to no word after it.
std::string without_shown_bytes(const std::string& message) {
  static const std::regex shown(R"(\\x[0-9a-fA-F]{2})");
  return std::regex_replace(message, shown, "?");
}

// Words that the file itself has may be quoted.
std::optional<std::string> fault_of(const std::string& message, const fs::path& folder) {
  const std::string words = without_shown_bytes(message);
  for (const std::string_view word : library_words)
    if (words.find(word) != words.npos && !is_in_a_file(word, folder))
      return fmt::format("it says '{}', as a library does", word);
  if (message.empty()) return "it says nothing";
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);)
    if (const auto fault = fault_of_line(line, folder)) return fault;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> breach(const Target& target, std::string_view bytes) {
  static const Folder folder;
  try {
    target.read(bytes, folder.path());
  } catch (const std::exception& problem) {
    const std::string message = problem.what();
    if (!is_of_a_file(problem))
      return fmt::format("{}: {} ends the program: {}", target.kind, typeid(problem).name(),
                         message);
    if (const auto fault = fault_of(message, folder.path()))
      return fmt::format("{}: {}: {}", target.kind, *fault, message);
  } catch (...) {
    return fmt::format("{}: what it throws is no exception", target.kind);
  }
  return std::nullopt;
}

void write_bytes(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace wander::fuzz
