#include "lib/rainflow/series/binary.hpp"

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace loadpath::rainflow {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes are taken as they are");

constexpr std::size_t block = std::size_t{1} << 17U;  // bytes

// The system copies from the start of a page: to a few bytes behind the start of another one it takes four times as
// long, for its stores seem to be at the places that are loaded next.
constexpr std::size_t page_size = 4096;
template <class T>
using Pages = std::vector<T, boost::alignment::aligned_allocator<T, page_size>>;

Fault at_byte(std::uint64_t byte, Message message, Message hint = {}) {
  return {byte, 1, std::move(message), std::move(hint)};
}

/// Rows of numbers of one width, of which one column is read.
struct Rows {
  std::size_t width = sizeof(double);
  std::uint64_t columns = 1, column = 0;
  std::uint64_t rows = std::numeric_limits<std::uint64_t>::max();  // number of rows if the file does not state it
  std::uint64_t start = 0;                                         // the byte of the first
};

/// Without an exit from the loop, so that vector registers are used.
bool are_finite(std::span<const double> values) {
  unsigned faults = 0;
  for (const double x : values) faults |= std::abs(x) <= std::numeric_limits<double>::max() ? 0U : 1U;
  return faults == 0;
}

class RowReader final : public Reader {
 public:
  RowReader(std::unique_ptr<Source> source, const Rows& rows)
      : source_(std::move(source)), rows_(rows), row_bytes_(rows.width * rows.columns), byte_(rows.start) {
    const std::size_t rows_at_once = std::max<std::size_t>(block / row_bytes_, 1);
    values_.resize(rows_at_once);
    if (!is_plain()) bytes_.resize(rows_at_once * row_bytes_);
  }

  Outcome<std::span<const double>> next() override {
    const std::uint64_t left = rows_.rows - done_;
    const std::size_t wanted = left < values_.size() ? static_cast<std::size_t>(left) : values_.size();
    char* const room = is_plain() ? reinterpret_cast<char*>(values_.data()) : bytes_.data();
    const auto got = source_->read({room, wanted * row_bytes_});
    if (!got) return got.fault();
    const std::size_t count = *got / row_bytes_;
    if (*got % row_bytes_ != 0 || (count < wanted && is_told())) return cut_off(*got);
    for (std::size_t i = 0; i < count && !is_plain(); ++i)
      values_[i] = value(bytes_.data() + i * row_bytes_ + rows_.column * rows_.width);
    if (!are_finite({values_.data(), count})) {
      for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(values_[i])) return not_finite(i);
      }
    }
    done_ += count, byte_ += *got;
    return std::span<const double>(values_.data(), count);
  }

 private:
  /// The bytes of the file are the values.
  [[nodiscard]] bool is_plain() const { return row_bytes_ == sizeof(double); }
  [[nodiscard]] bool is_told() const { return rows_.rows != Rows{}.rows; }
  [[nodiscard]] double value(const char* from) const {
    if (rows_.width == sizeof(double)) {
      double x = 0.0;
      std::memcpy(&x, from, sizeof x);
      return x;
    }
    float x = 0.0F;
    std::memcpy(&x, from, sizeof x);
    return x;
  }
  [[nodiscard]] Fault not_finite(std::size_t i) const {
    const std::uint64_t byte = byte_ + i * row_bytes_ + rows_.column * rows_.width;
    return at_byte(
        byte, say("byte {1}: value {2} is not a finite number", std::to_string(byte), std::to_string(done_ + i + 1)));
  }
  [[nodiscard]] Fault cut_off(std::size_t got) const {
    const std::uint64_t end = byte_ + got;
    const std::string byte = std::to_string(end);
    if (is_told())
      return at_byte(end, say("byte {1}: the file ends after {2} of {3} rows", byte,
                              std::to_string(done_ + got / row_bytes_), std::to_string(rows_.rows)));
    return at_byte(end, say("byte {1}: the file ends within a number of {2} bytes", byte, std::to_string(rows_.width)),
                   say("does it have the other width, float64 or float32?"));
  }

  std::unique_ptr<Source> source_;
  Rows rows_;
  std::size_t row_bytes_;
  std::uint64_t byte_, done_ = 0;
  Pages<char> bytes_;
  Pages<double> values_;
};

/// The text after 'key': in the header of an array, a dictionary of Python on one line.
std::string_view entry(std::string_view header, std::string_view key) {
  const std::size_t at = header.find("'" + std::string(key) + "'");
  if (at == std::string_view::npos) return {};
  std::size_t from = header.find(':', at);
  if (from == std::string_view::npos) return {};
  from = header.find_first_not_of(' ', from + 1);
  if (from == std::string_view::npos) return {};
  const std::size_t to = header[from] == '(' ? header.find(')', from) : header.find_first_of(",}", from);
  return header.substr(from, to == std::string_view::npos ? to : to - from);
}

