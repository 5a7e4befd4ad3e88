// Sections of a shaft by DIN 743, FKM and Serensen: as the calculators of sections rate them, and where these say
// nothing.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::Solved;

TEST_SUITE("shaft design schools") {
  TEST_CASE("a section is rated by FKM as in fatigue.fkm, by Serensen as in fatigue.combined") {
    const std::string shaft =
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"900 MPa\"\nR_e = \"700 "
        "MPa\"\nR_z = \"6.3 um\"\npieces = [{ l = \"100 mm\", d = \"42 mm\" }, { l = \"100 mm\", d = \"50 mm\" }]\n"
        "supports = [{ x = \"0 mm\", holds = \"both\" }, { x = \"200 mm\" }]\nseats = [{ name = \"force\", x = "
        "\"150 mm\", F_x = \"10 kN\", F_z = \"40 kN\" }, { x = \"0 mm\", way = \"drives\", T = \"900 N*m\" }, "
        "{ x = \"200 mm\", T = \"900 N*m\" }]\nS_D = 1.5\nr_T = 0.5\n";
    const std::string alloy = "group = \"alloy-steel\"\n";
    const std::string step = "notches = [{ name = \"step\", x = \"100 mm\", kind = \"shoulder\", r = \"2.5 mm\" }]\n";
    const std::string section =
        "R_m = \"900 MPa\"\nR_e = \"700 MPa\"\nnotch = \"shoulder\"\nd = \"42 mm\"\nD = \"50 mm\"\nr = \"2.5 "
        "mm\"\nR_z = \"6.3 um\"\nF_zdm = \"=axle.sections.step.N\"\nF_zda = \"0 N\"\nM_ba = \"250 N*m\"\nM_tm = \"675 "
        "N*m\"\nM_ta = \"225 N*m\"\nf_max = 1\n";
    const std::string alone =
        "[alone]\ncalculator = \"fatigue.fkm\"\nsteel = \"quenched-tempered\"\noverload = \"F2\"\nj_D = 1\n" + section +
        "[din]\ncalculator = \"fatigue.din743\"\nmean = \"proportional\"\n" + section +
        "[sum]\ncalculator = \"fatigue.combined\"\nsigma_m = \"=axle.sections.step.sigma_n\"\nsigma_a = "
        "\"=axle.sections.step.sigma_b\"\ntau_m = \"=0.75*axle.sections.step.tau\"\ntau_a = "
        "\"=0.25*axle.sections.step.tau\"\nsigma_D = \"=din.stresses.bending.sigma_WK\"\ntau_D = "
        "\"=din.stresses.torsion.sigma_WK\"\nK_sigma = \"=din.stresses.bending.K_sigma\"\nK_tau = "
        "\"=din.stresses.torsion.K_sigma\"\nR_m = \"900 MPa\"\nS_D = 1.5\n";
    Solved both(shaft + alloy + step + "method = \"fkm\"\n" + alone);
    REQUIRE_MESSAGE(!has_errors(both.issues), both.messages());
    CHECK(std::abs(both.value("axle.sections.step.N")) == Approx(40e3));
    CHECK(both.value("axle.safeties.step.n_FKM") == Approx(both.value("alone.S_D")));
    CHECK(both.value("axle.safeties.step.n_Serensen") == Approx(both.value("sum.n_Serensen")));
    CHECK(both.value("axle.safeties.step.u_D") == Approx(1.5 / both.value("alone.S_D")));
    Solved by_serensen(shaft + alloy + step + "method = \"serensen\"\n");
    CHECK(by_serensen.value("axle.safeties.step.u_D") == Approx(1.5 / both.value("sum.n_Serensen")));
    // outside of its ranges, and of what is cast, it says nothing
    const std::string sharp = "notches = [{ x = \"100 mm\", kind = \"shoulder\", r = \"0.1 mm\" }]\n";
    for (const std::string method : {"fkm", "serensen"})
      CHECK(Solved(shaft + alloy + sharp + "method = \"" + method + "\"\n").mode("axle.fatigue").state ==
            State::not_covered);
    CHECK(Solved(shaft + "group = \"cast-steel\"\n" + step + "method = \"fkm\"\n").mode("axle.fatigue").state ==
          State::not_covered);
    const test::ExampleStep without_roughness("shaft.design", "method = \"fkm\"");
    CHECK(contains(without_roughness.fault(), "need the roughness R_z"));
  }

  TEST_CASE("a section is rated by DIN 743 as in fatigue.din743, and outside its ranges not at all") {
    const std::string shaft =
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nR_m = \"900 MPa\"\nR_e = \"700 "
        "MPa\"\ngroup = "
        "\"alloy-steel\"\nR_z = \"6.3 um\"\npieces = [{ l = \"100 mm\", d = \"42 mm\" }, { l = \"100 mm\", d = \"50 "
        "mm\" }]\n"
        "supports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ name = \"force\", x = \"150 mm\", F_x = \"10 "
        "kN\" }, { x = \"0 "
        "mm\", way = \"drives\", T = \"900 N*m\" }, { x = \"200 mm\", T = \"900 N*m\" }]\nS_D = 1.5\nr_T = 0.5\n";
    const std::string step = "notches = [{ name = \"step\", x = \"100 mm\", kind = \"shoulder\", r = \"2.5 mm\" }]\n";
    const std::string alone =
        "[alone]\ncalculator = \"fatigue.din743\"\nR_m = \"900 MPa\"\nR_e = \"700 MPa\"\nnotch = \"shoulder\"\nd = "
        "\"42 mm\"\nD = "
        "\"50 mm\"\nr = \"2.5 mm\"\nR_z = \"6.3 um\"\nmean = \"proportional\"\nM_ba = \"250 N*m\"\nM_tm = \"675 "
        "N*m\"\nM_ta = \"225 "
        "N*m\"\nf_max = 1\n";
    Solved both(shaft + step + "method = \"din743\"\n" + alone);
    REQUIRE_MESSAGE(!has_errors(both.issues), both.messages());
    CHECK(both.value("axle.safeties.step.n_DIN743") == Approx(both.value("alone.S_D")));
    CHECK(both.value("axle.safeties.step.u_D") == Approx(1.5 / both.value("alone.S_D")));
    const std::string sharp = "notches = [{ x = \"100 mm\", kind = \"shoulder\", r = \"0.1 mm\" }]\n";  // r/t = 0.025
    CHECK(Solved(shaft + sharp + "method = \"din743\"\n").mode("axle.fatigue").state != State::pass);
    const test::ExampleStep without_roughness("shaft.design", "method = \"din743\"");
    CHECK(contains(without_roughness.fault(), "need the roughness R_z"));
  }
}
