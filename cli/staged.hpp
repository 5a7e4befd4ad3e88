// Files that are created completely or not at all: written to temporary files, flushed to the disk, and renamed once
// all of them are there. An early end, by an error or a signal, leaves the old files as they were and no others;
// after a kill the next run removes the rest.
#pragma once

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <string>
#include <sys/types.h>
#include <thread>
#include <vector>

namespace loadpath::cli {

/// Temporary objects that must not outlive the program, however it ends: files, folders, a child. While one exists,
/// SIGINT, SIGTERM and SIGHUP are handled by a thread that removes them and ends the program with the exit code for
/// interrupted. With `asked` the first signal only sets it, and the program ends by itself; the second ends it at
/// once.
class Scratch {
 public:
  explicit Scratch(std::atomic<bool>* asked = nullptr);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void add(const std::filesystem::path& path);
  /// A new file; its descriptor, or -1 with errno.
  int create(const std::filesystem::path& path);
  /// Releases a path that has become an output.
  void release(const std::filesystem::path& path);
  /// A new folder; empty if there can be none.
  std::filesystem::path create_folder();
  /// A folder with its parent folders; those that remain empty are removed.
  void create_parents(const std::filesystem::path& folder);
  /// The message on standard error if a signal ends the program at once.
  void leave_word(std::string word);
  /// Starts another program, which says nothing; 0 if that fails. Killed where this one is ended.
  pid_t start(const std::vector<std::string>& words);
  /// Its exit code, once it has ended; -1 where a signal has ended it.
  int wait();

 private:
  void remove_all();
  void take_signals();

  std::atomic<bool>* asked_;
  std::mutex mutex_;
  std::vector<std::filesystem::path> paths_;
  std::vector<std::filesystem::path> parents_;  // folders created for outputs, outer ones first
  std::string word_;
  pid_t child_ = 0;
  sigset_t before_;
  std::thread watcher_;
};

/// The outputs of one command.
class Staged {
 public:
  explicit Staged(Scratch& scratch) : scratch_(scratch) {}

  /// Writes the text to a temporary file next to the path. False, with a message on standard error, if that is not
  /// possible.
  bool add(const std::filesystem::path& path, const std::string& text);
  /// A temporary path in the same folder, which `finish` renames. For a device, a pipe or an open file it is the path
  /// itself.
  std::filesystem::path aside(const std::filesystem::path& path);
  /// The same, opened for writing; null with errno if that fails.
  std::FILE* open(const std::filesystem::path& path);
  /// Moves every file into place. False, with a message, if one cannot be put there.
  bool finish();

 private:
  struct File {
    std::filesystem::path aside, path;  // aside: empty for a stream
    std::string text;                   // for a stream
  };
  static int send(const File& file);
  int put(const File& file);
  /// The temporary path of a file, in the folder of its target.
  std::filesystem::path place_next_to(const std::filesystem::path& target);

  Scratch& scratch_;
  std::vector<File> files_;
};

/// Whether two paths name one file, through links too.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace loadpath::cli
