// What is wrong with a project or with a call, and where it stands.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::api {

/// A place is counted from 1 in characters; line 0: the file as a whole. Of a call the file is the argument's name.
struct Issue {
  std::string file;
  int line = 0, column = 0, length = 1;
  std::string key;      // of the field: "crankshaft.tau_adm"
  std::string message;  // the rule that is broken
  std::string help;     // what would be right; may be empty
  bool is_error = true;
};

/// `what` says all issues as the command line does, with the lines that they stand in.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text, std::vector<Issue> issues = {})
      : std::runtime_error(text), issues_(std::move(issues)) {}

  [[nodiscard]] const std::vector<Issue>& issues() const { return issues_; }

 private:
  std::vector<Issue> issues_;
};

}  // namespace loadpath::api
