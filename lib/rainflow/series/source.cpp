#include "lib/rainflow/series/source.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace loadpath::rainflow {

namespace {

Fault unreadable(const std::string& path, int reason) {
  return {0, 1, say("'{1}' cannot be read: {2}", path, std::generic_category().message(reason)), {}};
}

class Descriptor final : public Source {
 public:
  Descriptor(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}
  ~Descriptor() override {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  Outcome<std::size_t> read(std::span<char> room) override {
    std::size_t filled = 0;
    while (filled < room.size()) {
      const auto got = ::read(descriptor_, room.data() + filled, room.size() - filled);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return unreadable(path_, errno);
      if (got == 0) break;
      filled += static_cast<std::size_t>(got);
    }
    return filled;
  }

 private:
  int descriptor_;
  std::string path_;
};

}  // namespace

Outcome<std::unique_ptr<Source>> open_source(const std::string& path) {
  if (path == "-") return std::unique_ptr<Source>(std::make_unique<Descriptor>(STDIN_FILENO, "the standard input"));
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return unreadable(path, errno);
  auto source = std::make_unique<Descriptor>(descriptor, path);
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) return unreadable(path, EISDIR);
  return std::unique_ptr<Source>(std::move(source));
}

}  // namespace loadpath::rainflow
