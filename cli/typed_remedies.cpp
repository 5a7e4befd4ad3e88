#include "cli/typed_remedies.hpp"

#include <regex>
#include <string>

namespace loadpath::cli {

namespace {

/// Whether the issue is about a flag of a calculator; `--set` and `--series` have words of their own.
bool is_of_flag(const Issue& issue) {
  const std::string& file = issue.place.file;
  return file == "command line" || (file.starts_with("--") && file != "--set" && file != "--series");
}

std::string with_reasons(const std::string& text) {
  static const std::regex reason(R"re(\b(because|accept)\.([\w.]+) = ("[^"]*"))re");
  return std::regex_replace(text, reason, "--$1 $2=$3");
}

/// Inline tables are in single quotes on the shell, and have keys of their own.
std::string with_values(const std::string& text) {
  static const std::regex value(R"re((^|[ (])([A-Za-z]\w*) = ("[^"]*"))re"),
      outside(R"re((^|\(|[^{,] )([A-Za-z]\w*) = ("[^"]*"))re"),
      table(R"re((^|[ (])([A-Za-z]\w*) = (\[\{ .*? \}\]|\{ .*? \})(?= or |[.;?)]|$))re");
  if (text.find('{') == std::string::npos) return std::regex_replace(text, value, "$1--$2 $3");
  return std::regex_replace(std::regex_replace(text, table, "$1--$2 '$3'"), outside, "$1--$2 $3");
}

}  // namespace

std::string as_flags(const std::string& text) { return with_values(with_reasons(text)); }

std::vector<Issue> with_flags(std::vector<Issue> issues) {
  for (Issue& issue : issues) {
    if (!is_of_flag(issue)) continue;
    issue.message = say("{1}", as_flags(issue.message.text()));
    if (!issue.hint.empty()) issue.hint = say("{1}", as_flags(issue.hint.text()));
  }
  return issues;
}

}  // namespace loadpath::cli
