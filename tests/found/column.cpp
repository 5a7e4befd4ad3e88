// Regression tests of bars under a normal force: faults found in use.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string of(const std::string& lines, const std::string& id) {
  return mode_with("column.buckling", "d = \nsigma_P = \nn_st = \nP = \n" + lines, id);
}

const std::string hea =
    "ends = \"pinned_pinned\"\nl = \"4 m\"\nP = \"300 kN\"\nsection = \"HEA 160\"\nE = \"210 GPa\"\nR_e = \"235 "
    "MPa\"\n";
const std::string ec3 = "method = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\n";
const std::string secant = "method = \"secant\"\nn_st = 1\n";

/// A box 400 mm wide and 200 mm high with webs of 12 mm; its area and moments by its rectangles.
std::string box(double t_f, const std::string& E) {
  const double h = 200.0, b = 400.0, t_w = 12.0, b_i = b - 2.0 * t_w, h_i = h - 2.0 * t_f;
  return "ends = \"pinned_pinned\"\nl = \"3 m\"\nP = \"100 kN\"\nkind = \"welded_box\"\nh = \"200 mm\"\nb = \"400 "
         "mm\"\n"
         "t_w = \"12 mm\"\nt_f = \"" +
         std::to_string(t_f) + " mm\"\nA = \"" + std::to_string(b * h - b_i * h_i) + " mm^2\"\nI_y = \"" +
         std::to_string((b * h * h * h - b_i * h_i * h_i * h_i) / 12.0) + " mm^4\"\nI_z = \"" +
         std::to_string((h * b * b * b - h_i * b_i * b_i * b_i) / 12.0) + " mm^4\"\nR_e = \"235 MPa\"\nE = \"" + E +
         "\"\nmethod = \"johnson\"\nn_st = 2\n";
}

std::string rolled(const std::string& section, const std::string& P, const std::string& l) {
  return "ends = \"pinned_pinned\"\nsection = \"" + section + "\"\nP = \"" + P + "\"\nl = \"" + l +
         "\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\n" + ec3;
}

}  // namespace

