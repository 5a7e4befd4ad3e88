#include "lib/sweep/output/npy.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>

namespace loadpath::sweep {

static_assert(std::endian::native == std::endian::little, "the columns are written as they are in memory");

namespace {

constexpr std::size_t header_size = npy_header_size;
constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Fixed size for any number of rows: it is written again when there are more.
std::array<char, header_size> header(std::uint64_t rows) {
  std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ",), }";
  constexpr std::size_t before = 10;  // the magic, the version, the length
  text.resize(header_size - before - 1, ' ');
  text += '\n';
  std::array<char, header_size> bytes{};
  constexpr char magic[] = {'\x93', 'N', 'U', 'M', 'P', 'Y', '\x01', '\x00', header_size - before, '\x00'};
  std::memcpy(bytes.data(), magic, before);
  std::memcpy(bytes.data() + before, text.data(), text.size());
  return bytes;
}

Fault fault(const std::filesystem::path& path) {
  return {0, 1, say("cannot write '{1}': {2}", path.string(), std::strerror(errno)), {}};
}

long end_of(std::uint64_t rows) { return static_cast<long>(header_size + rows * sizeof(double)); }

}  // namespace

Outcome<NpyColumn> NpyColumn::open(const std::filesystem::path& path, std::uint64_t rows) {
  NpyColumn column;
  column.file_.reset(std::fopen(path.c_str(), rows == 0 ? "w+b" : "r+b"));
  if (!column.file_) return fault(path);
  std::unique_ptr<char[]>& buffer = column.file_.get_deleter().buffer;
  buffer = std::make_unique<char[]>(buffer_size);
  std::setvbuf(column.file_.get(), buffer.get(), _IOFBF, buffer_size);
  column.rows_ = rows;
  std::FILE* const file = column.file_.get();
  if (rows != 0 && (std::fseek(file, 0, SEEK_END) != 0 || std::ftell(file) < end_of(rows)))
    return Fault{0, 1, say("'{1}': its end is missing", path.string()), {}};
  const bool cut = rows == 0 || ::ftruncate(::fileno(file), end_of(rows)) == 0;
  if (!cut || !column.flush() || std::fseek(file, end_of(rows), SEEK_SET) != 0) return fault(path);
  return column;
}

bool NpyColumn::append(std::span<const double> values) {
  rows_ += values.size();
  return std::fwrite(values.data(), sizeof(double), values.size(), file_.get()) == values.size();
}

bool NpyColumn::flush() {
  std::FILE* const file = file_.get();
  const auto bytes = header(rows_);
  return std::fseek(file, 0, SEEK_SET) == 0 && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() &&
         std::fseek(file, end_of(rows_), SEEK_SET) == 0 && flush_to_disk(file);
}

bool flush_to_disk(std::FILE* file) { return std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0; }

Message read_npy(const std::filesystem::path& path, const std::function<bool(std::span<const double> values)>& take) {
  const auto wrong = [&](const char* what) { return say("'{1}': {2}", path.string(), what); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return wrong("cannot be read");
  std::array<char, header_size> found{};
  if (std::fread(found.data(), 1, header_size, file.get()) != header_size) return wrong("not a column");
  const std::string_view text(found.data(), found.size());
  constexpr std::string_view shape = "'shape': (";
  const std::size_t at = text.find(shape);
  if (at == std::string_view::npos) return wrong("not a column");
  std::uint64_t left = std::strtoull(found.data() + at + shape.size(), nullptr, 10);
  if (header(left) != found) return wrong("it is not a column of this program");
  std::array<double, 8192> values{};
  while (left > 0) {
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, values.size()));
    if (std::fread(values.data(), sizeof(double), wanted, file.get()) != wanted) return wrong("its end is missing");
    if (!take(std::span(values).first(wanted))) return {};
    left -= wanted;
  }
  return {};
}

}  // namespace loadpath::sweep
