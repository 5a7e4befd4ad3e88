// The rooms of the sources: which folder may include from which is said once, in docs/architecture.md. Within a room
// the modules, each a header with its source, go down too.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_room = 26;  // files

using Graph = std::map<std::string, std::set<std::string>>;  // a room, or a module, and those that it needs
using Texts = std::map<std::string, std::string>;            // texts of files: "lib/draw/svg.cpp"
using Homes = std::map<std::string, std::string>;            // the modules of sources that have no header of their name
struct Arrow {
  std::string from;  // a file: "lib/draw/svg.cpp"
  std::string to;
};

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string room_of(const std::string& file) { return fs::path(file).parent_path().generic_string(); }
/// "lib" of "lib/draw/plot"; the storeys of the house.
std::string storey_of(const std::string& room) { return room.substr(0, room.find('/')); }
int height_of(const std::string& storey) {
  return storey == "lib" ? 0 : storey == "calculators" ? 1 : storey == "cli" || storey == "api" ? 2 : 3;
}

/// The graph between "```rooms" and "```": a room, a colon, the rooms that it needs; each once.
Graph read_graph(const std::string& page, std::vector<std::string>& faults) {
  Graph graph;
  const std::size_t from = page.find("```rooms\n"), to = page.find("```", from + 9);
  REQUIRE(from != std::string::npos);
  REQUIRE(to != std::string::npos);
  std::istringstream lines(page.substr(from + 9, to - from - 9));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string room, needed;
    if (!(words >> room)) continue;
    if (room.back() == ':') room.pop_back();
    if (graph.count(room) != 0) faults.push_back(room + ": drawn twice in docs/architecture.md");
    auto& needs = graph[room];
    while (words >> needed) needs.insert(needed);
  }
  return graph;
}

/// Every source of the program.
Texts read_sources(const fs::path& root) {
  Texts texts;
  for (const char* const storey : {"lib", "calculators", "cli", "api"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / storey)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      texts[fs::relative(entry.path(), root).generic_string()] = text_of(entry.path());
    }
  }
  return texts;
}

std::vector<std::string> files_of(const Texts& texts) {
  std::vector<std::string> files;
  for (const auto& [file, text] : texts) files.push_back(file);
  return files;
}

/// Includes of the program's sources.
std::vector<Arrow> includes_of(const Texts& texts) {
  std::vector<Arrow> arrows;
  const std::regex include("#include \"([^\"]+)\"");
  for (const auto& [file, text] : texts) {
    for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i)
      arrows.push_back({file, (*i)[1].str()});
  }
  return arrows;
}

/// "lib/draw/svg" of "lib/draw/svg.cpp" and of its header.
std::string stem_of(const std::string& file) { return fs::path(file).replace_extension().generic_string(); }

/// The word that ends before a place of a text; empty where none does.
std::string word_before(const std::string& text, std::size_t at) {
  std::size_t from = at;
  while (from > 0 && (std::isalnum(static_cast<unsigned char>(text[from - 1])) != 0 || text[from - 1] == '_')) --from;
  return text.substr(from, at - from);
}

/// The functions that a header names.
std::set<std::string> named_in(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t at = text.find('('); at != std::string::npos; at = text.find('(', at + 1))
    names.insert(word_before(text, at));
  names.erase("");
  return names;
}

/// The functions that a source defines: they begin at the left edge.
std::set<std::string> defined_in(const std::string& text) {
  std::set<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || std::isalpha(static_cast<unsigned char>(line[0])) == 0) continue;
    const std::size_t at = line.find('(');
    if (at != std::string::npos && line.find('=') > at) names.insert(word_before(line, at));
  }
  names.erase("");
  return names;
}

/// The headers of its own room that a file includes, directly or over others of the room.
std::set<std::string> headers_of(const std::string& file, const std::vector<Arrow>& arrows) {
  std::set<std::string> found;
  std::vector<std::string> left{file};
  while (!left.empty()) {
    const std::string from = left.back();
    left.pop_back();
    for (const Arrow& arrow : arrows) {
      if (arrow.from == from && room_of(arrow.to) == room_of(file) && found.insert(arrow.to).second)
        left.push_back(arrow.to);
    }
  }
  return found;
}

/// A source without a header of its name belongs to the header that names most of the functions that it defines;
/// otherwise it has a home of its own.
Homes homes_of(const Texts& texts, const std::vector<Arrow>& arrows) {
  Homes homes;
  for (const auto& [file, text] : texts) {
    if (fs::path(file).extension() != ".cpp" || texts.count(stem_of(file) + ".hpp") != 0) continue;
    const std::set<std::string> defined = defined_in(text);
    std::ptrdiff_t most = 0;
    for (const std::string& header : headers_of(file, arrows)) {
      if (texts.count(header) == 0) continue;
      const std::set<std::string> named = named_in(texts.at(header));
      const auto count = std::count_if(defined.begin(), defined.end(),
                                       [&](const std::string& name) { return named.count(name) != 0; });
      if (count > most) most = count, homes[file] = stem_of(header);
    }
  }
  return homes;
}

