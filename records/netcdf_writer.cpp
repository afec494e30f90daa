#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <numeric>

#include "records/netcdf.h"

namespace wander::netcdf {

namespace {

constexpr std::size_t first_size = 1 << 16;

// HDF5 keeps an attribute in the header of its group, which has room for 64 KB; a string, NC_STRING, lies elsewhere, and may be of any
// length.
constexpr std::size_t longest_in_header = 1 << 15;

// The file grows by being copied, and each variable has parts of its own that wait for it.  Much is
// not asked for: it becomes smaller, and a run that needs much memory has looked before it began.
void require_memory(std::size_t bytes) {
  constexpr std::size_t copies = 4, beside = 24 << 20, much = 32 << 20;
  ::operator delete(::operator new(copies* std::min(bytes, much) + beside));
}

}  // namespace

Writer Writer::create(std::size_t bytes) {
  require_memory(bytes);
  int id = -1;
  check(nc_create_mem("wanderlight", NC_NETCDF4, first_size, &id), "a file in memory");
  return Writer(id);
}

Writer Writer::group(const std::string& name) const {
  int id = -1;
  check(nc_def_grp(id_, name.c_str(), &id), name);
  return Writer(id);
}

void Writer::dimension(const std::string& name, std::size_t length) const {
  int id = -1;
  check(nc_def_dim(id_, name.c_str(), length, &id), name);
}

void Writer::attribute(const std::string& name, std::string_view text) const {
  if (text.size() <= longest_in_header) {
    check(nc_put_att_text(id_, NC_GLOBAL, name.c_str(), text.size(), text.data()), name);
  } else {
    const std::string ended(text);
    const char* begin = ended.c_str();
    check(nc_put_att_string(id_, NC_GLOBAL, name.c_str(), 1, &begin), name);
  }
}
void Writer::attribute(const std::string& name, double value) const {
  check(nc_put_att_double(id_, NC_GLOBAL, name.c_str(), NC_DOUBLE, 1, &value), name);
}
void Writer::attribute(const std::string& name, std::int64_t value) const {
  const long long number = value;
  check(nc_put_att_longlong(id_, NC_GLOBAL, name.c_str(), NC_INT64, 1, &number), name);
}
void Writer::attribute(const std::string& name, std::uint64_t value) const {
  const unsigned long long number = value;
  check(nc_put_att_ulonglong(id_, NC_GLOBAL, name.c_str(), NC_UINT64, 1, &number), name);
}

int Writer::define(const std::string& name, const Dimensions& dimensions, int type,
                   std::string_view meaning) const {
  std::vector<int> ids;
  for (const std::string& dimension : dimensions)
    check(nc_inq_dimid(id_, dimension.c_str(), &ids.emplace_back()), dimension);
  int id = -1;
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(ids.size()), ids.data(), &id), name);
  if (!ids.empty()) check(nc_def_var_deflate(id_, id, 1, 1, 1), name);  // shuffled, level 1
  check(nc_put_att_text(id_, id, "long_name", meaning.size(), meaning.data()), name);
  return id;
}

