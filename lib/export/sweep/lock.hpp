// A folder that one process works in. The lock ends with the process, however it ends: what is left of one that was
// killed stands in nobody's way. On a shared disk it holds among machines where the file system knows locks.
#pragma once

#include "lib/text/issue.hpp"

#include <filesystem>

namespace loadpath::exports {

class FolderLock {
 public:
  static constexpr const char* file_name = ".loadpath.lock";

  FolderLock() = default;
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

  /// To write there: a Fault where another process is at work, with its number and its machine, or nothing can be
  /// written.
  static Outcome<FolderLock> to_write(const std::filesystem::path& folder);
  /// To read what must not change meanwhile.
  static Outcome<FolderLock> to_read(const std::filesystem::path& folder);

 private:
  std::filesystem::path path_;  // of one that writes: it takes the file away
  int file_ = -1;
};

}  // namespace loadpath::exports
