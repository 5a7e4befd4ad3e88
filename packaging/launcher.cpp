// Starts the program of the portable archive by the loader and with the libraries next to it, whatever the
// system has. Linked statically: it needs nothing.
#include <climits>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

int main(int argc, char** argv) {
  char self[PATH_MAX];
  const ssize_t length = ::readlink("/proc/self/exe", self, sizeof self - 1);
  // Without /proc the name that it was started by leads here.
  const std::string path = length > 0 ? std::string(self, static_cast<std::size_t>(length)) : std::string(argv[0]);
  const std::size_t slash = path.rfind('/');
  const std::string lib = (slash == std::string::npos ? "." : path.substr(0, slash)) + "/lib";
  std::string loader = lib + "/ld-linux-x86-64.so.2", program = lib + "/loadpath", libraries = lib;
  char by_name[] = "--argv0", name[] = "loadpath", from[] = "--library-path";
  std::vector<char*> words{loader.data(), by_name, name, from, libraries.data(), program.data()};
  for (int i = 1; i < argc; ++i) words.push_back(argv[i]);
  words.push_back(nullptr);
  ::execv(loader.c_str(), words.data());
  std::fprintf(stderr, "loadpath: cannot start '%s': %s\n", loader.c_str(), std::strerror(errno));
  return 3;
}
