// A reason answers one contradiction of its input, and those that it names.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A lug with a quarter of a stated load, and a larger load that nothing takes.
std::string net(const std::string& values, const std::string& reason) {
  const std::string text =
      "[values]\nW = \"80 kN\"\n" + values +
      "\n[eye]\ncalculator = \"pin.lug\"\nF = \"=values.W/4\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 "
      "mm\"\nt = \"25 mm\"\np_adm = \"90 MPa\"\nmaterial = \"S355\"\nS = 2\n" +
      (reason.empty() ? "" : "because.F = \"" + reason + "\"\n");
  return mode_of(solved_as_found(text), "eye", "net");
}

}  // namespace

TEST_SUITE("project: reasons") {
  TEST_CASE("a reason answers one contradiction of its input") {
    CHECK(net("", "") == "not-judged");
    CHECK(net("", "four legs, spreader, sheet 3") == "pass");
    CHECK(net("F_test = \"50 kN\"\n", "four legs, spreader, sheet 3") == "not-judged");
    CHECK(net("F_test = \"50 kN\"\n", "four legs, spreader, sheet 3; F_test is that of the hoist") == "pass");
    CHECK(net("F_idle = \"5 kN\"\n", "four legs, spreader, sheet 3") == "pass");
  }
}
