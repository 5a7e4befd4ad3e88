// docs/coverage.md names what is there: its calculators, their fields, its files, commands and published cases; and its
// counts are those of its rows.
#include "calculators/catalogue.hpp"
#include "tests/pages.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

using namespace loadpath;
using namespace loadpath::test;

namespace {

namespace fs = std::filesystem;

const fs::path repository = LOADPATH_ROOT;

/// A row of a chapter: item, what computes it, state, published case.
using Row = std::array<std::string, 4>;
/// Items, yes, part, not computable.
using Counts = std::array<std::size_t, 4>;

struct Chapter {
  std::string title;
  std::vector<Row> rows;
};

std::vector<std::string> parts_of(const std::string& text, const std::string& mark) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, from)) {
    parts.push_back(text.substr(from, at - from));
    from = at + mark.size();
  }
  parts.push_back(text.substr(from));
  return parts;
}

/// The cells of "| a | b |"; none of another line and of "|---|---|".
std::vector<std::string> cells_of(const std::string& line) {
  if (!line.starts_with("| ") || !line.ends_with(" |")) return {};
  return parts_of(line.substr(2, line.size() - 4), " | ");
}

/// What is written between two "`".
std::vector<std::string> codes_of(const std::string& text) {
  std::vector<std::string> codes;
  const auto parts = parts_of(text, "`");
  for (std::size_t i = 1; i + 1 < parts.size(); i += 2) codes.push_back(parts[i]);
  return codes;
}

std::vector<Chapter> chapters_of(const std::string& page) {
  std::vector<Chapter> chapters;
  for (const std::string& line : parts_of(page, "\n")) {
    if (line.starts_with("## ")) chapters.push_back({line.substr(3), {}});
    const auto cells = cells_of(line);
    if (chapters.empty() || cells.size() != 4 || cells[0] == "item") continue;
    chapters.back().rows.push_back({cells[0], cells[1], cells[2], cells[3]});
  }
  return chapters;
}

/// The first table, "| all | 221 | 182 | 27 | 12 |", by the first cell.
std::map<std::string, std::string> counts_said(const std::string& page) {
  std::map<std::string, std::string> said;
  for (const std::string& line : parts_of(page, "\n")) {
    if (const auto cells = cells_of(line); cells.size() == 5) said[cells[0]] = line;
  }
  said.erase("text");
  return said;
}

std::string line_of(const std::string& title, const Counts& counts) {
  std::string line = "| " + title;
  for (const std::size_t count : counts) line += " | " + std::to_string(count);
  return line + " |";
}

/// Its index among the counts; 0 if it is not a state.
std::size_t place_of(const std::string& state) {
  if (state == "yes") return 1;
  if (state.starts_with("part: ")) return 2;
  return state.starts_with("not computable: ") ? 3 : 0;
}

/// A field "segments[].tau" of the input or the result, a result "joints.NAME.F", or a failure mode.
bool has_name(const Calculator& calculator, std::string path) {
  for (const ResultPattern& pattern : calculator.patterns()) {
    if (path == pattern.path) return true;
  }
  const auto& modes = calculator.modes;
  if (std::any_of(modes.begin(), modes.end(), [&](const ModeInfo& mode) { return path == mode.id; })) return true;
  for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]", at)) path.insert(at + 1, "1");
  const auto is_in = [&](const RecordType* type) {
    return type != nullptr && find_field_at(type->fields, path) != nullptr;
  };
  return is_in(calculator.input) || is_in(calculator.result);
}

/// "`belt.flat`, `belt.v`: `i`, `eta`": calculators, files or commands, and after them names of each calculator.
void check_subjects(const std::string& part, std::vector<std::string>& faults) {
  const std::size_t colon = std::min(part.find(": "), part.size());
  const auto subjects = codes_of(part.substr(0, colon)), names = codes_of(part.substr(colon));
  if (subjects.empty()) faults.push_back("nothing computes it: " + part);
  for (const std::string& subject : subjects) {
    if (subject.starts_with("loadpath ")) {
      const std::string command = "\n" + subject.substr(0, subject.find(' ', 9)) + " ";
      if (text_of(repository / "docs/commands.md").find(command) == std::string::npos)
        faults.push_back("no command: " + subject);
    } else if (subject.find('/') != std::string::npos) {
      if (!fs::exists(repository / subject)) faults.push_back("no file: " + subject);
    } else if (const Calculator* const calculator = find_calculator(calculators(), subject); calculator == nullptr) {
      faults.push_back("no calculator: " + subject);
    } else {
      for (const std::string& name : names) {
        if (!has_name(*calculator, name.substr(0, name.find(" = "))))
          faults.push_back(subject + " has no name: " + name);
      }
    }
  }
}

