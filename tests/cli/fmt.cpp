// Project files laid out: what it looks like, and that it says the same.
#include "calculators/catalogue.hpp"
#include "lib/export/json.hpp"
#include "lib/project/layout/layout.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/toml/tree.hpp"
#include "tests/cli/process.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

using namespace loadpath;
using namespace loadpath::test;
namespace fs = std::filesystem;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string laid_out(const std::string& text) {
  const Ran ran = Desk().run({"fmt", "-"}, text);
  CHECK(ran.error.empty());
  CHECK(ran.code == 0);
  return ran.out;
}

/// Every project of the examples, the reference cases and the templates.
std::vector<fs::path> all_projects() {
  std::vector<fs::path> files;
  for (const char* folder : {"/examples", "/reference"}) {
    for (const auto& entry : fs::recursive_directory_iterator(LOADPATH_ROOT + std::string(folder))) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// All that is found, to the last digit; what cannot be solved, in words.
std::string found_in(const std::string& text, const std::string& file) {
  std::vector<Issue> issues;
  auto project = project::read_project(text, file, catalogue(), issues, project::Ranges::taken);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false, .unused = false});
  if (!has_errors(issues)) return exports::json_of(project, "", project::SeriesChoice());
  std::string words;
  for (const Issue& issue : issues) words += issue.message.text() + "\n";
  return words;
}

const std::string untidy = R"toml(# What it is.

# Of the shaft.
[shaft]
tau_adm="30  MPa" # allowed
# of the motor
T   =  "900 N·m"
title = 'Shaft'  # its name

calculator = "shaft.torsion"
G = "80GPa"


[[expect]]
value="shaft.d"
is = "56 mm"
within = "1 %"
source = "own"
[project]
revision = "1"
title="A"
)toml";

const std::string tidy = R"toml(# What it is.

[project]
title = "A"
revision = "1"

# Of the shaft.
[shaft]
calculator = "shaft.torsion"
title = "Shaft"  # its name
# of the motor
T = "900 N*m"
tau_adm = "30 MPa"  # allowed

G = "80 GPa"

[[expect]]
value = "shaft.d"
is = "56 mm"
within = "1 %"
source = "own"
)toml";

}  // namespace

TEST_SUITE("cli fmt") {
  TEST_CASE("tables and keys are put in order, comments stay with their lines, blanks are single") {
    CHECK(laid_out(untidy) == tidy);
    CHECK(laid_out(tidy) == tidy);
  }

  TEST_CASE("lists keep their lines, are indented, and their comments stay") {
    const std::string list =
        "[shaft]\ncalculator = \"shaft.torsion\"\ntorques=[ #all\n{name=\"a\",x=\"0mm\",T = '9 N·m'},\n"
        "\t\t{ name = \"10mm\" , x=\"1 m\",T=\"=-2*4 N·m\"  } # last\n   ]\n";
    CHECK(
        laid_out(list) ==
        "[shaft]\ncalculator = \"shaft.torsion\"\ntorques = [  #all\n  { name = \"a\", x = \"0 mm\", T = \"9 N*m\" },\n"
        "  { name = \"10mm\", x = \"1 m\", T = \"=-2*4 N·m\" }  # last\n]\n");
    CHECK(laid_out("[a]\nb=[[1,2],[ ]]\nc = { }\nd.\"x y\" . z={k.m=1,n={}}\n") ==
          "[a]\nb = [[1, 2], []]\nc = {}\nd.\"x y\".z = { k.m = 1, n = {} }\n");
  }

  TEST_CASE("comments of neighbouring lines are aligned, and texts of several lines are unchanged") {
    CHECK(laid_out("[values]\nP = \"1 kN\" # force\nlength = 2    # times\nq = 3\nr = 4 # alone\n") ==
          "[values]\nP = \"1 kN\"  # force\nlength = 2  # times\nq = 3\nr = 4  # alone\n");
    const std::string several =
        "[project]\nnote = \"\"\"\n  one # no comment\n\n\n  \"two\"  \n\"\"\"\ntitle = 'a \"b\" c'\n";
    CHECK(laid_out(several) ==
          "[project]\ntitle = 'a \"b\" c'\nnote = \"\"\"\n  one # no comment\n\n\n  \"two\"  \n\"\"\"\n");
  }

  TEST_CASE("quantities keep their unit and their digits") {
    CHECK(project::plain_quantity("2,50 kN·m") == "2,50 kN*m");
    CHECK(project::plain_quantity("30mm²") == "30 mm^2");
    CHECK(project::plain_quantity("6.3  µm") == "6.3 um");
    CHECK(project::plain_quantity("1-1/2 in") == "1-1/2 in");
    CHECK(project::plain_quantity("120 об/мин") == "120 об/мин");
    CHECK(project::plain_quantity("5%") == "5 %");
    CHECK(project::plain_quantity("0.172 /mm") == "0.172/mm");
    CHECK(project::plain_quantity("1.4") == "1.4");
    CHECK(project::plain_quantity("?") == "?");
    CHECK(project::plain_quantity("IPE 330") == "IPE 330");
  }
}

