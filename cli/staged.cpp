#include "cli/staged.hpp"

#include "cli/exit.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace loadpath::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* part = ".part";  // file name extension of incomplete files

sigset_t watched() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    struct sigaction now {};
    const bool ignored = sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;  // nohup
    if (!ignored) sigaddset(&set, signal);
  }
  return set;
}

/// All of it, on the disk.
bool write_whole(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS;  // a pipe has no disk behind it
}

/// Removes remains of this output from a killed program: parts with the number of no running process.
void remove_leftovers(const fs::path& target) {
  const std::string start = "." + target.filename().string() + ".";
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(part)) continue;
    const int process = std::atoi(name.c_str() + start.size());
    if (process > 0 && kill(process, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), error);
  }
}

/// The target of a path after symbolic links are followed; the file need not exist.
struct Target {
  fs::path path;
  int descriptor = -1;  // descriptor of an open file of this process, as named by /dev/stdout
};

Target target_of(fs::path path) {
  constexpr int most_links = 40;  // the limit of Linux
  std::error_code error;
  for (int links = 0; links < most_links; ++links) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (fs::equivalent(folder, "/proc/self/fd", error) && fs::exists(fs::symlink_status(path, error)))
      return {path, std::atoi(path.filename().c_str())};
    if (!fs::is_symlink(path, error)) break;
    path = folder / fs::read_symlink(path, error);
  }
  return {path};
}

/// A device, a pipe or an open file: written directly, never replaced.
bool is_stream(const Target& target) {
  std::error_code error;
  return target.descriptor >= 0 || fs::is_other(target.path, error);
}

/// A descriptor for writing to a stream, for an open file at its current position; -1 with errno.
int open_stream(const Target& target) {
  if (target.descriptor == STDOUT_FILENO) std::cout.flush();
  if (target.descriptor >= 0) return ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0);
  return ::open(target.path.c_str(), O_WRONLY | O_CLOEXEC);
}

bool cannot_write(const fs::path& path, int error) {
  std::cerr << "loadpath: cannot write '" << path.string() << "': " << std::strerror(error) << "\n";
  return false;
}

}  // namespace

Scratch::Scratch(std::atomic<bool>* asked) : asked_(asked) {
  const sigset_t set = watched();
  pthread_sigmask(SIG_BLOCK, &set, &before_);
  watcher_ = std::thread([this] { take_signals(); });
}

Scratch::~Scratch() {
  pthread_kill(watcher_.native_handle(), SIGUSR1);  // nothing more to watch
  watcher_.join();
  remove_all();  // single-threaded again
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Scratch::take_signals() {
  const sigset_t set = watched();
  int signal = 0;
  sigwait(&set, &signal);
  if (asked_ != nullptr && signal != SIGUSR1) {
    *asked_ = true;
    sigwait(&set, &signal);
  }
  if (signal == SIGUSR1) return;
  mutex_.lock();  // for good: no more files are created
  remove_all();
  for (std::string_view word = word_; !word.empty();) {
    const ssize_t written = ::write(STDERR_FILENO, word.data(), word.size());
    word.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : word.size());
  }
  _exit(interrupted);
}

int Scratch::create(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file >= 0) paths_.push_back(path);
  return file;
}

void Scratch::add(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  paths_.push_back(path);
}

fs::path Scratch::create_folder() {
  const std::lock_guard lock(mutex_);
  std::string pattern = (fs::temp_directory_path() / "loadpath-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) return {};
  paths_.emplace_back(pattern);
  return pattern;
}

void Scratch::create_parents(const fs::path& folder) {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) missing.push_back(at);
  fs::create_directories(folder, error);
  parents_.insert(parents_.end(), missing.rbegin(), missing.rend());
}

void Scratch::release(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  std::erase(paths_, path);
}

void Scratch::leave_word(std::string word) {
  const std::lock_guard lock(mutex_);
  word_ = std::move(word);
}

pid_t Scratch::start(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &before_);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const std::lock_guard lock(mutex_);
  if (posix_spawn(&child_, words[0].c_str(), &actions, &attributes, arguments.data(), environ) != 0) child_ = 0;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return child_;
}

int Scratch::wait() {
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOWAIT);  // its number is not given away yet
  const std::lock_guard lock(mutex_);
  int status = 0;
  const bool reaped = waitpid(child_, &status, 0) == child_;
  child_ = 0;
  return reaped && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void Scratch::remove_all() {
  if (child_ > 0) kill(child_, SIGKILL);
  for (const fs::path& path : paths_) {
    std::error_code error;
    for (int tries = 0; tries < 20 && fs::exists(path, error); ++tries) {  // a child may still write into a folder
      fs::remove_all(path, error);
      if (error) usleep(10'000);
    }
  }
  paths_.clear();
  std::error_code error;
  for (auto folder = parents_.rbegin(); folder != parents_.rend(); ++folder)
    fs::remove(*folder, error);  // the empty ones
  parents_.clear();
}

bool Staged::add(const fs::path& path, const std::string& text) {
  const Target target = target_of(path);
  if (is_stream(target)) {
    files_.push_back({{}, path, text});
    return true;
  }
  std::error_code error;
  if (fs::is_symlink(target.path, error)) return cannot_write(path, ELOOP);
  if (path.has_parent_path()) scratch_.create_parents(path.parent_path());
  const fs::path part_file = place_next_to(target.path);
  const int file = scratch_.create(part_file);
  if (file < 0) return cannot_write(path, errno);
  const int why = write_whole(file, text) ? 0 : errno;
  const int later = ::close(file) == 0 ? why : errno;
  return later == 0 || cannot_write(path, why == 0 ? later : why);
}

fs::path Staged::place_next_to(const fs::path& target) {
  const std::string number = std::to_string(getpid()) + "-" + std::to_string(files_.size() + 1);
  const fs::path part_file = target.parent_path() / ("." + target.filename().string() + "." + number + part);
  remove_leftovers(target);
  files_.push_back({part_file, target, {}});
  return part_file;
}

fs::path Staged::aside(const fs::path& path) {
  const Target target = target_of(path);
  if (is_stream(target)) return path;
  fs::path part_file = place_next_to(target.path);
  scratch_.add(part_file);
  return part_file;
}

std::FILE* Staged::open(const fs::path& path) {
  const Target target = target_of(path);
  if (!is_stream(target)) return std::fopen(aside(path).c_str(), "wb");
  const int descriptor = open_stream(target);
  return descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
}

bool Staged::finish() {
  for (const File& file : files_) {
    if (const int why = file.aside.empty() ? send(file) : put(file); why != 0) return cannot_write(file.path, why);
  }
  return true;
}

int Staged::send(const File& file) {
  const int target = open_stream(target_of(file.path));
  if (target < 0) return errno;
  const int why = write_whole(target, file.text) ? 0 : errno;
  return ::close(target) == 0 || why != 0 ? why : errno;
}

/// Renames it into place, with the rights of the previous file; a protected one remains.
int Staged::put(const File& file) {
  std::error_code error;
  if (fs::exists(file.path, error)) {
    if (access(file.path.c_str(), W_OK) != 0) return errno;
    fs::permissions(file.aside, fs::status(file.path, error).permissions(), error);
  }
  fs::rename(file.aside, file.path, error);
  if (!error) scratch_.release(file.aside);
  return error.value();
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::exists(a, error) && fs::exists(b, error) && fs::equivalent(a, b, error);
}

}  // namespace loadpath::cli
