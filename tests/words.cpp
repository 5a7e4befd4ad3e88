// The words of the product's strings: none that language rules forbid. Keys, quoted words, markup and search words of
// other languages do not count.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The end of what begins at `from`: behind `mark`, with backslashes as escapes.
std::size_t end_of(const std::string& text, std::size_t from, char mark) {
  while (from < text.size() && text[from] != mark) from += text[from] == '\\' ? 2U : 1U;
  return from + 1;
}

bool is_one_of(char c, std::string_view all) { return all.find(c) != std::string_view::npos; }

/// The string literals of a source, adjacent ones as one; without comments and raw strings, which hold examples.
std::vector<std::string> strings_of(const std::string& text) {
  std::vector<std::string> strings;
  bool adjacent = false;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at], next = at + 1 < text.size() ? text[at + 1] : ' ';
    const char last = at > 0 ? text[at - 1] : ' ';
    if (is_one_of(c, " \t\r\n")) {
      ++at;
      continue;
    }
    if (c == '"') {
      const std::size_t end = end_of(text, at + 1, '"');
      if (!adjacent) strings.emplace_back();
      strings.back() += text.substr(at + 1, end - at - 2);
      adjacent = true;
      at = end;
      continue;
    }
    adjacent = false;
    if (c == '/' && next == '/') {
      at = std::min(text.find('\n', at), text.size());
    } else if (c == '/' && next == '*') {
      at = text.find("*/", at) + 2;
    } else if (c == 'R' && next == '"') {
      const std::string mark = ")" + text.substr(at + 2, text.find('(', at) - at - 2) + "\"";
      at = text.find(mark, at) + mark.size();
    } else if (c == '\'' && !is_one_of(last, "0123456789")) {
      at = end_of(text, at + 1, '\'');
    } else {
      ++at;
    }
  }
  return strings;
}

/// The words of a message or description; empty for markup, names and single words.
std::string words_of(const std::string& string) {
  static const std::regex quoted(R"('[^']*'|\\"[^"]*\\"|`[^`]*`|\b\w+ = )");
  if (string.find(' ') == std::string::npos || string.find('<') != std::string::npos) return {};
  return std::regex_replace(string, quoted, "");
}

/// The first forbidden word, or what has no head; empty without one.
std::string forbidden_in(const std::string& string) {
  static const std::regex forbidden(
      R"(\b(told|tells?|telling|stands?|beside|whole|alone|holds? for|asks? for|asked for|comes? (with|along)|is no|)"
      R"(mends?|feels?|pulls|senses?|(one-)?ways?|play|recalled)\b)"
      R"(|^(What|Of|Where|Anew|what|whose|whether|which) )");
  const std::string words = words_of(string);
  std::smatch found;
  for (auto from = words.cbegin(); std::regex_search(from, words.cend(), found, forbidden); from = found[0].second)
    if (found.str() != "one-way") return found.str();
  return {};
}

}  // namespace

TEST_SUITE("words") {
  TEST_CASE("no string of the program has a forbidden word") {
    const fs::path root = LOADPATH_ROOT;
    std::size_t count = 0;
    for (const char* const storey : {"lib", "calculators", "cli", "api"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / storey)) {
        if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
        std::ifstream in(entry.path());
        std::stringstream text;
        text << in.rdbuf();
        for (const std::string& string : strings_of(text.str())) {
          ++count;
          const std::string word = forbidden_in(string);
          CHECK_MESSAGE(word.empty(), fs::relative(entry.path(), root).generic_string(), ": '", word, "' in \"", string,
                        "\"");
        }
      }
    }
    CHECK(count > 10000);
  }

  TEST_CASE("forbidden words are found in adjacent literals, not in keys, quotes, comments and examples") {
    const auto first_in = [](const std::string& source) {
      for (const std::string& string : strings_of(source)) {
        if (const std::string word = forbidden_in(string); !word.empty()) return word;
      }
      return std::string();
    };
    CHECK(first_in("say(\"the \"\n    \"whole section\")") == "whole");
    CHECK(first_in("say(\"a stress is no\" \" force\")") == "is no");
    CHECK(first_in("say(\"What acts\")") == "What ");
    CHECK(first_in("say(\"a wholesale sense of 'x'\")") == "sense");
    CHECK(first_in("// \"the whole section\"\nchar c = '\"'; say(\"a part\")").empty());
    CHECK(first_in("R\"(the whole section)\"").empty());
    CHECK(first_in("say(\"give way = \\\"drives\\\", or 'beside'\")").empty());
    CHECK(first_in("say(\"one-way or reversing\")").empty());
    CHECK(first_in("say(\"<div class='told beside'>\")").empty());
  }
}
