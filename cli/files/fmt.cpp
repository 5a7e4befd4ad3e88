#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/files/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/inputs/projects.hpp"
#include "cli/staged.hpp"
#include "lib/project/layout/layout.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

struct Text {
  std::string file, before, after;
  [[nodiscard]] bool changes() const { return before != after; }
};

/// False, with a message, if there is no layout.
bool lay_out(Text& text) {
  if (!toml::read_file(text.file, text.before)) {
    std::cerr << "loadpath: cannot read '" << text.file << "'\n  = help: " << help_for_file(text.file) << "\n";
    return false;
  }
  const std::string name = text.file == "-" ? "standard input" : text.file;
  std::vector<Issue> issues;
  text.after = project::layout_of(text.before, name, calculators(), issues);
  terminal::show_issues(issues, {{name, text.before}});
  return !has_errors(issues);
}

/// All files that change, or none of them.
bool write(const std::vector<Text>& texts) {
  Scratch scratch;
  Staged staged(scratch);
  for (const Text& text : texts) {
    if (text.file != "-" && text.changes() && !staged.add(text.file, text.after)) return false;
  }
  return staged.finish();
}

}  // namespace

int fmt(const FmtOptions& options) {
  std::string wrong;
  const auto files = projects_of(options.files, wrong);
  if (!wrong.empty()) {
    std::cerr << "loadpath: " << wrong << "\n";
    return wrong_input;
  }
  std::vector<Text> texts;
  bool read = true;
  for (const ProjectFile& file : files) {
    texts.push_back({file.path, {}, {}});
    read = lay_out(texts.back()) && read;
  }
  if (!read) return wrong_input;
  if (!options.check && !write(texts)) return wrong_input;
  int code = passed;
  for (const Text& text : texts) {
    if (text.file == "-" && !options.check) std::cout << text.after;
    if (!text.changes()) continue;
    if (options.check) code = not_passed;
    if (options.check || text.file != "-")
      (options.check ? std::cout : std::cerr) << (options.check ? "" : "laid out: ") << text.file << "\n";
  }
  return code;
}

}  // namespace loadpath::cli
