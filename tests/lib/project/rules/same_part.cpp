// Each condition of the rules for steps that describe the same part.
#include "lib/project/references/machine/same_part.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string bar = "[s]\ncalculator = \"shaft.torsion\"\nT = \"1 kN*m\"\nd = \"50 mm\"\ntau_adm = \"120 MPa\"\n\n";

std::string life(const std::string& lines) {
  return "[l]\n" +
         with_lines(
             "calculator = \"fatigue.life\"\ngroup = \"carbon-steel\"\ncycle = \"=s.cycle\"\nr = -1\nmaterial = "
             "\"C45E\"\nsigma_D = "
             "\"100 MPa\"\nS_D = 1.2\nS_F = 1.2\n",
             lines) +
         "\n";
}

std::string found(const std::string& text) { return inputs_found(&project::values_of_same_part, text, "l"); }

}  // namespace

TEST_SUITE("project: same part") {
  TEST_CASE("a fatigue strength of a thinner bar than the part") {
    CHECK(found(bar + life("d_h = \"30 mm\"")) == "d_h");
    CHECK(found(bar + life("d_h = \"48 mm\"")).empty());
    CHECK(found(bar + life("d_h = \"50 mm\"")).empty());
    CHECK(found(bar + life("d_h = \"60 mm\"")).empty());
    const std::string hollow = with_lines(bar, "d_bore = \"10 mm\"");
    CHECK(found(hollow + life("d_h = \"30 mm\"")).empty());
  }
}
