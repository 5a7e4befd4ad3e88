// The rooms of the sources: which folder may include from which is said once, in docs/architecture.md.
#include <doctest/doctest.h>

#include <algorithm>
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

using Graph = std::map<std::string, std::set<std::string>>;  // a room and those that it needs
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

/// The graph between "```rooms" and "```": a room, a colon, the rooms that it needs.
Graph read_graph(const std::string& page) {
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
    auto& needs = graph[room];
    while (words >> needed) needs.insert(needed);
  }
  return graph;
}

/// Every source of the program with what it includes of the program.
std::vector<Arrow> includes_of(const fs::path& root, std::vector<std::string>& files) {
  std::vector<Arrow> arrows;
  const std::regex include("#include \"([^\"]+)\"");
  for (const char* const storey : {"lib", "calculators", "cli", "api"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / storey)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      files.push_back(fs::relative(entry.path(), root).generic_string());
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i)
        arrows.push_back({files.back(), (*i)[1].str()});
    }
  }
  return arrows;
}

/// A way from `room` back to it, in rooms; empty where there is none.
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

/// What is wrong with the way in which these files lie and include one another, given the rooms that are drawn.
std::vector<std::string> faults(const Graph& drawn, const std::vector<std::string>& files,
                                const std::vector<Arrow>& arrows) {
  std::vector<std::string> found;
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
  TEST_CASE("the sources lie and include one another as docs/architecture.md draws it") {
    std::vector<std::string> files;
    const auto arrows = includes_of(LOADPATH_ROOT, files);
    REQUIRE(arrows.size() > 1000);
    const Graph drawn = read_graph(text_of(fs::path(LOADPATH_ROOT) / "docs/architecture.md"));
    for (const std::string& fault : faults(drawn, files, arrows)) FAIL_CHECK(fault);
  }

  TEST_CASE("a circle of folders is told") {
    const Graph drawn{{"lib/a", {"lib/b"}}, {"lib/b", {"lib/a"}}};
    const auto found =
        faults(drawn, {"lib/a/x.hpp", "lib/b/y.hpp"}, {{"lib/a/x.hpp", "lib/b/y.hpp"}, {"lib/b/y.hpp", "lib/a/x.hpp"}});
    CHECK(tells(found, "a circle of folders: lib/a -> lib/b -> lib/a"));
  }

  TEST_CASE("an arrow that points up is told") {
    const Graph drawn{{"lib/a", {}}, {"calculators/b", {}}};
    const auto found = faults(drawn, {"lib/a/x.hpp", "calculators/b/y.hpp"}, {{"lib/a/x.hpp", "calculators/b/y.hpp"}});
    CHECK(tells(found, "against lib <- calculators <- cli"));
  }

  TEST_CASE("a file in the root of lib is told, and so is a room that nobody drew, or that is not there") {
    const auto found = faults({{"lib/gone", {}}}, {"lib/x.hpp", "lib/new/y.hpp"}, {});
    CHECK(tells(found, "lib/x.hpp: no file stands in the root of lib"));
    CHECK(tells(found, "lib/new: not in the graph"));
    CHECK(tells(found, "lib/gone: drawn in docs/architecture.md, and not there"));
  }

  TEST_CASE("an arrow that is not drawn, or drawn and not needed, is told") {
    const std::vector<std::string> files{"lib/a/x.hpp", "lib/b/y.hpp"};
    CHECK(tells(faults({{"lib/a", {}}, {"lib/b", {}}}, files, {{"lib/a/x.hpp", "lib/b/y.hpp"}}),
                "lib/a needs lib/b: not drawn"));
    CHECK(tells(faults({{"lib/a", {"lib/b"}}, {"lib/b", {}}}, files, {}), "no file needs it"));
  }

  TEST_CASE("a room is small enough to be overlooked") {
    std::vector<std::string> files;
    for (int i = 0; i < 27; ++i) files.push_back("lib/a/" + std::to_string(i) + ".hpp");
    CHECK(tells(faults({{"lib/a", {}}}, files, {}), "lib/a: holds 27 files"));
  }

  TEST_CASE("a source that a comment names is there") {
    std::vector<std::string> files;
    includes_of(LOADPATH_ROOT, files);
    std::set<std::string> names;
    for (const std::string& file : files) names.insert(fs::path(file).filename().string());
    const std::regex comment("// ?[^\n]*"), source("[a-z_0-9]+[.][ch]pp");
    for (const std::string& file : files) {
      const std::string text = text_of(fs::path(LOADPATH_ROOT) / file);
      for (std::sregex_iterator i(text.begin(), text.end(), comment), end; i != end; ++i) {
        const std::string line = i->str();
        for (std::sregex_iterator k(line.begin(), line.end(), source); k != end; ++k)
          CHECK_MESSAGE(names.count(k->str()) == 1, file, " names ", k->str());
      }
    }
  }
}
