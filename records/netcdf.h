// netCDF-4 in memory, so that the disk is touched by atomic_file.h alone: libnetcdf tells of a full
// disk only when it closes a file, and may end the process afterwards.  Not for several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wander::netcdf {

// what() = "VARIABLE: what is wrong", not in the words of the library
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws Error unless `status`, of a call of the library, says that all is well.
void check(int status, std::string_view what);

// A file or one of its groups, that is written.  Names of dimensions are looked up in the group.
class Writer {
 public:
  // An empty file, for about so many bytes of numbers; take() ends it.  Throws std::bad_alloc where
  // they would not fit: the library does not live through that.
  static Writer create(std::size_t bytes);

  Writer group(const std::string& name) const;
  void dimension(const std::string& name, std::size_t length) const;

  void attribute(const std::string& name, std::string_view text) const;
  void attribute(const std::string& name, double value) const;
  void attribute(const std::string& name, std::int64_t value) const;
  void attribute(const std::string& name, std::uint64_t value) const;

  using Dimensions = std::vector<std::string>;
  // Values in the order of the dimensions, the last fastest; `meaning` becomes long_name.
  void variable(const std::string& name, const Dimensions& dimensions,
                std::span<const double> values, std::string_view meaning) const;
  void variable(const std::string& name, const Dimensions& dimensions,
                std::span<const std::int32_t> values, std::string_view meaning) const;
  void variable(const std::string& name, const Dimensions& dimensions,
                std::span<const std::int64_t> values, std::string_view meaning) const;
  // Zero and one, in the form that xarray reads as false and true.
  void flags(const std::string& name, const Dimensions& dimensions,
             std::span<const std::uint8_t> values, std::string_view meaning) const;
  // Value i stands for word i: CF's flag_values and flag_meanings.
  void variable(const std::string& name, const Dimensions& dimensions,
                std::span<const std::int32_t> values, std::span<const std::string> words,
                std::string_view meaning) const;
  // Texts, one for each place along a dimension.
  void names(const std::string& name, const std::string& dimension,
             std::span<const std::string_view> values, std::string_view meaning) const;

  // A variable that is written in parts along its first dimension, in chunks of `chunk` places.
  class Parts {
   public:
    Parts(int file, int id, std::vector<std::size_t> lengths)
        : file_(file), id_(id), lengths_(std::move(lengths)) {}
    // `count` places from `first` on.
    void put(std::size_t first, std::size_t count, std::span<const double> values) const;

   private:
    int file_, id_;
    std::vector<std::size_t> lengths_;  // of the dimensions
  };
  Parts numbers_in_parts(const std::string& name, const Dimensions& dimensions,
                         const std::vector<std::size_t>& chunk, std::string_view meaning) const;
  // Zero and one; see flags().
  Parts flags_in_parts(const std::string& name, const Dimensions& dimensions,
                       const std::vector<std::size_t>& chunk, std::string_view meaning) const;

  std::string take();  // the bytes of the whole file
  // The same where they are handed on: they are not held twice.
  void take(const std::function<void(std::string_view)>& file);

 private:
  explicit Writer(int id) : id_(id) {}
  Parts parts(const std::string& name, const Dimensions& dimensions,
              const std::vector<std::size_t>& chunk, int type, std::string_view meaning) const;
  int define(const std::string& name, const Dimensions& dimensions, int type,
             std::string_view meaning) const;

  int id_;
};

// A file or one of its groups, that is read.  Every fault throws Error.
class Reader {
 public:
  // The bytes outlive the reader and all its groups.
  explicit Reader(std::string_view bytes);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  class Group {
   public:
    // In a file of so many bytes.
    Group(int id, std::size_t file_bytes) : id_(id), file_bytes_(file_bytes) {}

    Group group(const std::string& name) const;
    bool has_group(const std::string& name) const;
    bool has_variable(const std::string& name) const;
    std::vector<std::string> variables() const;   // their names
    std::vector<std::string> attributes() const;  // likewise
    // How long the dimensions of a variable are.
    std::vector<std::size_t> lengths(const std::string& variable) const;
    std::size_t dimension(const std::string& name) const;

    std::string text(const std::string& name) const;
    bool is_text(const std::string& name) const;
    bool is_whole(const std::string& name) const;  // such a number
    bool has(const std::string& name) const;       // such an attribute
    double number(const std::string& name) const;
    std::uint64_t count(const std::string& name) const;

    // Throws where the file is too small to hold so many bytes, however they are compressed: what is
    // promised costs no memory.
    void require_room(const std::string& name, double bytes) const;
    // The variable must hold exactly so many values.
    void read(const std::string& name, std::size_t size, std::vector<double>& values) const;
    void read(const std::string& name, std::size_t size, std::vector<std::int32_t>& values) const;
    void read(const std::string& name, std::size_t size, std::vector<std::uint8_t>& values) const;
    std::vector<std::string> words(const std::string& variable) const;  // flag_meanings
    // `count` places from `first` on, along the first dimension.
    void read_part(const std::string& name, std::size_t first, std::size_t count,
                   std::vector<double>& values) const;

   private:
    int variable(const std::string& name, std::size_t size, std::size_t bytes_each) const;
    int id_;
    std::size_t file_bytes_;
  };
  Group root() const { return Group(id_, file_bytes_); }

 private:
  int id_ = -1;
  std::size_t file_bytes_;
};

}  // namespace wander::netcdf
