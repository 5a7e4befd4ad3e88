// Steps of one body, and typed strengths next to a material, in columns: the numbers of the points as single designs.
#include "calculators/catalogue.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/variants.hpp"
#include "tests/lib/project/sweep/swept.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

using namespace loadpath;
using test::Swept;

std::string shaft(const std::string& torque, const std::string& more, const std::string& end) {
  return "[values]\nT = { from = \"200 N*m\", to = \"500 N*m\", count = 20 }\n[shaft]\ncalculator = "
         "\"shaft.torsion\"\nbody = \"shaft\"\ntau_adm = \"30 MPa\"\nT = " +
         torque + "\n" + more +
         "[end]\ncalculator = \"shaft.overhung\"\nbody = \"shaft\"\nF = \"9 kN\"\na = \"40 mm\"\n" +
         "T = \"=values.T\"\nsigma_adm = \"60 MPa\"\n" + end;
}

/// The points solved as single designs; every point has the bits that it has as one.
std::size_t solved_alone(const std::string& text, const std::vector<std::string>& results) {
  const Swept swept(text, results, 1, {}, catalogue());
  REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
  const std::size_t count = swept.column("state").size();
  project::Variants variants(swept.read_again(), results);
  std::vector<const double*> in;
  for (const auto& column : swept.inputs) in.push_back(column.data());
  std::vector<std::vector<double>> found(variants.outputs(), std::vector<double>(count));
  std::vector<double*> out;
  for (auto& column : found) out.push_back(column.data());
  variants.evaluate(in, out, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Issue> issues;
    project::Project machine = swept.read_again();
    project::set_point(machine, swept.plan, i, issues);
    project::solve(machine, issues);
    REQUIRE(!has_errors(issues));
    for (std::size_t k = 0; k < results.size(); ++k) {
      const Value* const alone = machine.value(results[k]);
      REQUIRE(alone != nullptr);
      CHECK_MESSAGE(found[k][i] == alone->si[0], results[k], " at point ", i);
    }
  }
  return variants.solved_alone();
}

}  // namespace

