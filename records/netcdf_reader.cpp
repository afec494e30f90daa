#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <sstream>

#include "records/netcdf.h"
#include "scenes/format/json_text.h"

namespace wander::netcdf {

namespace {

const char* words_of(int status) {
  switch (status) {
    case NC_ENOTVAR:
    case NC_ENOTATT:
    case NC_EBADDIM:
    case NC_ENOGRP:
      return "it is missing";
    case NC_ECHAR:
    case NC_EBADTYPE:
      return "it is of another kind";
    case NC_ERANGE:
      return "a number in it is too large";
    case NC_ENOTNC:
      return "it is not in this format";
    case NC_ENOMEM:
      return "there is no memory for it";
    default:
      return "it is damaged, or cannot be written";
  }
}

}  // namespace

void check(int status, std::string_view what) {
  if (status != NC_NOERR) throw Error(fmt::format("{}: {}", printable(what), words_of(status)));
}

namespace {

// A file that claims more than this is not believed.
constexpr std::size_t most_values = std::size_t{1} << 33;

std::string text_of(int group, int variable, const char* name) {
  std::size_t length = 0;
  nc_type type{};
  check(nc_inq_att(group, variable, name, &type, &length), name);
  if (type == NC_STRING && length == 1) {
    char* begin = nullptr;
    check(nc_get_att_string(group, variable, name, &begin), name);
    std::string text = begin ? begin : "";
    nc_free_string(1, &begin);
    return text;
  }
  if (type != NC_CHAR) throw Error(fmt::format("{}: not a text", name));
  std::string text(length, '\0');
  check(nc_get_att_text(group, variable, name, text.data()), name);
  return text;
}

nc_type type_of(int group, const std::string& attribute) {
  nc_type type{};
  check(nc_inq_atttype(group, NC_GLOBAL, attribute.c_str(), &type), attribute);
  return type;
}

void require_one_number(int group, const std::string& name) {
  std::size_t length = 0;
  nc_type type{};
  check(nc_inq_att(group, NC_GLOBAL, name.c_str(), &type, &length), name);
  if (length != 1) throw Error(fmt::format("{}: not one number", name));
}

}  // namespace

Reader::Reader(std::string_view bytes) : file_bytes_(bytes.size()) {
  // The library only reads from memory that it is given.
  void* memory = const_cast<char*>(bytes.data());
  check(nc_open_mem("wanderlight", NC_NOWRITE, bytes.size(), memory, &id_), "the file");
}

Reader::~Reader() { nc_close(id_); }

Reader::Group Reader::Group::group(const std::string& name) const {
  int id = -1;
  check(nc_inq_grp_ncid(id_, name.c_str(), &id), name);
  return Group(id, file_bytes_);
}

bool Reader::Group::has_group(const std::string& name) const {
  int id = -1;
  return nc_inq_grp_ncid(id_, name.c_str(), &id) == NC_NOERR;
}

bool Reader::Group::has_variable(const std::string& name) const {
  int id = -1;
  return nc_inq_varid(id_, name.c_str(), &id) == NC_NOERR;
}

std::vector<std::string> Reader::Group::variables() const {
  int count = 0;
  check(nc_inq_nvars(id_, &count), "the variables");
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_varname(id_, id, name), "the variables");
    names.emplace_back(name);
  }
  return names;
}

std::vector<std::string> Reader::Group::attributes() const {
  int count = 0;
  check(nc_inq_natts(id_, &count), "the attributes");
  std::vector<std::string> names;
  for (int k = 0; k < count; ++k) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_attname(id_, NC_GLOBAL, k, name), "the attributes");
    names.emplace_back(name);
  }
  return names;
}

std::vector<std::size_t> Reader::Group::lengths(const std::string& variable) const {
  int id = -1, count = 0;
  check(nc_inq_varid(id_, variable.c_str(), &id), variable);
  check(nc_inq_varndims(id_, id, &count), variable);
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check(nc_inq_vardimid(id_, id, dimensions.data()), variable);
  std::vector<std::size_t> lengths;
  for (const int dimension : dimensions)
    check(nc_inq_dimlen(id_, dimension, &lengths.emplace_back()), variable);
  return lengths;
}

