// The program as a process: its words, its exit code, its output.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::test {

struct Ran {
  int code = -1;
  std::string out;
  std::string error;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs the program in a separate folder.
class Desk {
 public:
  Desk();
  ~Desk();
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  [[nodiscard]] Ran run(const std::vector<std::string>& words, const std::string& input = "",
                        const Environment& environment = {}) const;
  /// A line as a user types it; `loadpath` is the program under test.
  [[nodiscard]] Ran shell(const std::string& line) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  void put(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string get(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  /// The names of all files, sorted.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  std::filesystem::path folder_;
};

/// One run where no file matters.
inline Ran loadpath_with(const std::vector<std::string>& words) { return Desk().run(words); }

}  // namespace loadpath::test
