// Typed values next to bounds that change from point to point, and steps that are compared with no other: columns have
// the numbers of single designs.
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

struct Solved {
  std::size_t alone = 0;
  std::vector<double> states;
};

Solved solved(const std::string& text, const std::string& result) {
  const std::vector<std::string> results{result};
  const Swept swept(text, results, 1, {}, catalogue());
  REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
  project::Variants variants(swept.read_again(), results);
  std::vector<const double*> in;
  for (const auto& column : swept.inputs) in.push_back(column.data());
  Solved all{.states = swept.column("state")};
  const std::size_t count = all.states.size();
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
    CHECK(found[0][i] == machine.value(result)->si[0]);
    CHECK(all.states[i] == static_cast<double>(account::overall(project::modes(machine))));
  }
  all.alone = variants.solved_alone();
  return all;
}

}  // namespace

TEST_SUITE("sweep: kept bounds") {
  const std::string tie =
      "[tie]\ncalculator = \"pin.en1993\"\nF = \"150 kN\"\ngamma_F = 1.4\ngamma_M0 = 1\ngamma_M2 = 1.25\n"
      "d_0 = \"51 mm\"\nt_1 = \"30 mm\"\nt_2 = \"18 mm\"\nc = \"2 mm\"\nf_yp = \"355 MPa\"\nf_up = \"490 MPa\"\n"
      "f_y_1 = \"235 MPa\"\nf_y_2 = \"235 MPa\"\ne_a1 = \"55 mm\"\ne_c1 = \"35 mm\"\ne_a2 = \"55 mm\"\n"
      "e_c2 = \"35 mm\"\n";

  TEST_CASE("a hole wider than 1.1 times its pin is solved alone at the thin pins only") {
    const Solved all = solved(tie + "d = [\"50 mm\", \"48 mm\", \"44 mm\", \"47 mm\", \"45 mm\"]\n", "tie.u_v");
    CHECK(all.alone == 2);  // 51 mm is above 1.1 * 44 mm and 1.1 * 45 mm
    CHECK(all.states[1] == all.states[0]);
    CHECK(all.states[2] != all.states[0]);  // what the hole decides is held back
  }

  TEST_CASE("a varied hole is compared at each point") {
    std::string varied = tie;
    varied.replace(varied.find("\"51 mm\""), 7, "[\"51 mm\", \"54 mm\", \"56 mm\"]");
    const Solved all = solved(varied + "d = \"50 mm\"\n", "tie.u_v");
    CHECK(all.alone == 3);
    CHECK(all.states[2] != all.states[0]);  // 56 mm is above 1.1 * 50 mm
  }

  TEST_CASE("a part by itself is compared with no other: columns") {
    const std::string seat =
        "[seat]\ncalculator = \"shaft.spline\"\nT = \"640 N*m\"\ntorque = \"one_way\"\nK_A = 1.25\n"
        "spline = \"8x52x60\"\nl = { from = \"20 mm\", to = \"60 mm\", count = 9 }\nhub = \"fixed\"\n"
        "centring = \"inner\"\nR_e_1 = \"370 MPa\"\nS_F = 1.5\nR_e_2 = \"300 MPa\"\n";
    CHECK(solved(seat, "seat.p").alone == 0);
    const std::string bar =
        "[bar]\ncalculator = \"shaft.held\"\nend_1 = \"held\"\nend_2 = \"elastic\"\n"
        "c_2 = { from = \"40 kN*m/rad\", to = \"80 kN*m/rad\", count = 9 }\n"
        "segments = [{ name = \"root\", l = \"300 mm\", d = \"60 mm\" }, { name = \"tip\", l = \"400 mm\", d = \"40 "
        "mm\" }]\n"
        "torques = [{ name = \"lever\", x = \"500 mm\", T = \"900 N*m\" }]\nG = \"80 GPa\"\n"
        "sigma_adm = \"120 MPa\"\nbehaviour = \"ductile\"\nphi_adm = \"1 deg\"\n";
    CHECK(solved(bar, "bar.R_2").alone == 0);
  }
}
