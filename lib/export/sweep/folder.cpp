#include "lib/export/sweep/folder.hpp"

#include "lib/export/sweep/crc64.hpp"
#include "lib/export/sweep/lock.hpp"
#include "lib/sweep/output/npy.hpp"

#include <algorithm>

namespace loadpath::exports {

namespace fs = std::filesystem;

std::string aside_of(const std::string& name) { return "." + name + ".part"; }

std::uint64_t checked(std::uint64_t before, std::string_view bytes) { return crc64(before, bytes); }

std::uint64_t checked(std::uint64_t before, std::span<const double> values) {
  return checked(before, std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
}

bool is_unbegun(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path name = entry.path().filename();
    if (name == FolderLock::file_name || name == aside_of(state_name)) continue;
    if (name != "columns" || !entry.is_directory(error)) return false;
    for (const fs::directory_entry& column : fs::directory_iterator(entry.path(), error)) {
      const bool is_empty = column.is_regular_file(error) && column.file_size(error) <= sweep::npy_header_size;
      if (column.path().extension() != ".npy" || !is_empty) return false;
    }
  }
  return !error;
}

Fault refused(const fs::path& folder, Message message, Message hint) {
  return {0, 1, say("'{1}': {2}", folder.string(), std::move(message)), std::move(hint)};
}

Message not_what_was_written(const fs::path& column) { return say("'{1}' is not what was written", column.string()); }

std::string points_of(project::BlockRange blocks, std::uint64_t points) {
  const std::uint64_t last = std::min(blocks.last * project::block_size, points);
  return std::to_string(blocks.first * project::block_size) + "-" + std::to_string(last - (last == 0 ? 0 : 1));
}

}  // namespace loadpath::exports
