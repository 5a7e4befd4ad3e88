#include "lib/project/project.hpp"

#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

TEST_SUITE("project") {
  TEST_CASE("a step without a calculator is reported with how to name one") {
    CHECK(issues_of("[axle]\nT = \"9 N*m\"\n") == R"(a.toml:1:2: error: the step 'axle' has no calculator
1 | [axle]
  |  ^^^^
  = help: write calculator = "shaft.torsion"; `loadpath list` shows all
)");
  }

  TEST_CASE("an unknown calculator is reported with the nearest one") {
    CHECK(issues_of("[axle]\ncalculator = \"shaft.torsoin\"\n") ==
          R"(a.toml:2:15: error: unknown calculator 'shaft.torsoin'
2 | calculator = "shaft.torsoin"
  |               ^^^^^^^^^^^^^
  = help: did you mean 'shaft.torsion'?
)");
  }

  TEST_CASE("a wrong value is reported once, at its place") {
    const std::string rest = "\"\ntau_adm = \"30 MPa\"\n", torsion = "calculator = \"shaft.torsion\"\nT = \"";
    const auto said = [&](const std::string& T) {
      return issues_of("[values]\nd = \"60 mm\"\nT = \"" + T + "\"\n[a]\n" + torsion + "=values.T" + rest + "[b]\n" +
                       torsion + "=values.T" + rest + "[c]\n" + torsion + "=2*values.T" + rest);
    };
    const auto errors_in = [](const std::string& text) {
      int count = 0;
      for (std::size_t at = text.find("error: "); at != std::string::npos; at = text.find("error: ", at + 1)) ++count;
      return count;
    };
    const std::string step = said("=value.d*3 kN"), dimension = said("=values.d*3 kW"),
                      sum = said("=max(values.d, 3 N)");
    for (const std::string& one : {step, dimension, sum}) {
      CHECK_MESSAGE(errors_in(one) == 1, one);
      CHECK(one.find("a.toml:3:") != std::string::npos);
    }
    CHECK(step.find("unknown step 'value'") != std::string::npos);
    CHECK(dimension.find("'T' is a moment") != std::string::npos);
    CHECK(sum.find("cannot be compared") != std::string::npos);
  }

  TEST_CASE("the words of a project file cannot name a step, those of the shell can") {
    CHECK(issues_of("[shaft]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\ntau_adm = \"30 MPa\"\n").empty());
    for (const char* word : {"values", "tables"}) {
      CAPTURE(word);
      const std::string said = issues_of("[" + std::string(word) + "]\ncalculator = \"shaft.torsion\"\n");
      CHECK(said.starts_with("a.toml:1:2: error: '" + std::string(word) +
                             "' is a reserved name and cannot name a step\n"));
    }
  }

  TEST_CASE("a step's name outside ASCII is refused, in quotes and without") {
    CHECK(issues_of("[\"вал\"]\ncalculator = \"shaft.torsion\"\n") ==
          R"(a.toml:1:2: error: 'вал' is not a valid name of a step
1 | ["вал"]
  |  ^^^^^
  = help: a name has Latin letters, digits and '_', and does not start with a digit
)");
    CHECK(issues_of("[вал]\ncalculator = \"shaft.torsion\"\n")
              .ends_with("  = help: a name has Latin letters, digits and '_'\n"));
  }

  TEST_CASE("a missing input is shown as in the example, and a calculator is suggested by the keys") {
    CHECK(issues_of("[a]\ncalculator = \"column.lightest\"\nP = \"9 kN\"\nl = \"2 m\"\n")
              .find("help: for example families = [\"") != std::string::npos);
    CHECK(issues_of("[a]\npieces = []\nsupports = []\nseats = []\n").find("write calculator = \"shaft.design\"") !=
          std::string::npos);
    CHECK(
        issues_of("[a]\ncalculator = \"shaft.key\"\nmaterial = \"C45E\"\n").find("help: give R_e_1 (yield strength") !=
        std::string::npos);
  }

  TEST_CASE("keys of another calculator are reported once, with its name") {
    const std::string said = issues_of(
        "[a]\ncalculator = \"shaft.torsion\"\npieces = [{ l = \"20 mm\", d = \"9 mm\" }]\n"
        "supports = [{ x = \"1 mm\" }]\nseats = [{ x = \"9 mm\" }]\nnotches = []\n");
    CHECK_MESSAGE(
        said.starts_with("a.toml:2:15: error: 'shaft.torsion' has no inputs pieces, supports, seats, notches\n"), said);
    CHECK_MESSAGE(said.ends_with("help: did you mean calculator = \"shaft.design\"?\n"), said);
  }

  TEST_CASE("for a load that is positive by definition the value without its sign is suggested") {
    CHECK(issues_of("[a]\ncalculator = \"column.buckling\"\nl = \"2 m\"\nP = \"-1 kN\"\n")
              .find("help: P: compressive force, replaces N; write it without the sign") != std::string::npos);
  }

  TEST_CASE("two pairs of brackets and a word in place of a size are reported with the right form") {
    CHECK(issues_of("[[a]]\ncalculator = \"shaft.torsion\"\n").ends_with("help: write one pair of brackets: [a]\n"));
    CHECK(issues_of("[a]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\nd = \"auto\"\n")
              .ends_with("; to have it found: d = \"?\"\n"));
  }

  TEST_CASE("a key outside a step is refused") {
    CHECK(issues_of("T = \"9 N*m\"\n") == R"(a.toml:1:1: error: 'T' is outside a step
1 | T = "9 N*m"
  | ^
  = help: a project file consists of tables: [crankshaft]
)");
  }

  TEST_CASE("an empty project is refused") {
    const std::string said =
        "a.toml: error: the project has no steps\n  = help: a step is a table with a key calculator = \"...\"\n";
    CHECK(issues_of("") == said);
    CHECK(issues_of("[project]\ntitle = \"nothing\"\n") == said);
  }

  TEST_CASE("the heading has its own keys") {
    CHECK(issues_of("[project]\ntitel = \"Drive\"\nauthor = 3\n" + axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n") ==
          R"(a.toml:2:1: error: 'titel' is not a valid key here
2 | titel = "Drive"
  | ^^^^^
  = help: did you mean 'title'?
a.toml:3:10: error: 'project.author' takes a text, not a number
3 | author = 3
  |          ^
)");
    const auto project =
        solved("[project]\ntitle = \"Drive\"\nnumber = \"7\"\n" + axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n");
    CHECK(project.title == "Drive");
    CHECK(project.meta == std::vector<std::pair<std::string, std::string>>{{"number", "7"}});
  }

  TEST_CASE("the people who sign have the words of the report; their earlier names are read, too") {
    const std::string step = axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n";
    const auto project = solved("[project]\nauthor = \"Lin\"\nchecked = \"Ada\"\n" + step);
    CHECK(project.meta == std::vector<std::pair<std::string, std::string>>{{"prepared", "Lin"}, {"checked", "Ada"}});
    CHECK(issues_of("[project]\nauthor = \"Lin\"\nprepared = \"Ada\"\n" + step) ==
          R"(a.toml:3:1: error: 'prepared' is given twice, once by its earlier name
3 | prepared = "Ada"
  | ^^^^^^^^
  = help: keep 'prepared'
)");
  }

  TEST_CASE("more tables than a project can have are refused before they are read") {
    std::string text;
    for (int i = 0; i < 100001; ++i) text += "[s" + std::to_string(i) + "]\ncalculator = \"shaft.torsion\"\n";
    CHECK(
        issues_of(text).starts_with("a.toml:200001:2: error: a project has at most 100000 tables; there are 100001\n"));
  }

  TEST_CASE("steps keep the order of the file") {
    const auto project = solved(
        "[b]\ncalculator = \"shaft.torsion\"\nT = \"=a.M_max\"\ntau_adm = \"30 MPa\"\n"
        "[a]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\n");
    CHECK(project.steps[0]->name() == "b");
    CHECK(project.steps[1]->name() == "a");
    CHECK(value(project, "b.M_max") == doctest::Approx(9.0));
  }

  TEST_CASE("results are shown in the unit that the step requests") {
    const auto project = solved(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\ndisplay = { d_min = \"in\" }\n");
    const auto& results = project.find("axle")->account().results;
    const auto d_min = std::find_if(results.begin(), results.end(), [](const auto& e) { return e.path == "d_min"; });
    REQUIRE(d_min != results.end());
    CHECK(d_min->unit == "in");
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\ndisplay = { d_min = \"kg\", d_mn = \"mm\" }\n") ==
          R"(a.toml:5:22: error: 'd_min' is shown in a unit like mm, not in kg
5 | display = { d_min = "kg", d_mn = "mm" }
  |                      ^^
a.toml:5:27: error: 'axle' has no result 'd_mn'
5 | display = { d_min = "kg", d_mn = "mm" }
  |                           ^^^^
  = help: did you mean 'd_min'?
)");
  }

  TEST_CASE("values without display-only data are the same values") {
    const std::string text =
        bar_that_cannot_turn(36) + "[axle]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\n" + "tau_adm = \"30 MPa\"\n";
    const auto all = told(text).project;
    std::vector<Issue> issues;
    auto values = project::read_project(text, "a.toml", catalogue(), issues);
    project::solve(values, issues, {.pictures = false, .formulas = false});
    CHECK(issues.empty());
    CHECK_FALSE(all.steps[1]->account().derivation.empty());
    for (std::size_t n = 0; n < all.steps.size(); ++n) {
      const auto &account = values.steps[n]->account(), &full = all.steps[n]->account();
      CHECK_FALSE((full.figures.empty() && full.blocks.empty() && n == 0));
      CHECK(account.figures.empty());
      CHECK(account.blocks.empty());
      CHECK(account.input_blocks.empty());
      CHECK(account.derivation.empty());
      CHECK(account.scopes == full.scopes);
      CHECK(account.verdicts.size() == full.verdicts.size());
      REQUIRE(account.results.size() == full.results.size());
      for (std::size_t k = 0; k < account.results.size(); ++k) {
        const auto &a = account.results[k].value.si, &b = full.results[k].value.si;
        CHECK(std::equal(a.begin(), a.end(), b.begin(), b.end(),
                         [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }));
      }
    }
  }

  TEST_CASE("series that are not requested have no values, and what other steps take of them is the same") {
    const std::string text =
        replaced(bar_that_cannot_turn(36), "positions = 36", "positions = 36, at = [\"30 deg\", \"60 deg\"]");
    const std::string two =
        replaced(text, "positions = 36, ", "") +
        "[axle]\ncalculator = \"shaft.overhung\"\nF = \"=bar.joints.D.F\"\nT = \"=peak(bar.drive.M)\"\n"
        "a = \"50 mm\"\nsigma_adm = \"60 MPa\"\n";
    const auto all = solved(two);
    std::vector<Issue> issues;
    auto some = project::read_project(two, "a.toml", catalogue(), issues);
    project::solve(some, issues, {.pictures = false, .series = project::SeriesChoice({"links.b.N"})});
    CHECK(issues.empty());
    const auto values = [](const project::Project& project, const std::string& path) {
      const Value* value = project.value(path);
      INFO(path);
      REQUIRE(value != nullptr);
      return value->si;
    };
    CHECK(some.value("bar.links.b.phi") == nullptr);
    for (const char* path : {"bar.links.b.N", "axle.d_min", "axle.u_v"}) CHECK(values(some, path) == values(all, path));
  }

  TEST_CASE("an element is found by its number even if it has a name") {
    const auto project = solved(
        "[course]\ncalculator = \"belt.course\"\npulleys = [{ name = \"a\", x = \"0 mm\", y = \"0 mm\", d = \"100 mm\" "
        "}, "
        "{ name = \"b\", x = \"500 mm\", y = \"0 mm\", d = \"200 mm\" }]\n");
    CHECK(project.value("course.pulleys[2].alpha") == project.value("course.pulleys.b.alpha"));
    CHECK(project.value("course.pulleys[3].alpha") == nullptr);
  }

  TEST_CASE("a number of teeth that is not given is missing") {
    CHECK(first_error("[chain_1]\ncalculator = \"chain.roller\"\nchain = \"16B\"\nz_1 = 21\na = \"1 m\"\n") ==
          "'z_2' is missing: number of teeth, driven sprocket");
  }
}
