#include "lib/project/references/order.hpp"

#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string step(const std::string& name, const std::string& T) {
  return "[" + name + "]\ncalculator = \"shaft.torsion\"\nT = \"" + T + "\"\ntau_adm = \"30 MPa\"\n";
}

std::vector<std::string> order_of(const std::string& text) {
  const auto project = solved(text);
  std::vector<std::string> names;
  for (const std::size_t i : project.order) names.push_back(project.steps[i]->name());
  return names;
}

/// A rod next to a press whose force depends on an input of the rod that has a default value.
std::string press_and_rod(const std::string& source, const std::string& lines = "") {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"200 mm\"\n"
         "crank = { speed = \"120 rpm\" }\nloads = [{ name = \"work\", link = \"slider\", at = \"B\", "
         "F_x = \"=-40 N*rod.lambda_max\", F_y = \"0 N\" }]\n\n[rod]\ncalculator = \"link.member\"\nload = \"=" +
         source +
         "\"\nh = \"=0.2*press.l\"\nb = \"20 mm\"\nends = \"pinned_pinned\"\nmaterial = \"S235\"\n"
         "method = \"johnson\"\nn_st = 3\nS = 2\n" +
         lines;
}

}  // namespace

TEST_SUITE("project order") {
  TEST_CASE("a step comes after those that it refers to, otherwise in the order of the file") {
    CHECK(order_of(step("d", "=b.M_max + c.M_max") + step("a", "1 N*m") + step("c", "=a.M_max") +
                   step("b", "=a.M_max")) == std::vector<std::string>{"a", "b", "c", "d"});
    CHECK(order_of(step("b", "1 N*m") + step("a", "1 N*m")) == std::vector<std::string>{"b", "a"});
  }

  TEST_CASE("a circle of references is reported with its members") {
    CHECK(
        issues_of(step("a", "=1 N*m + b.M_max") + step("b", "=c.M_max") + step("c", "=a.M_max")) ==
        "a.toml:1:2: error: circular reference between steps: a -> b -> c -> a\n1 | [a]\n  |  ^\n"
        "  = help: a.T takes b.M_max (line 3), b.T takes c.M_max (line 7), c.T takes a.M_max (line 11): write a value "
        "instead of one of these references\n");
    const std::string own = issues_of(step("a", "=a.M_max"));
    CHECK(own.starts_with("a.toml:1:2: error: circular reference between steps: a -> a\n"));
    CHECK(own.find("help: a.T takes a.M_max (line 3): write a value instead") != std::string::npos);
  }

  TEST_CASE(
      "a size of a row that is searched for with the loads of its taker: the row, or its sizes, are to be given") {
    const std::string said = issues_of(
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"80 GPa\"\nR_e = \"370 MPa\"\nS_F = 1.5\npieces "
        "= [{ l "
        "= \"20 mm\", d = \"=bl.d\" }, { l = \"200 mm\", d = \"50 mm\" }]\nsupports = [{ name = \"left\", x = \"10 "
        "mm\" "
        "}, { x = \"210 mm\" }]\nseats = [{ x = \"110 mm\", F_x = \"4 kN\" }]\n\n[bl]\ncalculator = "
        "\"bearing.rolling\"\nload = \"=axle.bearings.left\"\nn = \"900 rpm\"\nbearing = { stock = \"bearing/62\" "
        "}\nL_h = \"10000 h\"\ns_0 = 1\n");
    CHECK_MESSAGE(said.find("circular reference between steps: axle -> bl -> axle") != std::string::npos, said);
    CHECK_MESSAGE(said.find("bl.d is of the row that 'bl' searches for: name a row there, bearing = \"...\", or") !=
                      std::string::npos,
                  said);
    CHECK_MESSAGE(said.find("bearing = { where = \"d = ... mm\" }") != std::string::npos, said);
  }

  TEST_CASE("a step outside of the circle is not named in it") {
    const std::string said = issues_of(step("first", "=a.M_max") + step("a", "=b.M_max") + step("b", "=a.M_max"));
    CHECK(said.starts_with("a.toml:5:2: error: circular reference between steps: a -> b -> a\n"));
    CHECK(said.find("first") == std::string::npos);
  }

  TEST_CASE("a default value is certain if no record of a mechanism may replace it") {
    const std::string circle = "circular reference between steps: press -> rod -> press";
    CHECK(issues_of(press_and_rod("press.links.rod")).find(circle) != std::string::npos);
    CHECK(order_of(press_and_rod("press.links.rod", "lambda_max = 200\n")) == std::vector<std::string>{"press", "rod"});
    const std::string unknown = issues_of(press_and_rod("hammer.links.rod"));
    CHECK_MESSAGE(unknown.find("hammer") != std::string::npos, unknown);
    CHECK_MESSAGE(unknown.find("circular") == std::string::npos, unknown);
  }
}
