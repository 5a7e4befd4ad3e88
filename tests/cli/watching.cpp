#include "tests/cli/watching.hpp"

#include "tests/program.hpp"
#include "tests/waiting.hpp"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace loadpath::test {

Watching::Watching(const Desk& desk, const std::string& file) : desk_(desk) {
  const std::string folder = desk.folder().string();
  child_ = fork();
  REQUIRE(child_ >= 0);
  if (child_ == 0) {
    if (chdir(folder.c_str()) != 0) _exit(127);
    const int said = open("said", O_WRONLY | O_CREAT | O_TRUNC, 0600),
              errors = open("errors", O_WRONLY | O_CREAT, 0600);
    if (dup2(said, STDOUT_FILENO) >= 0 && dup2(errors, STDERR_FILENO) >= 0)
      execl(program, program, "watch", file.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  REQUIRE(says("1: "));
  const std::string text = desk.get("said"), mark = "report: ";
  REQUIRE(text.starts_with(mark));
  address_ = text.substr(mark.size(), text.find('\n') - mark.size());
}

Watching::~Watching() {
  if (child_ != 0) end();
}

bool Watching::says(const std::string& word) const {
  return becomes([&] { return ("\n" + desk_.get("said")).find("\n" + word) != std::string::npos; });
}

int Watching::end() {
  kill(child_, SIGINT);
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace loadpath::test
