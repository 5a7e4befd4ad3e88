#include "tests/pages.hpp"

#include "lib/toml/tree.hpp"
#include "tests/cli/watching.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace loadpath::test {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

/// The place of consecutive lines, searched from `from` on; the end where there are none.
std::size_t place_of(const std::vector<std::string>& some, const std::vector<std::string>& all, std::size_t from) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(std::min(from, all.size()));
  return static_cast<std::size_t>(std::search(begin, all.end(), some.begin(), some.end()) - all.begin());
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Lines that are shown together, between two "...".
std::vector<std::vector<std::string>> runs_of(const std::vector<std::string>& shown) {
  std::vector<std::vector<std::string>> runs(1);
  for (const std::string& line : shown) {
    if (line == "...") {
      runs.emplace_back();
    } else {
      runs.back().push_back(line);
    }
  }
  return runs;
}

/// The code between two "`" of a line is not a link.
std::string without_code(const std::string& line) {
  std::string text;
  bool code = false;
  for (const char c : line) {
    if (c == '`') code = !code;
    text += code ? ' ' : c;
  }
  return text;
}

/// "Own tables, `"?"`" as own-tables-.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') anchor += '-';
    if (std::isalnum(byte) != 0 || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    }
  }
  return anchor;
}

/// The file that a block of TOML is, given by its first line; none otherwise.
void write(const Desk& desk, const std::string& toml) {
  const std::size_t end = std::min(toml.find('\n'), toml.size());
  const std::string first = toml.substr(0, end), more = ", continued";
  if (!first.starts_with("# ")) return;
  if (first.ends_with(".toml")) return desk.put(first.substr(2), toml);
  if (!first.ends_with(".toml" + more)) return;
  const std::string name = first.substr(2, first.size() - 2 - more.size());
  CAPTURE(name);
  REQUIRE(desk.has(name));
  desk.put(name, desk.get(name) + toml.substr(end));
}

}  // namespace

std::string text_of(const fs::path& path) {
  std::string text;
  CAPTURE(path.string());
  REQUIRE(toml::read_file(path.string(), text));
  return text;
}

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks(1);
  bool code = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with("```")) {
      code = !code;
      blocks.push_back({code ? line.substr(3) : "", ""});
      if (code && blocks.back().language.empty()) blocks.back().language = "code";
    } else {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

std::vector<Command> commands_of(const std::string& code) {
  std::vector<Command> commands;
  std::string before;
  for (const std::string& line : lines_of(code)) {
    const std::string whole = before + line;
    before = whole.ends_with("\\") ? whole.substr(0, whole.size() - 1) : "";
    if (!before.empty() || !whole.starts_with("loadpath ")) continue;
    const std::size_t exit = whole.find("# exit ");
    commands.push_back({whole, exit == std::string::npos ? 0 : std::atoi(whole.c_str() + exit + 7)});
  }
  return commands;
}

std::vector<Link> links_of(const std::string& page) {
  std::vector<Link> links;
  for (const Block& block : blocks_of(page)) {
    if (!block.language.empty()) continue;
    const std::string text = without_code(block.text);
    for (std::size_t middle = text.find("]("); middle != std::string::npos; middle = text.find("](", middle + 1)) {
      const std::size_t begin = text.rfind('[', middle) + 1, end = text.find(')', middle);
      if (end == std::string::npos) continue;
      links.push_back({text.substr(begin, middle - begin), text.substr(middle + 2, end - middle - 2)});
    }
  }
  return links;
}

std::vector<std::string> anchors_of(const std::string& page) {
  std::vector<std::string> anchors;
  for (const Block& block : blocks_of(page)) {
    if (!block.language.empty()) continue;
    for (const std::string& line : lines_of(block.text)) {
      const std::size_t text = line.find_first_not_of('#');
      if (text > 0 && text != std::string::npos && line[text] == ' ')
        anchors.push_back(anchor_of(line.substr(text + 1)));
    }
  }
  return anchors;
}

std::vector<std::string> documents() {
  const fs::path root = LOADPATH_ROOT;
  std::vector<std::string> pages{"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(fs::relative(entry.path(), root).string());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

std::string typed(const Desk& desk, const Command& command) {
  CAPTURE(command.line);
  const std::string watch = "loadpath watch ";
  if (command.line.starts_with(watch)) {
    const std::size_t end = command.line.find(' ', watch.size());
    CHECK(Watching(desk, command.line.substr(watch.size(), end - watch.size())).end() == command.code);
    return "";
  }
  const Ran ran = desk.shell(command.line);
  CAPTURE(ran.error);
  CHECK(ran.code == command.code);
  return ran.out + ran.error;
}

std::string difference(const std::string& shown, const std::string& printed) {
  const std::vector<std::string> all = lines_of(printed);
  const auto runs = runs_of(lines_of(shown));
  std::size_t from = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].empty()) continue;
    const std::size_t last = all.size() - std::min(runs[i].size(), all.size());
    const std::size_t place = place_of(runs[i], all, i + 1 == runs.size() ? std::max(from, last) : from);
    if (place == all.size() || (i == 0 && place > 0)) {
      return "shown is\n" + joined(runs[i]) + "which is not printed there, but\n" + printed;
    }
    from = place + runs[i].size();
  }
  return from == all.size() || runs.back().empty() ? "" : "more is printed than is shown:\n" + printed;
}

void follow(const Desk& desk, const std::string& page) {
  std::string printed;
  for (const Block& block : blocks_of(page)) {
    if (block.language == "toml") write(desk, block.text);
    if (block.language == "sh") {
      printed.clear();
      for (const Command& command : commands_of(block.text)) printed += typed(desk, command);
    }
    if (block.language == "text") CHECK(difference(block.text, printed) == "");
  }
}

}  // namespace loadpath::test