/// "`six-bar`: `six_bar.drive.M` = 21.053 N*m": an [[expect]] of reference/six-bar.toml, or of a file by its path.
void check_case(const std::string& published, std::vector<std::string>& faults) {
  if (published == "–") return;
  const auto codes = codes_of(published);
  const std::size_t equals = published.find("` = ");
  if (codes.size() != 2 || equals == std::string::npos) {
    faults.push_back("no case: " + published);
    return;
  }
  const bool is_path = codes[0].find('/') != std::string::npos;
  const std::string file = is_path ? codes[0] : "reference/" + codes[0] + ".toml";
  const std::string entry = "\nvalue = \"" + codes[1] + "\"\nis = \"" + published.substr(equals + 4) + "\"\n";
  if (!fs::exists(repository / file)) {
    faults.push_back("no file: " + file);
  } else if (text_of(repository / file).find(entry) == std::string::npos) {
    faults.push_back("no case: " + published);
  }
}

std::vector<std::string> faults_of(const std::string& page) {
  std::vector<std::string> faults;
  auto said = counts_said(page);
  Counts all{};
  const auto check_counts = [&](const std::string& title, const Counts& counts) {
    if (said[title] != line_of(title, counts)) faults.push_back("counted: " + line_of(title, counts));
    said.erase(title);
  };
  for (const Chapter& chapter : chapters_of(page)) {
    Counts counts{};
    for (const auto& [item, computed_by, state, published] : chapter.rows) {
      ++counts[0];
      if (place_of(state) == 0) faults.push_back("no state: " + state);
      if (place_of(state) != 0) ++counts[place_of(state)];
      for (const std::string& part : parts_of(computed_by, "; ")) check_subjects(part, faults);
      check_case(published, faults);
    }
    for (std::size_t i = 0; i < counts.size(); ++i) all[i] += counts[i];
    check_counts(chapter.title, counts);
  }
  check_counts("all", all);
  for (const auto& [title, line] : said) faults.push_back("no chapter: " + title);
  return faults;
}

/// A page of one row.
std::string page_of(const std::string& row) {
  return "| text | items | yes | part | not computable |\n| [B19] Torsion | 1 | 1 | 0 | 0 |\n| all | 1 | 1 | 0 | 0 "
         "|\n\n"
         "## [B19] Torsion\n\n| item | computed by | state | published case |\n|---|---|---|---|\n" +
         row + "\n";
}

std::string first_fault_of(const std::string& row) {
  const auto faults = faults_of(page_of(row));
  return faults.empty() ? "" : faults.front();
}

}  // namespace

TEST_SUITE("coverage") {
  TEST_CASE("every calculator, field, file, command and case that docs/coverage.md names exists") {
    const std::string page = text_of(repository / "docs/coverage.md");
    for (const std::string& fault : faults_of(page)) FAIL_CHECK(fault);
    std::size_t rows = 0;
    for (const Chapter& chapter : chapters_of(page)) rows += chapter.rows.size();
    CHECK(rows > 200);
  }

  TEST_CASE("its command works as shown") {
    const Desk desk;
    fs::create_directory_symlink(repository / "reference", desk.folder() / "reference");
    std::size_t commands = 0;
    for (const Block& block : blocks_of(text_of(repository / "docs/coverage.md"))) {
      for (const Command& command : commands_of(block.text)) {
        CHECK(typed(desk, command).find(" hold, 0 miss\n") != std::string::npos);
        ++commands;
      }
    }
    CHECK(commands == 1);
  }

  TEST_CASE("a name that does not exist is found") {
    CHECK(first_fault_of(
              "| twist | `shaft.torsion`: `segments[].phi` | yes | `line-shaft`: `line_shaft.d` = 100 mm |") == "");
    CHECK(first_fault_of("| twist | `shaft.twist` | yes | – |") == "no calculator: shaft.twist");
    CHECK(first_fault_of("| twist | `shaft.torsion`: `segments[].psi` | yes | – |") ==
          "shaft.torsion has no name: segments[].psi");
    CHECK(first_fault_of("| twist | `docs/none.md` | yes | – |") == "no file: docs/none.md");
    CHECK(first_fault_of("| twist | `loadpath twist` | yes | – |") == "no command: loadpath twist");
    CHECK(first_fault_of("| twist | by hand | yes | – |") == "nothing computes it: by hand");
    CHECK(first_fault_of("| twist | `shaft.torsion` | no | – |") == "no state: no");
    CHECK(first_fault_of("| twist | `shaft.torsion` | yes | `none`: `a.d` = 1 mm |") == "no file: reference/none.toml");
    CHECK(first_fault_of("| twist | `shaft.torsion` | yes | `line-shaft`: `line_shaft.d` = 90 mm |") ==
          "no case: `line-shaft`: `line_shaft.d` = 90 mm");
    CHECK(first_fault_of("| twist | `shaft.torsion` | part: the surface | – |") ==
          "counted: | [B19] Torsion | 1 | 0 | 1 | 0 |");
  }
}