void Writer::variable(const std::string& name, const Dimensions& dimensions,
                      std::span<const double> values, std::string_view meaning) const {
  const int id = define(name, dimensions, NC_DOUBLE, meaning);
  check(nc_put_var_double(id_, id, values.data()), name);
}
void Writer::variable(const std::string& name, const Dimensions& dimensions,
                      std::span<const std::int32_t> values, std::string_view meaning) const {
  const int id = define(name, dimensions, NC_INT, meaning);
  check(nc_put_var_int(id_, id, values.data()), name);
}
void Writer::variable(const std::string& name, const Dimensions& dimensions,
                      std::span<const std::int64_t> values, std::string_view meaning) const {
  const int id = define(name, dimensions, NC_INT64, meaning);
  const std::vector<long long> numbers(values.begin(), values.end());
  check(nc_put_var_longlong(id_, id, numbers.data()), name);
}
void Writer::flags(const std::string& name, const Dimensions& dimensions,
                   std::span<const std::uint8_t> values, std::string_view meaning) const {
  const int id = define(name, dimensions, NC_BYTE, meaning);
  check(nc_put_att_text(id_, id, "dtype", 4, "bool"), name);
  check(nc_put_var_uchar(id_, id, values.data()), name);
}
void Writer::variable(const std::string& name, const Dimensions& dimensions,
                      std::span<const std::int32_t> values, std::span<const std::string> words,
                      std::string_view meaning) const {
  const int id = define(name, dimensions, NC_INT, meaning);
  std::vector<int> numbers(words.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  check(nc_put_att_int(id_, id, "flag_values", NC_INT, numbers.size(), numbers.data()), name);
  const std::string meanings = fmt::format("{}", fmt::join(words, " "));
  check(nc_put_att_text(id_, id, "flag_meanings", meanings.size(), meanings.data()), name);
  check(nc_put_var_int(id_, id, values.data()), name);
}

void Writer::names(const std::string& name, const std::string& dimension,
                   std::span<const std::string_view> values, std::string_view meaning) const {
  int id = -1, of = -1;
  check(nc_inq_dimid(id_, dimension.c_str(), &of), dimension);
  check(nc_def_var(id_, name.c_str(), NC_STRING, 1, &of, &id), name);
  check(nc_put_att_text(id_, id, "long_name", meaning.size(), meaning.data()), name);
  const std::vector<std::string> texts(values.begin(), values.end());
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  check(nc_put_var_string(id_, id, pointers.data()), name);
}

Writer::Parts Writer::parts(const std::string& name, const Dimensions& dimensions,
                            const std::vector<std::size_t>& chunk, int type,
                            std::string_view meaning) const {
  const int id = define(name, dimensions, type, meaning);
  check(nc_def_var_chunking(id_, id, NC_CHUNKED, chunk.data()), name);
  check(nc_def_var_fill(id_, id, NC_NOFILL, nullptr), name);  // every place is written
  std::vector<std::size_t> lengths;
  for (const std::string& dimension : dimensions) {
    int of = -1;
    check(nc_inq_dimid(id_, dimension.c_str(), &of), dimension);
    check(nc_inq_dimlen(id_, of, &lengths.emplace_back()), dimension);
  }
  return {id_, id, std::move(lengths)};
}
Writer::Parts Writer::numbers_in_parts(const std::string& name, const Dimensions& dimensions,
                                       const std::vector<std::size_t>& chunk,
                                       std::string_view meaning) const {
  return parts(name, dimensions, chunk, NC_DOUBLE, meaning);
}
Writer::Parts Writer::flags_in_parts(const std::string& name, const Dimensions& dimensions,
                                     const std::vector<std::size_t>& chunk,
                                     std::string_view meaning) const {
  Parts flags = parts(name, dimensions, chunk, NC_BYTE, meaning);
  int id = -1;
  check(nc_inq_varid(id_, name.c_str(), &id), name);
  check(nc_put_att_text(id_, id, "dtype", 4, "bool"), name);
  return flags;
}

void Writer::Parts::put(std::size_t first, std::size_t count,
                        std::span<const double> values) const {
  std::vector<std::size_t> start(lengths_.size()), counts = lengths_;
  start[0] = first;
  counts[0] = count;
  check(nc_put_vara_double(file_, id_, start.data(), counts.data(), values.data()), "a variable");
}

void Writer::take(const std::function<void(std::string_view)>& file) {
  NC_memio memory{};
  check(nc_close_memio(id_, &memory), "the end of a file in memory");
  const std::unique_ptr<void, void (*)(void*)> owned(memory.memory, std::free);
  file({static_cast<const char*>(memory.memory), memory.size});
}

std::string Writer::take() {
  std::string bytes;
  take([&](std::string_view whole) { bytes = whole; });
  return bytes;
}

}  // namespace wander::netcdf
