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
}