/// The numbers of "(1000, 3" or "(1000,", in any number; nothing for any other text.
std::optional<std::vector<std::uint64_t>> shape_of(std::string_view text) {
  std::vector<std::uint64_t> shape;
  if (!text.starts_with('(')) return std::nullopt;
  text.remove_prefix(1);
  while (!text.empty()) {
    std::uint64_t size = 0;
    const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc{}) return std::nullopt;
    shape.push_back(size);
    text.remove_prefix(static_cast<std::size_t>(behind - text.data()));
    if (!text.empty() && text.front() != ',') return std::nullopt;
    text.remove_prefix(std::min(text.find_first_not_of(' ', 1), text.size()));
  }
  return shape;
}

std::optional<Fault> choose_column(Rows& rows, const std::string& column) {
  if (column.empty() && rows.columns == 1) return std::nullopt;
  std::uint64_t number = 0;
  const auto [behind, error] = std::from_chars(column.data(), column.data() + column.size(), number);
  const bool is_number = error == std::errc{} && behind == column.data() + column.size();
  if (is_number && number >= 1 && number <= rows.columns) {
    rows.column = number - 1;
    return std::nullopt;
  }
  const std::string columns = std::to_string(rows.columns);
  if (column.empty()) return at_byte(0, say("the array has {1} columns: state which, by its number from 1", columns));
  return at_byte(0, say("column '{1}' is not one of the array's {2}, counted from 1", column, columns));
}

Outcome<Rows> rows_of(std::string_view header, const std::string& column) {
  Rows rows;
  const std::string_view type = entry(header, "descr");
  if (type != "'<f8'" && type != "'<f4'")
    return at_byte(0, say("the numbers of the array are {1}; float64 and float32, little-endian, are read", type),
                   say("in NumPy: numpy.save(path, x.astype('<f8'))"));
  rows.width = type == "'<f8'" ? sizeof(double) : sizeof(float);
  const std::string_view text = entry(header, "shape");
  const auto numbers = shape_of(text);
  if (!numbers) return at_byte(0, say("'{1})' is not a shape of an array", text));
  const auto& shape = *numbers;
  if (shape.empty() || shape.size() > 2)
    return at_byte(0, say("the array has {1} dimensions; one or two are read", std::to_string(shape.size())));
  rows.rows = shape[0], rows.columns = shape.size() == 2 ? shape[1] : 1;
  constexpr std::uint64_t most_columns = 1U << 16U;
  if (rows.columns == 0 || rows.columns > most_columns)
    return at_byte(0, say("the array has {1} columns; 1 to 65536 are read", std::to_string(rows.columns)));
  if (entry(header, "fortran_order") != "False" && shape.size() == 2)
    return at_byte(0, say("the array is in Fortran's order, column after column; C order is read"),
                   say("in NumPy: numpy.save(path, numpy.ascontiguousarray(x))"));
  if (auto fault = choose_column(rows, column)) return *fault;
  return rows;
}

}  // namespace

Outcome<std::unique_ptr<Reader>> read_plain(std::unique_ptr<Source> source, std::size_t width) {
  Rows rows;
  rows.width = width;
  return std::unique_ptr<Reader>(std::make_unique<RowReader>(std::move(source), rows));
}

Outcome<std::unique_ptr<Reader>> read_npy(std::unique_ptr<Source> source, const std::string& column) {
  const auto not_npy = [] { return at_byte(0, say("byte 0: not a .npy file of NumPy")); };
  std::array<char, 12> start{};
  const auto got = source->read(std::span(start).first(8));
  if (!got) return got.fault();
  constexpr std::string_view magic("\x93NUMPY", 6);
  const auto version = static_cast<unsigned char>(start[6]);
  if (*got != 8 || std::string_view(start.data(), 6) != magic || version < 1 || version > 3) return not_npy();
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const auto more = source->read(std::span(start).subspan(8, length_bytes));
  if (!more) return more.fault();
  std::uint32_t length = 0;
  std::memcpy(&length, start.data() + 8, length_bytes);
  constexpr std::uint32_t longest = 1U << 20U;
  if (*more != length_bytes || length > longest) return not_npy();
  std::string header(length, '\0');
  const auto read = source->read(header);
  if (!read) return read.fault();
  if (*read != length) return not_npy();
  auto rows = rows_of(header, column);
  if (!rows) return rows.fault();
  rows->start = 8 + length_bytes + length;
  return std::unique_ptr<Reader>(std::make_unique<RowReader>(std::move(source), *rows));
}

}  // namespace loadpath::rainflow