/// A path from `room` back to it; empty if there is none.
std::string circle_through(const Graph& graph, const std::string& room) {
  std::vector<std::vector<std::string>> ways{{room}};
  std::set<std::string> seen;
  while (!ways.empty()) {
    const auto way = ways.back();
    ways.pop_back();
    const auto found = graph.find(way.back());
    if (found == graph.end()) continue;
    for (const std::string& next : found->second) {
      if (next == room) {
        std::string text;
        for (const std::string& r : way) text += r + " -> ";
        return text + room;
      }
      if (seen.insert(next).second) {
        ways.push_back(way);
        ways.back().push_back(next);
      }
    }
  }
  return "";
}

/// Circles of modules within a room.
std::vector<std::string> circles_of_modules(const std::vector<Arrow>& arrows, const Homes& homes) {
  const auto module_of = [&](const std::string& file) {
    const auto home = homes.find(file);
    return home == homes.end() ? stem_of(file) : home->second;
  };
  Graph used;
  for (const Arrow& arrow : arrows) {
    const std::string from = module_of(arrow.from), to = module_of(arrow.to);
    if (from != to && room_of(from) == room_of(to)) used[from].insert(to);
  }
  std::vector<std::string> found;
  for (const auto& [module, needs] : used) {
    const std::string circle = circle_through(used, module);
    if (!circle.empty()) found.push_back("a circle of modules: " + circle);
  }
  return found;
}

/// What is wrong with the way in which these files lie and include one another, given the rooms that are drawn.
std::vector<std::string> faults(const Graph& drawn, const std::vector<std::string>& files,
                                const std::vector<Arrow>& arrows, const Homes& homes = {}) {
  std::vector<std::string> found = circles_of_modules(arrows, homes);
  std::map<std::string, std::size_t> sizes;
  for (const std::string& file : files) {
    const std::string room = room_of(file);
    if (room == "lib") found.push_back(file + ": no file stands in the root of lib");
    ++sizes[room];
  }
  for (const auto& [room, size] : sizes) {
    if (drawn.count(room) == 0) found.push_back(room + ": not in the graph of docs/architecture.md");
    if (size > largest_room) found.push_back(room + ": holds " + std::to_string(size) + " files");
  }
  Graph used;
  for (const Arrow& arrow : arrows) {
    const std::string from = room_of(arrow.from), to = room_of(arrow.to);
    if (from == to) continue;
    const std::string here = storey_of(from), there = storey_of(to);
    if (height_of(there) > height_of(here) || (here != there && height_of(there) == height_of(here)))
      found.push_back(arrow.from + " includes " + arrow.to + ": against lib <- calculators <- cli");
    if (here == there) used[from].insert(to);
  }
  for (const auto& [room, needs] : used) {
    const std::string circle = circle_through(used, room);
    if (!circle.empty()) found.push_back("a circle of folders: " + circle);
    for (const std::string& needed : needs) {
      if (drawn.count(room) != 0 && drawn.at(room).count(needed) == 0)
        found.push_back(room + " needs " + needed + ": not drawn in docs/architecture.md");
    }
  }
  for (const auto& [room, needs] : drawn) {
    if (sizes.count(room) == 0) found.push_back(room + ": drawn in docs/architecture.md, and not there");
    for (const std::string& needed : needs) {
      if (used[room].count(needed) == 0)
        found.push_back(room + " -> " + needed + ": drawn in docs/architecture.md, and no file needs it");
    }
  }
  return found;
}

bool tells(const std::vector<std::string>& found, const std::string& words) {
  return std::any_of(found.begin(), found.end(),
                     [&](const std::string& fault) { return fault.find(words) != std::string::npos; });
}

}  // namespace

