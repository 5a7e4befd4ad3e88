#include "calculators/vessel/ends/end.hpp"

#include "tests/calculators/vessel/vessel_tests.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::End;
using EndForm = End::Form;

/// Outside diameter of 2000 mm whatever the thickness is, f = 150 MPa, R_e = 265 MPa.
End::Input end_2000(EndForm form, Length delta) {
  End::Input in;
  in.p = 1.0 * MPa, in.form = form, in.delta = delta;
  in.D_i = 2000.0 * mm - 2.0 * delta;
  in.sigma_adm = 150.0 * MPa, in.R_e = 265.0 * MPa, in.R_m = 410.0 * MPa;
  return in;
}

End::Result end(const End::Input& in) { return solve<End>(in); }

std::string state_of(const std::string& text, std::string_view step, std::string_view mode) {
  return test::mode_of(test::solved_as_found(text), step, mode);
}

const std::string tank = R"([project]
title = "Tank"

[tank]
calculator = "vessel.cylinder"
p = "1 MPa"
R = "600 mm"
measured = "inner"
c = "1 mm"
sigma_adm = "150 MPa"

)";

}  // namespace

TEST_SUITE("vessel.end") {
  // The required thicknesses were computed independently, by bisection.
  TEST_CASE("Klöpper and Korbbogen ends of 2000 mm: 11.560 and 7.640 mm, both by yielding of the knuckle") {
    const auto kloepper = end(end_2000(EndForm::kloepper, 11.5602487686 * mm));
    CHECK(std::abs(kloepper.u_y - 1.0) < 1e-9);
    CHECK(std::abs(kloepper.beta - 0.91487779) < 1e-8);
    CHECK(rel(in_si(kloepper.delta_min), 0.0115602487686) < 1e-3);  // of the same inside diameter
    const auto korbbogen = end(end_2000(EndForm::korbbogen, 7.6401915713 * mm));
    CHECK(std::abs(korbbogen.u_y - 1.0) < 1e-9);
    CHECK(std::abs(korbbogen.beta - 0.71763868) < 1e-8);
    CHECK(korbbogen.u_b < 1.0);
    CHECK(korbbogen.u_s < 1.0);
  }

  TEST_CASE("the minimum thickness just carries the pressure, allowances included") {
    for (const EndForm form : {EndForm::kloepper, EndForm::korbbogen, EndForm::ellipsoidal, EndForm::hemispherical}) {
      for (const double p : {0.3, 1.0, 4.0}) {
        End::Input in = end_2000(form, 10.0 * mm);
        in.p = p * MPa, in.c = 1.5 * mm, in.f_t = 0.1, in.z = 0.85;
        in.delta = end(in).delta_min;
        CAPTURE(p);
        CHECK(rel(in_si(end(in).p_max), p * 1e6) < 1e-9);
      }
    }
  }

  TEST_CASE("a hemisphere needs half of its cylinder's thickness; its long flange does not pass with that") {
    End::Input in = end_2000(EndForm::hemispherical, 4.0 * mm);
    in.l_f = 40.0 * mm;
    CHECK(rel(end(in).u_f, 2.0 * end(in).u_s) < 1e-12);
    in.l_f = 10.0 * mm;
    CHECK(end(in).u_f == 0.0);
  }

  TEST_CASE("the seam of the crown does not weaken the knuckle") {
    End::Input in = end_2000(EndForm::kloepper, 12.0 * mm);
    const auto seamless = end(in);
    in.z = 0.7;
    CHECK(rel(end(in).u_s, seamless.u_s / 0.7) < 1e-12);
    CHECK(end(in).u_y == seamless.u_y);
    CHECK(end(in).u_b == seamless.u_b);
  }

  TEST_CASE("a step that takes the shell assesses its ends; one with another pressure does not") {
    const std::string taken =
        "[end]\ncalculator = \"vessel.end\"\nshell = \"=tank.shell\"\nform = \"korbbogen\"\nR_e = \"265 MPa\"\nR_m = "
        "\"410 MPa\"\n";
    CHECK(state_of(tank, "tank", "ends") == "open");
    CHECK(state_of(tank + taken, "tank", "ends") == "pass");
    CHECK(state_of(tank + taken + "delta = \"4 mm\"\n", "tank", "ends") == "fail");
    CHECK(state_of(tank + taken + "p = \"0.5 MPa\"\n", "tank", "ends") != "pass");
    CHECK(test::first_error_of(tank + taken + "c = \"0 mm\"\n").find("contradicts 'tank.shell.c'") !=
          std::string::npos);
  }

  TEST_CASE("an allowable stress alone leaves the buckling of the knuckle open") {
    const std::string step =
        "[end]\ncalculator = \"vessel.end\"\np = \"1 MPa\"\nD_i = \"1200 mm\"\ndelta = \"20 mm\"\n";
    CHECK(state_of(step + "sigma_adm = \"150 MPa\"\nform = \"kloepper\"", "end", "knuckle") == "not-judged");
    CHECK(state_of(step + "sigma_adm = \"150 MPa\"\nform = \"hemispherical\"", "end", "strength") == "pass");
  }

  TEST_CASE("wrong input is refused") {
    const std::string step =
        "calculator = \"vessel.end\"\np = \"1 MPa\"\nD_i = \"1000 mm\"\nsigma_adm = \"150 MPa\"\nR_e = \"265 "
        "MPa\"\nR_m = \"410 MPa\"\n";
    CHECK(says(step + "form = \"torispherical\"", "needs both"));
    CHECK(says(step + "form = \"kloepper\"\nR = \"900 mm\"\nr = \"90 mm\"", "torispherical"));
    CHECK(says(step + "form = \"torispherical\"\nR = \"400 mm\"\nr = \"90 mm\"", "at least half of D_i"));
    CHECK(says(step + "form = \"kloepper\"\nh_i = \"250 mm\"", "ellipsoidal"));
  }
}
