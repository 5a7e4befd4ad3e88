// `loadpath watch` at work, for tests.
#pragma once

#include "tests/cli/process.hpp"

#include <string>
#include <sys/types.h>

namespace loadpath::test {

/// Watches a file of a desk from here on; ended by Ctrl-C at the end.
class Watching {
 public:
  Watching(const Desk& desk, const std::string& file);
  ~Watching();
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;

  /// "http://127.0.0.1:41235/6b1f.../"
  [[nodiscard]] const std::string& address() const { return address_; }
  /// Waits until a word appears in its output; false if it does not within minutes.
  [[nodiscard]] bool says(const std::string& word) const;
  /// Ctrl-C; the exit code.
  int end();

 private:
  const Desk& desk_;
  std::string address_;
  pid_t child_ = 0;
};

}  // namespace loadpath::test