TEST_SUITE("sweep bodies") {
  TEST_CASE("a body has the larger size of its steps at every point") {
    const std::vector<std::string> results{"shaft.d", "end.d", "shaft.tau_max"};
    CHECK(solved_alone(shaft("\"=values.T\"", "", ""), results) == 0);
  }

  TEST_CASE("where one step states a lower torque, its body alone is solved point by point") {
    const std::vector<std::string> results{"shaft.d", "end.d", "shaft.tau_max"};
    CHECK(solved_alone(shaft("\"150 N*m\"", "", ""), results) == 0);
    CHECK(solved_alone(shaft("\"300 N*m\"", "", ""), results) == 0);  // at some points in the other step
    CHECK(solved_alone(shaft("\"200 N*m\"", "", ""), results) > 0);   // not yet at the first point
    const std::string reason = "because.T = \"between the wheels\"\n";
    CHECK(solved_alone(shaft("\"150 N*m\"", reason, ""), results) == 0);
  }

  TEST_CASE("walls of one vessel are compared at every point") {
    const std::string text =
        "[closed]\ncalculator = \"vessel.cylinder\"\np = [\"1.6 MPa\", \"0.2 MPa\", \"2 MPa\"]\nR = \"600 mm\"\n"
        "delta = \"12 mm\"\nsigma_adm = \"140 MPa\"\nhypothesis = \"membrane\"\n"
        "[ball]\ncalculator = \"vessel.sphere\"\np = \"1.6 MPa\"\nR = \"600 mm\"\ndelta = \"12 mm\"\n"
        "sigma_adm = \"140 MPa\"\n";
    const double pass = account::number(account::State::pass), held = account::number(account::State::not_judged);
    CHECK(Swept(text, {}, 1, {}, catalogue()).column("state") == std::vector{pass, held, held});
    std::string sizes = text;
    sizes.replace(sizes.find("[\"1.6"), std::string("[\"1.6 MPa\", \"0.2 MPa\", \"2 MPa\"]").size(), "\"1.6 MPa\"");
    sizes.replace(sizes.find("\"12 mm\""), std::string("\"12 mm\"").size(), "[\"12 mm\", \"14 mm\"]");
    CHECK(solved_alone(sizes, {"closed.sigma_v"}) == 0);
  }

  TEST_CASE("a step is compared with the values of the file at every point") {
    const std::string text = R"([values]
P = "7.5 kW"
n_motor = ["720 rpm", "1450 rpm"]
n_fan = "720 rpm"
[belt]
calculator = "belt.v_sizing"
basis = "optibelt"
P = "=values.P"
K_A = 1.2
n_1 = "=values.n_motor"
n_2_set = "=values.n_fan"
a_set = "600 mm"
[shaft]
title = "Shaft of the fan"
calculator = "shaft.torsion"
T = "=values.P/values.n_motor"
K_A = 1.2
d = "80 mm"
tau_adm = "30 MPa"
accept.fatigue = "steady torque, plain shaft without notches"
)";
    const double pass = account::number(account::State::pass), held = account::number(account::State::not_judged);
    CHECK(Swept(text, {}, 1, {}, catalogue()).column("state") == std::vector{pass, held});
  }

  TEST_CASE("a mechanism, and shafts without stated forces that take its results, are solved in columns") {
    const std::string lever =
        "[lever]\ncalculator = \"mechanism.planar\"\ncrank = { joint = \"O\", speed = \"45 rad/s\", positions = 36 }\n"
        "[lever.ground]\nO = [\"90 mm\", \"0 mm\"]\nB = [\"0 mm\", \"0 mm\"]\n"
        "[lever.links.crank]\nangle = \"-60 deg\"\npoints = { O = [\"0 mm\", \"0 mm\"], A = [\"30 mm\", \"0 mm\"] }\n"
        "[lever.links.lever]\nangle = \"-14 deg\"\npoints = { B = [\"0 mm\", \"0 mm\"], C = [\"40 mm\", \"0 mm\"] }\n"
        "[lever.joints]\nO = { type = \"revolute\", links = [\"ground\", \"crank\"] }\n"
        "B = { type = \"revolute\", links = [\"ground\", \"lever\"] }\n"
        "A = { type = \"slot\", links = [\"crank\", \"lever\"], points = [\"A\", \"B\"], direction = \"0 deg\" }\n"
        "[[lever.loads]]\nname = \"F3\"\nlink = \"lever\"\nat = \"C\"\naxes = \"link\"\ndirection = \"-90 deg\"\n"
        "F = { from = \"500 N\", to = \"900 N\", count = 9 }\n";
    const std::string shafts =
        "[crankshaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(lever.drive.M)\"\ntau_adm = \"30 MPa\"\n"
        "[end]\ncalculator = \"shaft.overhung\"\nload = \"=lever.drive\"\na = \"50 mm\"\nsigma_adm = \"60 MPa\"\nd = "
        "\"?\"\n";
    CHECK(solved_alone(lever + shafts, {"crankshaft.d", "crankshaft.tau_max"}) == 0);
  }

  TEST_CASE("a varied allowable stress is compared with the material in a column, up to its strength") {
    const std::string text =
        "[s]\ncalculator = \"shaft.torsion\"\nT = \"700 N*m\"\nmaterial = \"C45E\"\ntheta_adm = \"0.25 deg/m\"\n"
        "tau_adm = { from = \"30 MPa\", to = \"";
    CHECK(solved_alone(text + "100 MPa\", count = 20 }\n", {"s.d"}) == 0);
    const std::size_t above = solved_alone(text + "300 MPa\", count = 20 }\n", {"s.d"});
    CHECK(above > 0);
    CHECK(above < 20);
  }
}