TEST_SUITE("found column") {
  TEST_CASE("A1: 300 kN at 300 mm from the axis of an HEA 160, for which the secant formula gives 135.6 kN") {
    const std::string far = "e_y = \"300 mm\"\n", compared = "because.n_st = \"compared with the formula\"";
    CHECK(of(hea + ec3, "buckling") == "pass");
    CHECK(of(hea + ec3, "eccentric") == "none");
    CHECK(of(hea + ec3 + far, "eccentric") == "not-judged");
    CHECK(of(hea + ec3 + far, "lateral_torsional") == "not-judged");
    CHECK(of(hea + secant + far, "eccentric") == "fail");
    CHECK(of(hea + secant + far + "P = \"135 kN\"\n" + compared, "eccentric") == "pass");
    CHECK(of(hea + secant + far + "P = \"136 kN\"", "eccentric") == "fail");
  }

  TEST_CASE("A1: the lightest section for an eccentric load") {
    CHECK(mode_with("column.lightest", "", "buckling") == "pass");
    CHECK(mode_with("column.lightest", "", "eccentric") == "none");
    CHECK(mode_with("column.lightest", "e_y = \"300 mm\"", "eccentric") == "not-judged");
  }

  TEST_CASE("A3: the force of a moving link does not act alone: its inertia bends the link, and both vary") {
    const auto project = solved_as_found(R"([project]
title = "A rod"

[crank]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
links.slider.mass = "2 kg"
crank = { speed = "600 rpm", positions = 36 }

[rod]
calculator = "column.buckling"
N = "=crank.links.rod.N"
l = "200 mm"
d = "12 mm"
ends = "pinned_pinned"
E = "210 GPa"
R_e = "355 MPa"
method = "johnson"
n_st = 3
n_t = 2
)");
    for (const char* id : {"buckling", "tension"}) CHECK(mode_of(project, "rod", id) == "pass");
    for (const char* id : {"lateral", "fatigue"}) CHECK(mode_of(project, "rod", id) == "not-judged");
  }

  TEST_CASE("A5: tension needs its own safety factor, and gamma_F of ec3 counts") {
    const std::string bar =
        "N = \"107 kN\"\nl = \"160 mm\"\nd = \"25 mm\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e = \"225 MPa\"\n"
        "kind = \"solid\"\n";
    const std::string johnson = "method = \"johnson\"\nn_st = 2\n";
    CHECK(of(bar + johnson, "tension") == "not-judged");
    CHECK(of(bar + johnson + "n_t = 2", "tension") == "fail");
    CHECK(of(bar + johnson + "n_t = 1", "tension") == "not-judged");
    CHECK(of(bar + johnson + "n_t = 1\nbecause.n_t = \"proof load\"", "tension") == "pass");
    CHECK(of(bar + johnson + "N = \"50 kN\"\nn_t = 2", "tension") == "pass");
    CHECK(of(bar + johnson, "buckling") == "none");
    CHECK(of(bar + johnson, "net_section") == "open");
    CHECK(of(bar + ec3 + "n_t = 1", "tension") == "fail");
    CHECK(of(bar + johnson + "N = \"-50 kN\"", "tension") == "none");
  }

  TEST_CASE("A17: a flange of 6 mm between webs of a box, c/t = 62.7 of 42") {
    const ExampleStep thin("column.buckling", "d = \nsigma_P = \n" + box(6.0, "210 GPa"));
    CHECK(std::abs(thin("r_class") - 376.0 / 6.0 / 42.0) < 1e-9);
    CHECK(of(box(6.0, "210 GPa"), "local") == "not-covered");
    CHECK(of(box(10.0, "210 GPa"), "local") == "pass");
  }

  TEST_CASE("the wall of a tube of aluminium by its modulus: d/t up to 90 x 235/R_e x E/210 GPa") {
    const auto tube = [](const std::string& d_bore, const std::string& E = "70 GPa") {
      return "R_e = \"240 MPa\"\nsigma_P = \"160 MPa\"\nd = \"40 mm\"\nd_bore = \"" + d_bore + "\"\nE = \"" + E +
             "\"\nP = \"3 kN\"\nl = \"1.2 m\"\nends = \"pinned_pinned\"\nmaterial_class = \"other\"\nmethod = "
             "\"euler\"\nn_st = 3";
    };
    const ExampleStep thick("column.buckling", tube("32 mm"));
    CHECK(std::abs(thick("r_class") - 10.0 / (90.0 * 235.0 / 240.0 / 3.0)) < 1e-9);
    CHECK(of(tube("32 mm"), "local") == "pass");
    CHECK(of(tube("37.4 mm"), "local") == "not-covered");          // d/t = 30.8 of 29.4
    CHECK(of(tube("32 mm", "12 GPa"), "local") == "not-covered");  // timber
  }

  TEST_CASE("the walls of a box of aluminium: width/thickness up to 15 sqrt(250 MPa/R_e)") {
    const auto square = [](const std::string& t, const std::string& E = "70 GPa") {
      return "d = \nsigma_P = \"140 MPa\"\nkind = \"welded_box\"\nh = \"150 mm\"\nb = \"150 mm\"\nt_w = \"" + t +
             "\"\nE = \"" + E + "\"\nR_e = \"200 MPa\"\nP = \"30 kN\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nn_st = 3";
    };
    const ExampleStep thick("column.buckling", square("8 mm"));
    CHECK(std::abs(thick("r_class") - 134.0 / 8.0 / (15.0 * std::sqrt(250.0 / 200.0))) < 1e-9);
    CHECK(of(square("8 mm"), "local") == "pass");
    CHECK(of(square("7.5 mm"), "local") == "not-covered");           // 18 of 16.8
    CHECK(of(square("8 mm", "100 GPa"), "local") == "not-covered");  // of another metal
  }

  TEST_CASE("A18: the section classes of steel do not apply to aluminium, nor do its buckling curves") {
    CHECK(of(box(10.0, "70 GPa"), "local") == "not-covered");
    CHECK(of(box(10.0, "210 GPa") + "material_class = \"other\"", "local") == "not-judged");
    CHECK_FALSE(ExampleStep("column.buckling", "d = \nsigma_P = \n" + hea + ec3 + "E = \"70 GPa\"").fault().empty());
  }

  TEST_CASE("A19: channels and angles twist when they buckle; typed values without an outline may") {
    const std::string held = "supports_z = [[\"1.5 m\"], [\"3 m\"], [\"4.5 m\"]]";
    CHECK(of(rolled("UPN 200", "340 kN", "6 m") + held, "torsional_flexural") == "fail");
    CHECK(of(rolled("UPN 200", "340 kN", "6 m") + held, "buckling") == "pass");
    CHECK(of(rolled("UPN 200", "300 kN", "6 m") + held, "torsional_flexural") == "pass");
    CHECK(of(rolled("L 100x100x10", "285 kN", "0.8 m"), "torsional_flexural") == "fail");
    CHECK(of(rolled("L 100x100x10", "285 kN", "0.8 m"), "buckling") == "pass");
    CHECK(of(rolled("L 100x100x10", "275 kN", "0.8 m"), "torsional_flexural") == "pass");
    CHECK(of(rolled("HEA 160", "300 kN", "4 m"), "torsional") == "open");
    const std::string typed =
        "ends = \"pinned_pinned\"\nP = \"10 kN\"\nl = \"2 m\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nA = \"2000 mm^2\"\n"
        "I_y = \"3e6 mm^4\"\nI_z = \"1e6 mm^4\"\nmethod = \"johnson\"\nn_st = 2\n";
    CHECK(of(typed, "torsional") == "not-judged");
    CHECK(of(typed, "local") == "not-judged");
    CHECK(of(typed, "buckling") == "pass");
    CHECK(mode_with("column.lightest", "families = [\"UPN\"]", "torsional_flexural") == "pass");
    CHECK(mode_with("column.lightest", "", "torsional") == "open");
  }

  TEST_CASE("a solid bar has no walls, and passes by its buckling alone") {
    const std::string bar = "d = \"45 mm\"\nP = \"40 kN\"\nn_st = 3\nsigma_P = \"270 MPa\"\n";
    for (const char* id : {"local", "torsional", "lateral_torsional", "tension"}) CHECK(of(bar, id) == "none");
    CHECK(of(bar, "buckling") == "pass");
  }

  TEST_CASE("no verdict is better than its checks: a bar in tension for which no section is found has not passed") {
    const auto tie = [](const char* N) {
      return solved_as_found("[bar]\ncalculator = \"column.lightest\"\nfamilies = [\"CHS\"]\nl = \"4 m\"\nN = \"" +
                             std::string(N) +
                             "\"\nmaterial = \"S235JR\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = "
                             "1\ngamma_F = 1.4\n");
    };
    // a tie needs no curve of buckling, but a safety of its own
    const auto borne = tie("300 kN");
    CHECK(mode_of(borne, "bar", "tension") == "not-judged");
    CHECK(account::overall(project::modes(borne)) != account::State::pass);
    // the largest of the tables has 95819 mm^2, which yields at 22.5 MN
    const auto project = tie("30000 kN");
    CHECK(mode_of(project, "bar", "tension") == "fail");
    REQUIRE(account::worst(project::verdicts(project)) != account::State::pass);
    CHECK(account::rank(account::overall(project::modes(project))) >=
          account::rank(account::worst(project::verdicts(project))));
  }

  TEST_CASE("a slenderness above the allowable one fails") {
    // l = 0.9 m, fixed and free, d = 45 mm: 2 * 900 / (45/4) = 160
    CHECK(mode_with("column.buckling", "lambda_max = 159", "slenderness") == "fail");
    CHECK(mode_with("column.buckling", "lambda_max = 161", "slenderness") == "pass");
  }
}
