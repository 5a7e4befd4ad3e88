#include "cli/watch/opening.hpp"

#include <spawn.h>
#include <unistd.h>

namespace loadpath::cli {

bool open_page(const std::string& address) {
  for (const char* program : {"xdg-open", "wslview", "open"}) {
    std::string name = program, page = address;
    char* words[] = {name.data(), page.data(), nullptr};
    pid_t child = 0;
    if (::posix_spawnp(&child, program, nullptr, nullptr, words, environ) == 0) return true;
  }
  return false;
}

}  // namespace loadpath::cli
