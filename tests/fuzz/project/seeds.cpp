#include "tests/fuzz/project/seeds.hpp"

#include "calculators/catalogue.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace loadpath::fuzz {

namespace {

/// A step of a file: its name, and its lines with those of its inner tables.
struct Section {
  std::string name;
  std::string text;
};

/// The name of the step that a head like "[bar.links.rod]" opens; empty for other lines.
std::string opened(const std::string& line) {
  if (line.empty() || line[0] != '[' || line.find('=') != std::string::npos) return {};
  const std::size_t from = line.find_first_not_of('[');
  return line.substr(from, line.find_first_of(".]", from) - from);
}

std::vector<Section> sections_of(const std::string& text) {
  std::vector<Section> sections;
  for (const std::string& line : lines_of(text)) {
    const std::string name = opened(line);
    if (!name.empty() && (sections.empty() || sections.back().name != name)) sections.push_back({name, {}});
    if (!sections.empty()) sections.back().text += line + "\n";
  }
  std::erase_if(sections, [](const Section& s) { return s.name == "expect" || s.name == "project"; });
  return sections;
}

/// The section with all that it refers to.
std::string with_sources(const std::vector<Section>& all, const Section& wanted, std::set<std::string>& taken) {
  if (!taken.insert(wanted.name).second) return {};
  std::string text;
  for (const Section& other : all) {
    if (wanted.text.find(other.name + ".") != std::string::npos) text += with_sources(all, other, taken);
  }
  return text + wanted.text;
}

/// Cycles of a few positions: long ones are slow under the fuzzer and find nothing more.
std::string shortened(std::string text) {
  const std::string key = "positions = ";
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t from = at + key.size(), to = text.find_first_not_of("0123456789", from);
    text.replace(from, to - from, "24");
  }
  return text;
}

void add(const std::string& text, Seeds& all) {
  const std::vector<Section> sections = sections_of(shortened(text));
  for (const Section& section : sections) {
    std::set<std::string> taken;
    all.projects.push_back(with_sources(sections, section, taken));
  }
}

std::vector<std::string> texts() {
  std::vector<std::string> all;
  for (const Calculator* c : calculators()) {
    all.emplace_back(c->example);
    for (const Template* t : c->templates) all.emplace_back(t->example);
  }
  for (const char* folder : {"examples", "reference", "tests/fuzz/seeds"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LOADPATH_ROOT "/" + std::string(folder))) {
      std::string text;
      if (entry.path().extension() == ".toml" && toml::read_file(entry.path().string(), text)) all.push_back(text);
    }
  }
  std::sort(all.begin(), all.end());  // a folder has no order
  return all;
}

Seeds collected() {
  Seeds all;
  for (const std::string& text : texts()) add(text, all);
  std::set<std::string> seen;
  for (const std::string& project : all.projects) {
    for (const std::string& line : lines_of(project)) {
      const auto [key, value] = halves(line);
      if (key.empty() || !seen.insert(line).second) continue;
      all.lines.push_back(line);
      all.values[key].push_back(value);
    }
  }
  return all;
}

}  // namespace

const Seeds& seeds() {
  static const Seeds all = collected();
  return all;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::pair<std::string, std::string> halves(const std::string& line) {
  const std::size_t equals = line.find(" = ");
  if (equals == std::string::npos || line[0] == '#') return {};
  return {line.substr(0, equals), line.substr(equals + 3)};
}

}  // namespace loadpath::fuzz
