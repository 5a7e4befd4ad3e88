// An error in a project or a call, with its location.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::api {

/// A location, counted from 1 in characters; line 0: the file in general. In a call, `file` is the name of the
/// argument.
struct Issue {
  std::string file;
  int line = 0, column = 0, length = 1;
  std::string key;      // path of the field: "crankshaft.tau_adm"
  std::string message;  // the rule that is broken
  std::string help;     // proposed correction; may be empty
  bool is_error = true;
};

/// `what` lists all issues as the command line does, with the lines concerned.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text, std::vector<Issue> issues = {})
      : std::runtime_error(text), issues_(std::move(issues)) {}

  [[nodiscard]] const std::vector<Issue>& issues() const { return issues_; }

 private:
  std::vector<Issue> issues_;
};

}  // namespace loadpath::api
