#include "cli/watch/watched.hpp"

#include "lib/toml/tree.hpp"

#include <algorithm>
#include <sys/stat.h>

namespace loadpath::cli {

ReadFile read_watched(const std::string& path) {
  ReadFile file{path, {}, true};
  file.is_there = toml::read_file(path, file.text);
  return file;
}

WatchedFiles::Stamp WatchedFiles::stamp_of(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return {};
  return {found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

void WatchedFiles::watch(std::vector<ReadFile> files) {
  files_.clear();
  for (ReadFile& file : files) files_.push_back({std::move(file), std::nullopt});
}

bool WatchedFiles::have_changed() {
  return std::any_of(files_.begin(), files_.end(), [](Watched& file) {
    const Stamp stamp = stamp_of(file.read.path);
    if (stamp == file.stamp) return false;
    file.stamp = stamp;
    const ReadFile now = read_watched(file.read.path);
    return now.is_there != file.read.is_there || now.text != file.read.text;
  });
}

}  // namespace loadpath::cli
