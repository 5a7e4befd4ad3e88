// A folder locked by one process. The lock ends with the process, however it ends: remains of a process that was
// killed one blocks no other. On a shared disk it works between computers if the file system supports locks.
#pragma once

#include "lib/text/issue.hpp"

#include <filesystem>
#include <optional>

namespace loadpath::exports {

class FolderLock {
 public:
  static constexpr const char* file_name = ".loadpath.lock";

  FolderLock() = default;
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

  /// Locks for writing: a Fault if another process is at work, with its number and its host, or nothing can be
  /// written.
  static Outcome<FolderLock> to_write(const std::filesystem::path& folder);
  /// Locks for reading: the content must not change meanwhile.
  static Outcome<FolderLock> to_read(const std::filesystem::path& folder);
  /// That another process is writing there, if one is. Takes no lock.
  static std::optional<Fault> writer_of(const std::filesystem::path& folder);

 private:
  std::filesystem::path path_;  // file of a writer, which removes it
  int file_ = -1;
};

}  // namespace loadpath::exports
