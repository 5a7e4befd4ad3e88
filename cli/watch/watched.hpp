// Files that a user edits while the program watches them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::cli {

/// A file as it was read.
struct ReadFile {
  std::string path;
  std::string text;
  bool is_there = true;
};

/// Reads a file; of one that cannot be read that it is not there.
ReadFile read_watched(const std::string& path);

/// Whether files still have the content that was read. They are compared by number, size and date, and read again if
/// one of these is new: an editor may write in place or replace the file, and a save without a change does not count.
class WatchedFiles {
 public:
  /// Watches these files from now on.
  void watch(std::vector<ReadFile> files);
  /// Whether the content of a file differs from that read.
  bool have_changed();

 private:
  struct Stamp {
    std::uint64_t inode = 0;
    std::int64_t size = -1, seconds = 0, nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  struct Watched {
    ReadFile read;
    std::optional<Stamp> stamp;  // none: not looked at since it was read
  };
  static Stamp stamp_of(const std::string& path);

  std::vector<Watched> files_;
};

}  // namespace loadpath::cli
