// Tables that a project brings along: in its own text, and in files that it names.
#include "lib/toml/tree.hpp"
#include "tests/cli/process.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The blocks of TOML in a page of the guide.
std::vector<std::string> blocks_of(const std::string& page) {
  std::string text;
  REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + "/docs/" + page, text));
  std::vector<std::string> blocks;
  const std::string open = "```toml\n", close = "\n```";
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    const std::size_t end = text.find(close, at);
    blocks.push_back(text.substr(at + open.size(), end + 1 - at - open.size()));
    at = end;
  }
  return blocks;
}

const std::string steels = R"(table = "mine/steels"
group = "material"
units = { R_e = "MPa", size_max = "mm" }
[[row]]
name = "M"
by_size = [{ size_max = 16, R_e = 291 }]
sources = ["certificate"]
[sources]
certificate = "certificate 4711"
)";

const std::string shell = R"([shell]
calculator = "vessel.cylinder"
p = "2 MPa"
R = "600 mm"
delta = "12 mm"
material = "M"
S = 1.5
)";

}  // namespace

TEST_SUITE("cli own tables") {
  TEST_CASE("the page on own tables runs, and its rows are described as the project's own") {
    const auto blocks = blocks_of("own-tables.md");
    REQUIRE(blocks.size() == 4);
    const Desk desk;
    desk.put("boiler.toml", blocks[0]);
    const Ran o = desk.run({"run", "boiler.toml", "--json", "--report", "boiler.md"});
    CAPTURE(o.error);
    CHECK((o.code <= 1 || o.code == 4));
    const std::string source = "own table of the project: inspection certificate 3.1, no. 4711 of 2026-03-02";
    CHECK(contains(o.out, "plate 4711, " + source));
    CHECK(contains(desk.get("boiler.md"), source));
    CHECK(contains(o.out, "own table of the project: store list of 2026-05"));
    desk.put("steels.toml", blocks[2]);
    desk.put("press.toml",
             blocks[1] + shell.substr(0, shell.find("material")) + "material = \"P265GH, 4711\"\nS = 1.5\n");
    CHECK(contains(desk.run({"run", "press.toml", "--json"}).out, source));
    desk.put("bearing.toml", blocks[3]);
    const Ran bearing = desk.run({"run", "bearing.toml", "--json"});
    CHECK_MESSAGE(contains(bearing.out, "list of the manufacturer, 2026, page 12"), bearing.error);
  }

  TEST_CASE("a file of tables is found next to the project, from any working directory") {
    const Desk desk;
    std::filesystem::create_directories(desk.folder() / "work");
    desk.put("work/own.toml", steels);
    desk.put("work/a.toml", "[project]\ntables = [\"own.toml\"]\n" + shell);
    CHECK(contains(desk.run({"run", "work/a.toml", "--json"}).out, "M, own table of the project: certificate 4711"));
    CHECK(contains(desk.run({"vessel", "cylinder", "--file", "work/a.toml", "--delta", "10 mm", "--json"}).out,
                   "M, own table of the project: certificate 4711"));
  }

  TEST_CASE("a file that cannot be read is reported with its place, and nothing is written") {
    const Desk desk;
    desk.put("big.toml", std::string((std::size_t{4} << 20U) + 1, '#'));
    for (const auto& [file, said] : {std::pair{"no.toml", "no file 'no.toml'"},
                                     {"/dev/zero", "is not a text file"},
                                     {".", "is not a text file"},
                                     {"big.toml", "is larger than 4 MiB"}}) {
      const std::string name = file;
      CAPTURE(name);
      desk.put("a.toml", "[project]\ntables = [\"" + name + "\"]\n" + shell);
      const Ran o = desk.run({"run", "a.toml", "--report", "a.md"});
      CHECK(o.code == 2);
      CHECK(contains(o.error, said));
      CHECK(contains(o.error, "a.toml:2:12: error: "));
      CHECK_FALSE(desk.has("a.md"));
    }
    desk.put("a.toml", "[project]\ntables = \"own.toml\"\n" + shell);
    CHECK(contains(desk.run({"run", "a.toml"}).error, "= help: write tables = [\"own.toml\"]"));
  }

  TEST_CASE("errors in such a file are shown with their line") {
    const Desk desk;
    desk.put("own.toml", steels + "sourcess = 1\n");
    desk.put("a.toml", "[project]\ntables = [\"own.toml\"]\n" + shell);
    const Ran wrong = desk.run({"run", "a.toml"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.error, "own.toml:"));
    desk.put("own.toml",
             "table = \"mine\"\ngroup = \"material\"\nunits = { Re = \"MPa\" }\n[[row]]\nname = \"M\"\nRe = "
             "3\nrecalled = true\n");
    CHECK(contains(desk.run({"run", "a.toml"}).error,
                   "own.toml:3:11: error: the material tables have no column 'Re'\n3 | units = { Re = \"MPa\" }\n"));
  }

  TEST_CASE("a table of the project cannot be overwritten by a report") {
    const Desk desk;
    desk.put("own.md", steels);
    desk.put("a.toml", "[project]\ntables = [\"own.md\"]\n" + shell);
    const Ran o = desk.run({"run", "a.toml", "--report", "own.md"});
    CHECK(o.code == 2);
    CHECK(contains(o.error, "is read by the project: nothing is written"));
    CHECK(desk.get("own.md") == steels);
  }
}
