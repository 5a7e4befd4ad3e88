#include "tests/contract/source_formulas.hpp"

#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace loadpath::test {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Behind the string literal that starts at `at`.
std::size_t behind_literal(const std::string& text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return at + 1;
}

/// The arguments of a macro, from behind its opening parenthesis.
std::vector<std::string> arguments_at(const std::string& text, std::size_t at) {
  std::vector<std::string> arguments;
  std::size_t from = at;
  for (int depth = 1; at < text.size();) {
    const char c = text[at];
    if (c == '"') {
      at = behind_literal(text, at);
      continue;
    }
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 || (c == ',' && depth == 1)) {
      arguments.push_back(text.substr(from, at - from));
      from = at + 1;
    }
    ++at;
    if (depth == 0) return arguments;
  }
  FAIL("a macro does not end");
  return arguments;
}

/// As it is printed, on one line.
std::string printed(const std::string& formula) {
  static const std::regex space("\\s+");
  std::string text = std::regex_replace(formula, space, " ");
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return formula::shown(text);
}

/// The text between quotation marks; none if the argument is not a literal.
std::string literal(const std::string& argument) {
  const std::size_t from = argument.find('"'), to = argument.rfind('"');
  return from < to ? argument.substr(from + 1, to - from - 1) : "";
}

/// "gear" of "calculators/gear/pair_mesh.cpp".
std::string folder_of(const fs::path& file) { return std::next(file.begin())->string(); }

void read_formulas(const fs::path& root, const fs::path& file, std::vector<SourceFormula>& formulas) {
  static const std::regex macro("\\b(STEP|STEP_TO|NAMED_STEP)\\(");
  const fs::path path = fs::relative(file, root);
  const std::string text = text_of(file);
  for (std::sregex_iterator i(text.begin(), text.end(), macro), end; i != end; ++i) {
    const std::string name = (*i)[1].str();
    const auto start = i->position();
    const auto arguments = arguments_at(text, static_cast<std::size_t>(start + i->length()));
    const std::size_t symbol = name == "STEP_TO" ? 1 : 0;  // behind the record that it stores into
    REQUIRE(arguments.size() > symbol + 1);
    const auto line = 1 + std::count(text.begin(), text.begin() + start, '\n');
    formulas.push_back({path.generic_string() + ":" + std::to_string(line), folder_of(path),
                        name == "NAMED_STEP" ? literal(arguments[symbol]) : printed(arguments[symbol]),
                        printed(arguments[symbol + 1])});
  }
}

}  // namespace

std::vector<SourceFormula> source_formulas(const std::function<bool(std::string_view)>& is_read) {
  const fs::path root = LOADPATH_ROOT;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / "calculators")) {
    const fs::path& file = entry.path();
    const bool is_source = file.extension() == ".hpp" || file.extension() == ".cpp";
    if (is_source && is_read(folder_of(fs::relative(file, root)))) files.push_back(file);
  }
  std::sort(files.begin(), files.end());
  std::vector<SourceFormula> formulas;
  for (const fs::path& file : files) read_formulas(root, file, formulas);
  return formulas;
}

}  // namespace loadpath::test