std::size_t Reader::Group::dimension(const std::string& name) const {
  int id = -1;
  std::size_t length = 0;
  check(nc_inq_dimid(id_, name.c_str(), &id), name);
  check(nc_inq_dimlen(id_, id, &length), name);
  return length;
}

std::string Reader::Group::text(const std::string& name) const {
  return text_of(id_, NC_GLOBAL, name.c_str());
}

bool Reader::Group::is_text(const std::string& name) const {
  const nc_type type = type_of(id_, name);
  return type == NC_CHAR || type == NC_STRING;
}
bool Reader::Group::is_whole(const std::string& name) const {
  const nc_type type = type_of(id_, name);
  return type != NC_CHAR && type != NC_STRING && type != NC_FLOAT && type != NC_DOUBLE;
}

bool Reader::Group::has(const std::string& name) const {
  int index = 0;
  return nc_inq_attid(id_, NC_GLOBAL, name.c_str(), &index) == NC_NOERR;
}

double Reader::Group::number(const std::string& name) const {
  double value = 0;
  require_one_number(id_, name);
  check(nc_get_att_double(id_, NC_GLOBAL, name.c_str(), &value), name);
  return value;
}

std::uint64_t Reader::Group::count(const std::string& name) const {
  unsigned long long value = 0;
  require_one_number(id_, name);
  check(nc_get_att_ulonglong(id_, NC_GLOBAL, name.c_str(), &value), name);
  return value;
}

void Reader::Group::require_room(const std::string& name, double bytes) const {
  constexpr double best_compression = 2048;  // more than deflate reaches
  if (bytes > best_compression * static_cast<double>(file_bytes_))
    throw Error(fmt::format("{}: the file is too small to hold it", printable(name)));
}

int Reader::Group::variable(const std::string& name, std::size_t size,
                            std::size_t bytes_each) const {
  std::size_t held = 1;
  for (const std::size_t length : lengths(name)) {
    if (length > most_values || held * length > most_values)
      throw Error(fmt::format("{}: too many values", name));
    held *= length;
  }
  if (held != size)
    throw Error(fmt::format("{}: it holds {} values, expected are {}", name, held, size));
  require_room(name, static_cast<double>(held) * static_cast<double>(bytes_each));
  int id = -1;
  check(nc_inq_varid(id_, name.c_str(), &id), name);
  return id;
}

void Reader::Group::read(const std::string& name, std::size_t size,
                         std::vector<double>& values) const {
  const int id = variable(name, size, sizeof values[0]);
  values.resize(size);
  check(nc_get_var_double(id_, id, values.data()), name);
}
void Reader::Group::read(const std::string& name, std::size_t size,
                         std::vector<std::int32_t>& values) const {
  const int id = variable(name, size, sizeof values[0]);
  values.resize(size);
  check(nc_get_var_int(id_, id, values.data()), name);
}
void Reader::Group::read(const std::string& name, std::size_t size,
                         std::vector<std::uint8_t>& values) const {
  const int id = variable(name, size, sizeof values[0]);
  values.resize(size);
  check(nc_get_var_uchar(id_, id, values.data()), name);
}

void Reader::Group::read_part(const std::string& name, std::size_t first, std::size_t count,
                              std::vector<double>& values) const {
  int id = -1;
  check(nc_inq_varid(id_, name.c_str(), &id), name);
  std::vector<std::size_t> counts = lengths(name), start(counts.size());
  if (counts.empty()) throw Error(fmt::format("{}: it has no parts", name));
  start[0] = first;
  counts[0] = count;
  std::size_t size = 1;
  double bytes = sizeof values[0];
  for (const std::size_t length : counts) {
    bytes *= static_cast<double>(length);
    size *= length;
  }
  require_room(name, bytes);
  values.resize(size);
  check(nc_get_vara_double(id_, id, start.data(), counts.data(), values.data()), name);
}

std::vector<std::string> Reader::Group::words(const std::string& variable) const {
  int id = -1;
  check(nc_inq_varid(id_, variable.c_str(), &id), variable);
  std::istringstream meanings(text_of(id_, id, "flag_meanings"));
  std::vector<std::string> words;
  for (std::string word; meanings >> word;) words.push_back(word);
  return words;
}

}  // namespace wander::netcdf
