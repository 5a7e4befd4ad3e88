#include "lib/sweep/output/npy.hpp"

#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string>
#include <unistd.h>

namespace loadpath::sweep {

static_assert(std::endian::native == std::endian::little, "the columns are written as they stand in memory");

namespace {

constexpr std::size_t header_size = 128;

/// Of one size, whatever the number: it is written again when there are more.
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
  column.rows_ = rows;
  std::FILE* const file = column.file_.get();
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

Outcome<std::vector<double>> read_npy(const std::filesystem::path& path) {
  const auto refuse = [&](const char* what) { return Fault{0, 1, say("'{1}': {2}", path.string(), what), {}}; };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return refuse("cannot be read");
  std::array<char, header_size> found{};
  if (std::fread(found.data(), 1, header_size, file.get()) != header_size) return refuse("it is no column");
  const std::string_view text(found.data(), found.size());
  const std::size_t shape = text.find("'shape': (");
  if (shape == std::string_view::npos) return refuse("it is no column");
  const std::uint64_t rows = std::strtoull(found.data() + shape + 10, nullptr, 10);
  if (header(rows) != found) return refuse("it is no column of this program");
  std::error_code error;
  if (std::filesystem::file_size(path, error) < static_cast<std::uint64_t>(end_of(rows)) || error)
    return refuse("its end is missing");
  std::vector<double> values(rows);
  if (std::fread(values.data(), sizeof(double), rows, file.get()) != rows) return refuse("cannot be read");
  return values;
}

}  // namespace loadpath::sweep