TEST_SUITE("layout") {
  TEST_CASE("the sources are placed and include one another as docs/architecture.md draws it") {
    const Texts texts = read_sources(LOADPATH_ROOT);
    const auto arrows = includes_of(texts);
    REQUIRE(arrows.size() > 1000);
    std::vector<std::string> found;
    const Graph drawn = read_graph(text_of(fs::path(LOADPATH_ROOT) / "docs/architecture.md"), found);
    for (const std::string& fault : found) FAIL_CHECK(fault);
    for (const std::string& fault : faults(drawn, files_of(texts), arrows, homes_of(texts, arrows))) FAIL_CHECK(fault);
  }

  TEST_CASE("a circle of folders is reported") {
    const Graph drawn{{"lib/a", {"lib/b"}}, {"lib/b", {"lib/a"}}};
    const auto found =
        faults(drawn, {"lib/a/x.hpp", "lib/b/y.hpp"}, {{"lib/a/x.hpp", "lib/b/y.hpp"}, {"lib/b/y.hpp", "lib/a/x.hpp"}});
    CHECK(tells(found, "a circle of folders: lib/a -> lib/b -> lib/a"));
  }

  TEST_CASE("a circle of modules is reported, also one over a third") {
    const Graph drawn{{"lib/a", {}}};
    const auto over = [&](const std::vector<Arrow>& arrows) {
      return faults(drawn, {"lib/a/x.hpp", "lib/a/x.cpp", "lib/a/y.hpp", "lib/a/z.hpp"}, arrows);
    };
    CHECK(tells(over({{"lib/a/x.cpp", "lib/a/y.hpp"}, {"lib/a/y.hpp", "lib/a/x.hpp"}}),
                "a circle of modules: lib/a/x -> lib/a/y -> lib/a/x"));
    CHECK(tells(over({{"lib/a/x.cpp", "lib/a/y.hpp"}, {"lib/a/y.hpp", "lib/a/z.hpp"}, {"lib/a/z.hpp", "lib/a/x.hpp"}}),
                "a circle of modules: lib/a/x -> lib/a/y -> lib/a/z -> lib/a/x"));
    CHECK(
        over({{"lib/a/x.cpp", "lib/a/x.hpp"}, {"lib/a/x.cpp", "lib/a/y.hpp"}, {"lib/a/y.hpp", "lib/a/z.hpp"}}).empty());
  }

  TEST_CASE("a source without a header of its name belongs to the one whose functions it defines") {
    const Texts texts{{"lib/a/x.hpp", "#include \"lib/a/y.hpp\"\nstruct X {\n  double area(double d);\n};\n"},
                      {"lib/a/y.hpp", "double width(double d);\n"},
                      {"lib/a/rules.cpp",
                       "#include \"lib/a/x.hpp\"\n#include \"lib/a/z.hpp\"\n"
                       "double X::area(double d) {\n  return width(d);\n}\n"},
                      {"lib/a/z.hpp", "#include \"lib/a/x.hpp\"\n"},
                      {"lib/a/alone.cpp", "#include \"lib/a/x.hpp\"\nint main() {}\n"}};
    const auto arrows = includes_of(texts);
    const Homes homes = homes_of(texts, arrows);
    REQUIRE(homes.count("lib/a/rules.cpp") == 1);
    CHECK(homes.at("lib/a/rules.cpp") == "lib/a/x");
    CHECK(homes.count("lib/a/alone.cpp") == 0);
    CHECK(tells(faults({{"lib/a", {}}}, files_of(texts), arrows, homes), "a circle of modules: lib/a/x -> lib/a/z"));
  }

  TEST_CASE("a box that is drawn twice is reported") {
    std::vector<std::string> found;
    const Graph drawn = read_graph("```rooms\nlib/a:\nlib/b: lib/a\nlib/a:\n```\n", found);
    CHECK(drawn.size() == 2);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == "lib/a: drawn twice in docs/architecture.md");
  }

  TEST_CASE("an arrow that points up is reported") {
    const Graph drawn{{"lib/a", {}}, {"calculators/b", {}}};
    const auto found = faults(drawn, {"lib/a/x.hpp", "calculators/b/y.hpp"}, {{"lib/a/x.hpp", "calculators/b/y.hpp"}});
    CHECK(tells(found, "against lib <- calculators <- cli"));
  }

  TEST_CASE("a file in the root of lib is reported, and so is a folder that is not drawn, or does not exist") {
    const auto found = faults({{"lib/gone", {}}}, {"lib/x.hpp", "lib/new/y.hpp"}, {});
    CHECK(tells(found, "lib/x.hpp: no file stands in the root of lib"));
    CHECK(tells(found, "lib/new: not in the graph"));
    CHECK(tells(found, "lib/gone: drawn in docs/architecture.md, and not there"));
  }

  TEST_CASE("an arrow that is not drawn, or drawn and not needed, is reported") {
    const std::vector<std::string> files{"lib/a/x.hpp", "lib/b/y.hpp"};
    CHECK(tells(faults({{"lib/a", {}}, {"lib/b", {}}}, files, {{"lib/a/x.hpp", "lib/b/y.hpp"}}),
                "lib/a needs lib/b: not drawn"));
    CHECK(tells(faults({{"lib/a", {"lib/b"}}, {"lib/b", {}}}, files, {}), "no file needs it"));
  }

  TEST_CASE("a folder has at most 26 files") {
    std::vector<std::string> files;
    for (int i = 0; i < 27; ++i) files.push_back("lib/a/" + std::to_string(i) + ".hpp");
    CHECK(tells(faults({{"lib/a", {}}}, files, {}), "lib/a: holds 27 files"));
  }

  TEST_CASE("a source that a comment names exists") {
    const Texts texts = read_sources(LOADPATH_ROOT);
    std::set<std::string> names;
    for (const std::string& file : files_of(texts)) names.insert(fs::path(file).filename().string());
    const std::regex comment("// ?[^\n]*"), source("[a-z_0-9]+[.][ch]pp");
    for (const auto& source_text : texts) {
      const std::string &file = source_text.first, &text = source_text.second;
      for (std::sregex_iterator i(text.begin(), text.end(), comment), end; i != end; ++i) {
        const std::string line = i->str();
        for (std::sregex_iterator k(line.begin(), line.end(), source); k != end; ++k)
          CHECK_MESSAGE(names.count(k->str()) == 1, file, " names ", k->str());
      }
    }
  }
}
