// Regression tests of built-up sections: faults found in use.
#include "calculators/section/built_up.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string parts(const std::string& list) { return "parts = [" + list + "]"; }

const std::string upn = R"({ section = "UPN 200", y = "10 mm" },)";
const std::string plate = R"({ shape = "rectangle", b = "200 mm", h = "12 mm", z = "-106 mm" },)";

bool is_refused(const std::string& list) {
  const ExampleStep step("section.built_up", parts(list));
  return step.fault().find("overlap") != std::string::npos;
}

bool is_warned(const std::string& list) {
  std::vector<Issue> issues;
  auto project = project::read_project("[girder]\ncalculator = \"section.built_up\"\n" + parts(list), "found.toml",
                                       catalogue(), issues);
  project::solve(project, issues);
  return std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
    return issue.severity == Severity::warning && issue.message.text().find("is not connected") != std::string::npos;
  });
}

}  // namespace

TEST_SUITE("found section") {
  TEST_CASE("A24: the same plate twice is not a bar of two plates") {
    CHECK_FALSE(is_refused(upn + plate));
    CHECK(is_refused(plate + plate));
    CHECK(is_refused(upn + upn));
    CHECK(is_refused(upn + R"({ section = "UPN 200", y = "17 mm" })"));  // through the web of the other
  }

  TEST_CASE("A24: parts that touch do not overlap, whatever their angle; nor does a part in the hollow of another") {
    CHECK_FALSE(is_refused(R"({ shape = "rectangle", b = "20 mm", h = "20 mm", angle = "30 deg" },
                              { shape = "rectangle", b = "20 mm", h = "20 mm", y = "17.3205 mm", z = "10 mm", angle = "30 deg" })"));
    CHECK(is_refused(R"({ shape = "rectangle", b = "20 mm", h = "20 mm", angle = "30 deg" },
                        { shape = "rectangle", b = "20 mm", h = "20 mm", y = "15 mm", z = "9 mm", angle = "30 deg" })"));
    const std::string tube = R"({ shape = "ring", d = "100 mm", d_i = "90 mm" },)";
    CHECK_FALSE(is_refused(tube + R"({ shape = "circle", d = "90 mm" })"));
    CHECK(is_refused(tube + R"({ shape = "circle", d = "95 mm" })"));
    CHECK_FALSE(is_refused(tube + R"({ shape = "rectangle", b = "63.6 mm", h = "63.6 mm" })"));
    CHECK(is_refused(tube + R"({ shape = "rectangle", b = "66 mm", h = "66 mm" })"));
  }

  TEST_CASE("A24: an area covered by two parts may be cut out once") {
    CHECK_FALSE(is_refused(R"({ shape = "rectangle", b = "100 mm", h = "10 mm" },
                              { shape = "rectangle", b = "10 mm", h = "100 mm" },
                              { shape = "rectangle", b = "10 mm", h = "10 mm", as = "hole" })"));
  }

  TEST_CASE("A24: parts 10 m apart are one bar only where they are joined") {
    CHECK_FALSE(is_warned(upn + plate));
    CHECK(is_warned(upn + R"({ name = "far", section = "UPN 200", y = "10 m" })"));
    CHECK(mode_with("section.built_up", parts(upn + plate), "joined") == "open");
    CHECK(mode_with("section.built_up", parts(upn + R"({ section = "UPN 200", y = "10 m" })"), "joined") ==
          "not-judged");
    CHECK(mode_with("section.built_up", parts(plate), "joined") == "none");
  }

  TEST_CASE("B10: an angle with sharp toes has no more torsional stiffness than it should") {
    const auto angle = [](const char* legs, const char* radii) {
      return ExampleStep("section.angle",
                         std::string("h = \"") + legs + "\"\nb = \"" + legs + "\"\nt = \"10 mm\"\n" + radii);
    };
    // over t^4, of 4 and of 10 thicknesses: finite differences of the torsion function, extrapolated over two grids
    CHECK(angle("40 mm", "r = \"0 mm\"\nr_2 = \"0 mm\"").fault().empty());
    for (const std::pair<const char*, double>& row : {std::pair{"60 mm", 3.5284}, std::pair{"100 mm", 6.1951}}) {
      const double I_t = angle(row.first, "r = \"0 mm\"\nr_2 = \"0 mm\"")("I_t"), exact = row.second * 1e-8;
      CHECK_MESSAGE(I_t <= exact, row.first);
      CHECK_MESSAGE(I_t >= 0.985 * exact, row.first);
    }
  }

  TEST_CASE("B10: rounded toes are reached where they are round") {
    // A, W_max, W_min by integrals over a polygon of 4,000 points
    const ExampleStep thick("section.angle",
                            "h = \"120 mm\"\nb = \"60 mm\"\nt = \"12 mm\"\nr = \"6 mm\"\nr_2 = \"12 mm\"");
    CHECK(thick("A") == doctest::Approx(1961.92e-6).epsilon(1e-5));
    CHECK(thick("W_max") == doctest::Approx(37403.8e-9).epsilon(1e-5));
    CHECK(thick("W_min") == doctest::Approx(8381.06e-9).epsilon(1e-5));
    const ExampleStep thin("section.angle",
                           "h = \"200 mm\"\nb = \"100 mm\"\nt = \"10 mm\"\nr = \"15 mm\"\nr_2 = \"7.5 mm\"");
    CHECK(thin("W_max") == doctest::Approx(98369.9e-9).epsilon(1e-5));
    CHECK(thin("W_min") == doctest::Approx(22358.8e-9).epsilon(1e-5));
  }
}

TEST_SUITE("found thin-walled section") {
  TEST_CASE("an open section, a slender wall, and thick ones") {
    const std::string one =
        "cells = [{ name = \"a\", A = \"40000 mm^2\" }]\nwalls = [{ cell = \"a\", l = \"800 mm\", t = ";
    CHECK(mode_with("section.thin_walled", "", "yield") == "pass");
    CHECK(mode_with("section.thin_walled", one + "\"8 mm\" }]", "buckling") == "not-judged");
    CHECK(mode_with("section.thin_walled", one + "\"16 mm\" }]", "buckling") == "none");
    CHECK(mode_with("section.thin_walled", one + "\"60 mm\" }]", "yield") == "not-covered");
    CHECK(mode_with("section.thin_walled", "cells = \nwalls = [{ l = \"800 mm\", t = \"8 mm\" }]", "yield") == "fail");
  }

  TEST_CASE("reversed torque, brittle walls, a wall with its own strength") {
    CHECK(mode_with("section.thin_walled", "T = \"-90 kN*m\"", "yield") == "fail");
    CHECK(mode_with("section.thin_walled", "R_e = \nS = \nsigma_adm = \"20 MPa\"\nbehaviour = \"brittle\"",
                    "fracture") == "fail");
    CHECK(mode_with("section.thin_walled", "K_A = 1.5", "fatigue") == "not-judged");
  }

  TEST_CASE("a cell within a cell is not a cell next to it") {
    const ExampleStep step("section.thin_walled",
                           R"(cells = [{ name = "a", A = "1e4 mm^2" }, { name = "b", A = "2500 mm^2" }]
walls = [{ cell = "a", l = "400 mm", t = "5 mm" }, { cell = "b", beside = "a", l = "200 mm", t = "5 mm" }])");
    CHECK(step.fault().find("lies within") != std::string::npos);
  }

  TEST_CASE("cells of a thin-walled section that overlap, or cross themselves, are refused") {
    const std::string walls =
        "walls = [{ cell = \"a\", l = \"300 mm\", t = \"4 mm\" }, { cell = \"b\", l = \"300 mm\", t = \"4 mm\" }, "
        "{ cell = \"a\", beside = \"b\", l = \"100 mm\", t = \"4 mm\" }]\n";
    const auto fault = [&](const std::string& a, const std::string& b) {
      const std::string cells =
          "cells = [{ name = \"a\", points = [" + a + "] }, { name = \"b\", points = [" + b + "] }]";
      return ExampleStep("section.thin_walled", cells + "\n" + walls).fault();
    };
    const auto box = [](int y, int z) {
      const auto corner = [](int right, int up) {
        return "[\"" + std::to_string(right) + " mm\", \"" + std::to_string(up) + " mm\"]";
      };
      return corner(y, z) + ", " + corner(y + 100, z) + ", " + corner(y + 100, z + 100) + ", " + corner(y, z + 100);
    };
    const std::string beside = "overlap";
    CHECK(fault(box(0, 0), box(100, 0)).empty());  // which share a wall
    CHECK(fault(box(0, 0), box(99, 0)).empty());   // but for rounding
    for (const auto& at : {std::pair{0, 0}, {50, 0}, {0, -50}, {30, 40}, {90, 90}})
      CHECK_MESSAGE(fault(box(0, 0), box(at.first, at.second)).find(beside) != std::string::npos, at.first, " ",
                    at.second);
    const std::string small = R"(["20 mm", "20 mm"], ["60 mm", "20 mm"], ["60 mm", "60 mm"])";
    CHECK(fault(box(0, 0), small).find(beside) != std::string::npos);
    const std::string bow = R"(["0 mm", "0 mm"], ["100 mm", "90 mm"], ["100 mm", "0 mm"], ["0 mm", "100 mm"])";
    CHECK(fault(bow, box(100, 0)).find("meets itself") != std::string::npos);
  }
}