TEST_SUITE("cli fmt: every project" * by_element) {
  TEST_CASE("a formatted file has the same values to the bit, and does not change again") {
    Share share(3);
    for (const fs::path& file : all_projects()) {
      if (share.skips()) continue;
      CAPTURE(file.string());
      std::string text;
      REQUIRE(toml::read_file(file.string(), text));
      if (!takes(elements_of_project(text).front())) continue;
      std::vector<Issue> issues;
      const std::string once = project::layout_of(text, file.string(), calculators(), issues);
      REQUIRE(issues.empty());
      CHECK(project::layout_of(once, file.string(), calculators(), issues) == once);
      CHECK(found_in(once, file.string()) == found_in(text, file.string()));
    }
  }
}

TEST_SUITE("cli fmt") {
  TEST_CASE("every comment and every key of the examples is kept") {
    for (const fs::path& file : all_projects()) {
      CAPTURE(file.string());
      std::string text;
      REQUIRE(toml::read_file(file.string(), text));
      std::vector<Issue> issues;
      std::string once = project::layout_of(text, file.string(), calculators(), issues);
      const auto marks = [](const std::string& t) { return std::count(t.begin(), t.end(), '#'); };
      CHECK(marks(once) == marks(text));
    }
  }

  TEST_CASE("files are formatted in place where they change, and --check lists those that would") {
    const Desk desk;
    desk.put("a.toml", untidy);
    desk.put("b.toml", tidy);
    const Ran check = desk.run({"fmt", "--check", "a.toml", "b.toml"});
    CHECK(check.code == 1);
    CHECK(check.out == "a.toml\n");
    CHECK(desk.get("a.toml") == untidy);
    const Ran ran = desk.run({"fmt", "a.toml", "b.toml"});
    CHECK(ran.code == 0);
    CHECK(ran.error == "laid out: a.toml\n");
    CHECK(desk.get("a.toml") == tidy);
    CHECK(desk.run({"fmt", "--check", "."}).code == 0);
    CHECK(Desk().run({"fmt", "--check", "-"}, untidy).code == 1);
  }

  TEST_CASE("a file that is not TOML is reported and not written; a project with other errors is formatted") {
    const Desk desk;
    desk.put("a.toml", untidy);
    desk.put("b.toml", "[shaft\n");
    const Ran ran = desk.run({"fmt", "a.toml", "b.toml"});
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, "b.toml:1:"));
    CHECK(desk.get("a.toml") == untidy);
    CHECK(desk.run({"fmt", "missing.toml"}).code == 2);
    CHECK(laid_out("[a]\nx=1\ncalculator=\"shaft.torsio\"\n") == "[a]\nx = 1\ncalculator = \"shaft.torsio\"\n");
  }

  TEST_CASE("every template is already formatted") {
    for (const char* name : {"belt", "column", "mechanism", "shaft", "vessel"}) {
      CAPTURE(name);
      CHECK(Desk().run({"fmt", "--check", "-"}, Desk().run({"init", name, "-"}).out).code == 0);
    }
  }
}
