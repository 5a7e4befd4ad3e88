// Several projects in one run, and outputs on standard output.
#include "tests/cli/process.hpp"

#include <boost/json.hpp>

using namespace loadpath::test;
namespace json = boost::json;

namespace {

const std::string passing = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n";
const std::string failing = passing + "d = \"40 mm\"\n";
const std::string wrong = "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 mpa\"\n";
const std::string press = R"toml([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 12 }
)toml";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two projects in folders of their own, one next to them, and a file that is not a project.
void fill(const Desk& desk) {
  for (const char* folder : {"all", "all/press", "all/axle", "all/.git"})
    std::filesystem::create_directory(desk.folder() / folder);
  desk.put("all/press/project.toml", press);
  desk.put("all/axle/project.toml", passing);
  desk.put("all/weak.toml", failing);
  desk.put("all/steel.toml", "[steels.A]\nR_e = \"200 MPa\"\n");
  desk.put("all/.git/old.toml", wrong);
  desk.put("all/readme.txt", "[");
}

}  // namespace

TEST_SUITE("cli several projects") {
  TEST_CASE("a folder means every project in it, by their paths, and the worst exit code counts") {
    const Desk desk;
    fill(desk);
    const Ran ran = desk.run({"run", "all"});
    CHECK(ran.code == 1);
    const std::size_t axle = ran.out.find("== all/axle/project.toml\n"), last = ran.out.find("== all/weak.toml\n");
    CHECK(axle == 0);
    CHECK(ran.out.find("== all/press/project.toml\n") < last);
    CHECK(last != std::string::npos);
    CHECK(ran.out.ends_with(
        "3 projects\n  pass           all/axle/project.toml\n  pass           all/press/project.toml\n"
        "  does not pass  all/weak.toml\n"));
    CHECK(desk.run({"run", "all/axle/project.toml", "all/press"}).code == 0);
    CHECK(desk.run({"run", "all/press", "all/press/project.toml", "./all/press"})
              .out.ends_with("1 projects\n  pass  all/press/project.toml\n"));
  }

  TEST_CASE("an error in one file does not stop the others") {
    const Desk desk;
    fill(desk);
    desk.put("all/bad.toml", wrong);
    const Ran ran = desk.run({"run", "all", "missing.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "all/bad.toml:4:"));
    CHECK(contains(ran.error, "cannot read 'missing.toml'"));
    CHECK(contains(ran.out, "  not solved     all/bad.toml\n"));
    CHECK(contains(ran.out, "  pass           all/axle/project.toml\n"));
  }

  TEST_CASE("with --json they are one list of objects") {
    const Desk desk;
    fill(desk);
    desk.put("all/bad.toml", wrong);
    const Ran ran = desk.run({"run", "all", "missing.toml", "--json"});
    const json::array all = json::parse(ran.out).as_array();
    REQUIRE(all.size() == 4);
    CHECK(all[0].at("project").at("file") == "all/axle/project.toml");
    CHECK(all[1].at("issues").as_array().size() == 1);
  }

  TEST_CASE("outputs have the name of each project; one for all is refused, and so are two equal ones") {
    const Desk desk;
    fill(desk);
    const Ran ran = desk.run({"run", "all", "--report", "out/*.html", "--csv", "out/*", "--quiet"});
    CHECK(ran.code == 1);
    for (const char* file : {"out/axle.html", "out/press.html", "out/weak.html", "out/press/press.csv"}) {
      CAPTURE(file);
      CHECK(desk.has(file));
    }
    const Ran one = desk.run({"run", "all", "--report", "out.html"});
    CHECK(one.code == 2);
    CHECK(contains(one.error, "'out.html' is one output, but every project needs its own\n  = help: "));
    CHECK_FALSE(desk.has("out.html"));
    CHECK(desk.run({"run", "all", "--csv", "series"}).code == 2);
    CHECK(desk.run({"run", "all", "--report", "html:-"}).code == 2);
    CHECK(contains(desk.run({"run", "all", "--point", "0"}).error, "'--point' needs a single project"));
    desk.put("all/axle/weak.toml", passing);
    CHECK(contains(desk.run({"run", "all/weak.toml", "all/axle", "--report", "out/*.md"}).error,
                   "two projects would write to 'out/weak.md'"));
  }

  TEST_CASE("a folder without a project is reported") {
    const Desk desk;
    std::filesystem::create_directory(desk.folder() / "none");
    const Ran ran = desk.run({"run", "none"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "no project file in 'none'"));
  }

  TEST_CASE("a report, a table or a drawing is the only thing on standard output") {
    const Desk desk;
    desk.put("press.toml", press);
    const Ran report = desk.run({"run", "press.toml", "--report", "html:-"});
    CHECK(report.code == 0);
    CHECK(report.out.starts_with("<!doctype html>"));
    CHECK(report.out.ends_with("</html>\n"));
    CHECK(desk.run({"run", "press.toml", "--report", "a.html", "--quiet"}).code == 0);
    CHECK(desk.get("a.html") == report.out);
    const Ran table = desk.run({"run", "-", "--csv", "-"}, press);
    CHECK(table.code == 0);
    CHECK(desk.run({"run", "press.toml", "--csv", "a.csv", "--quiet"}).code == 0);
    CHECK(desk.get("a.csv") == table.out);
    CHECK(desk.run({"mechanism", "planar", "--file", "press.toml", "--svg", "-"}).out.starts_with("<svg"));
    CHECK(contains(desk.run({"mechanism", "planar", "--file", "press.toml", "--dxf", "-"}).out, "\nSECTION\n"));
    CHECK(desk.files() == std::vector<std::string>{"a.csv", "a.html", "press.toml"});
  }

  TEST_CASE("outputs that do not fit on standard output are refused") {
    const Desk desk;
    desk.put("press.toml", press);
    const Ran kind = desk.run({"run", "press.toml", "--report", "-"});
    CHECK(kind.code == 2);
    CHECK(contains(kind.error, "write --report html:-"));
    CHECK(desk.run({"run", "press.toml", "--report", "md:-"}).code == 2);
    const Ran two = desk.run({"run", "press.toml", "--report", "html:-", "--json"});
    CHECK(two.code == 2);
    CHECK(contains(two.error, "'--report html:-' and '--json' both write to standard output"));
    CHECK(desk.run({"run", "press.toml", "--csv", "-", "--report", "html:-"}).code == 2);
    CHECK(contains(desk.run({"run", "-", "--csv", "-"}, press + press.substr(7).insert(0, "[other]")).error,
                   "is one file, and 2"));
    CHECK(desk.files() == std::vector<std::string>{"press.toml"});
  }
}
