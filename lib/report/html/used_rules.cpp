#include "lib/report/html/used_rules.hpp"

#include <algorithm>
#include <unordered_set>

namespace loadpath::report {
namespace {

using View = std::string_view;
using Names = std::unordered_set<View>;

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

Names classes_of(View page) {
  constexpr View begin = "class=\"";
  Names names;
  for (std::size_t at = page.find(begin); at != View::npos; at = page.find(begin, at)) {
    at += begin.size();
    View list = page.substr(at, page.find('"', at) - at);
    while (!list.empty()) {
      const std::size_t end = std::min(list.find(' '), list.size());
      names.insert(list.substr(0, end));
      list.remove_prefix(std::min(end + 1, list.size()));
    }
  }
  return names;
}

/// What an element need not have, ":not(.of-numbers)", or may have as one of several, is in brackets.
bool may_match(View selector, const Names& names) {
  int depth = 0;
  for (std::size_t at = 0; at < selector.size(); ++at) {
    depth += selector[at] == '(' ? 1 : selector[at] == ')' ? -1 : 0;
    if (selector[at] != '.' || depth > 0) continue;
    std::size_t end = at + 1;
    while (end < selector.size() && is_of_name(selector[end])) ++end;
    if (!names.contains(selector.substr(at + 1, end - at - 1))) return false;
  }
  return true;
}

/// The selectors of the list that may match an element.
std::string matching(View list, const Names& names) {
  std::string kept;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= list.size(); ++at) {
    const char c = at < list.size() ? list[at] : ',';
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c != ',' || (depth > 0 && at < list.size())) continue;
    const View selector = list.substr(begin, at - begin);
    begin = at + 1;
    if (may_match(selector, names)) kept.append(kept.empty() ? "" : ",").append(selector);
  }
  return kept;
}

/// The brace that closes the block whose content begins at `at`; strings are passed over.
std::size_t end_of_block(View sheet, std::size_t at) {
  int depth = 1;
  for (char quoted = '\0'; at < sheet.size(); ++at) {
    const char c = sheet[at];
    if (quoted != '\0') {
      if (c == '\\') ++at;
      if (c == quoted) quoted = '\0';
    } else if (c == '"' || c == '\'') {
      quoted = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return at;
    }
  }
  return sheet.size();
}

std::string kept_rules(View sheet, const Names& names) {
  std::string out;
  while (true) {
    const std::size_t open = sheet.find('{');
    if (open == View::npos) return out.append(sheet);
    const std::size_t close = end_of_block(sheet, open + 1);
    const std::size_t first = std::min(sheet.find_first_not_of(" \n"), open);
    const View head = sheet.substr(first, open - first), body = sheet.substr(open + 1, close - open - 1);
    if (head.starts_with("@media")) {
      out.append(head).append("{").append(kept_rules(body, names)).append("}");
    } else {
      const std::string selectors = head.starts_with('@') ? std::string(head) : matching(head, names);
      if (!selectors.empty()) out.append(selectors).append("{").append(body).append("}");
    }
    sheet.remove_prefix(std::min(close + 1, sheet.size()));
  }
}

}  // namespace

std::string used_rules(View sheet, View page) { return kept_rules(sheet, classes_of(page)); }

}  // namespace loadpath::report
