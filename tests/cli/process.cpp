#include "tests/cli/process.hpp"

#include "tests/program.hpp"

#include <algorithm>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

namespace loadpath::test {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void redirect(int to, const fs::path& path, int flags) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, to) < 0) _exit(126);
}

/// In the child; nothing comes back from here.
[[noreturn]] void become(const fs::path& folder, const fs::path& streams, const std::vector<std::string>& words,
                         const Environment& environment) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  redirect(STDIN_FILENO, streams / "in", O_RDONLY);
  redirect(STDOUT_FILENO, streams / "out", O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, streams / "error", O_WRONLY | O_CREAT | O_TRUNC);
  if (chdir(folder.c_str()) == 0) execv(arguments[0], arguments.data());
  _exit(127);
}

fs::path streams_of(const fs::path& folder) { return folder.string() + ".streams"; }

Ran run_in(const fs::path& folder, const std::vector<std::string>& words, const std::string& input,
           const Environment& environment) {
  const fs::path streams = streams_of(folder);
  std::ofstream(streams / "in", std::ios::binary) << input;
  const pid_t child = fork();
  if (child == 0) become(folder, streams, words, environment);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(streams / "out"),
          text_of(streams / "error")};
}

}  // namespace

Desk::Desk() {
  std::string pattern = (fs::temp_directory_path() / "loadpath-test-XXXXXX").string();
  REQUIRE(mkdtemp(pattern.data()) != nullptr);
  folder_ = pattern;
  fs::create_directory(streams_of(folder_));
}

Desk::~Desk() {
  std::error_code error;
  fs::remove_all(folder_, error);
  fs::remove_all(streams_of(folder_), error);
}

Ran Desk::run(const std::vector<std::string>& words, const std::string& input, const Environment& environment) const {
  std::vector<std::string> all{program};
  all.insert(all.end(), words.begin(), words.end());
  return run_in(folder_, all, input, environment);
}

Ran Desk::shell(const std::string& line) const {
  return run_in(folder_, {"/bin/sh", "-c", std::string("loadpath() { '") + program + "' \"$@\"; }; " + line}, "", {});
}

void Desk::put(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Desk::get(const std::string& name) const { return text_of(folder_ / name); }

std::vector<std::string> Desk::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder_).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace loadpath::test
