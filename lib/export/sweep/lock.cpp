#include "lib/export/sweep/lock.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace loadpath::exports {

namespace {

namespace fs = std::filesystem;

/// "4711 on node7"
std::string own_name() {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  return std::to_string(::getpid()) + " on " + host.data();
}

std::string name_in(int file) {
  std::array<char, 300> text{};
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

bool is_still_there(int file, const fs::path& path) {
  struct stat own {};
  struct stat there {};
  return ::fstat(file, &own) == 0 && ::stat(path.c_str(), &there) == 0 && own.st_dev == there.st_dev &&
         own.st_ino == there.st_ino;
}

enum class Locked { yes, no, never };

/// A lock of the whole file: of the open file, not of the process, so that two sweeps of one process exclude each
/// other.
struct flock whole_file(short type) {
  struct flock of {};
  of.l_type = type;
  of.l_whence = SEEK_SET;
  return of;
}

/// never: the file system does not support locks.
Locked lock(int file, short type) {
  struct flock of = whole_file(type);
  while (::fcntl(file, F_OFD_SETLK, &of) != 0) {
    if (errno == EAGAIN || errno == EACCES) return Locked::no;
    if (errno != EINTR) return Locked::never;
  }
  return Locked::yes;
}

/// Whether a process has locked the file for writing. Takes no lock, which would turn away a sweep that begins.
bool is_written(int file) {
  struct flock of = whole_file(F_RDLCK);
  return ::fcntl(file, F_OFD_GETLK, &of) == 0 && of.l_type == F_WRLCK;
}

Fault at_work(const fs::path& folder, int file) {
  const std::string name = name_in(file);
  Message who = name.empty() ? say("another process is using it") : say("process {1} is using it", name);
  return {0, 1, say("'{1}': {2}", folder.string(), std::move(who)), say("wait for it, or name another folder")};
}

}  // namespace

FolderLock::FolderLock(FolderLock&& other) noexcept
    : path_(std::exchange(other.path_, {})), file_(std::exchange(other.file_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  return *this;
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  if (!path_.empty()) ::unlink(path_.c_str());  // while locked: a waiting process sees that it is gone
  ::close(file_);
}

Outcome<FolderLock> FolderLock::to_write(const fs::path& folder) {
  const fs::path path = folder / file_name;
  for (;;) {
    FolderLock own;
    own.file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (own.file_ < 0) return Fault{0, 1, say("cannot write '{1}': {2}", path.string(), std::strerror(errno)), {}};
    const Locked locked = lock(own.file_, F_WRLCK);
    if (locked == Locked::no) return at_work(folder, own.file_);
    if (locked == Locked::yes && !is_still_there(own.file_, path)) continue;
    own.path_ = path;
    const std::string name = own_name();
    static_cast<void>(::ftruncate(own.file_, 0) == 0 && ::pwrite(own.file_, name.data(), name.size(), 0) > 0);
    return own;  // without a name where the disk is full
  }
}

std::optional<Fault> FolderLock::writer_of(const fs::path& folder) {
  FolderLock own;
  own.file_ = ::open((folder / file_name).c_str(), O_RDONLY | O_CLOEXEC);
  if (own.file_ < 0 || !is_written(own.file_)) return std::nullopt;
  return at_work(folder, own.file_);
}

Outcome<FolderLock> FolderLock::to_read(const fs::path& folder) {
  FolderLock own;
  own.file_ = ::open((folder / file_name).c_str(), O_RDONLY | O_CLOEXEC);
  if (own.file_ >= 0 && lock(own.file_, F_RDLCK) == Locked::no) return at_work(folder, own.file_);
  return own;  // without a file no process writes there
}

}  // namespace loadpath::exports
