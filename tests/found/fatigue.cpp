// Regression tests of stress cycles: faults found in use.
#include "tests/cli/process.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <cmath>
#include <fstream>
#include <sys/stat.h>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string symmetric(const std::string& amplitude, const std::string& more = "") {
  return "sigma_max = \"" + amplitude + "\"\nsigma_min = \"-" + amplitude + "\"\n" + more;
}

}  // namespace

TEST_SUITE("found fatigue") {
  TEST_CASE("A2: 382 MPa do not last where the part has 186 MPa") {
    const std::string limit = "sigma_D = \"186 MPa\"\nS_D = 1.5";
    const ExampleStep bad("fatigue.cycle", symmetric("382 MPa", limit));
    CHECK(std::abs(bad("u_D") - 1.5 * 382.0 / 186.0) < 1e-12);
    CHECK(mode_with("fatigue.cycle", symmetric("382 MPa", limit), "fatigue") == "fail");
    CHECK(mode_with("fatigue.cycle", symmetric("123 MPa", limit), "fatigue") == "pass");
    CHECK(mode_with("fatigue.cycle", symmetric("125 MPa", limit), "fatigue") == "fail");
    CHECK(mode_with("fatigue.cycle", symmetric("125 MPa"), "fatigue") == "not-judged");
    CHECK_FALSE(ExampleStep("fatigue.cycle", symmetric("125 MPa", "sigma_D = \"186 MPa\"")).fault().empty());
  }

  TEST_CASE("a tensile mean stress lowers the fully reversed fatigue limit: not covered; compression does not") {
    const std::string limit = "\nsigma_D = \"186 MPa\"\nS_D = 1.5";
    CHECK(mode_with("fatigue.cycle", "sigma_max = \"120 MPa\"\nsigma_min = \"0 MPa\"" + limit, "fatigue") ==
          "not-covered");
    CHECK(mode_with("fatigue.cycle", "sigma_max = \"0 MPa\"\nsigma_min = \"-120 MPa\"" + limit, "fatigue") == "pass");
    CHECK(mode_with("fatigue.cycle", "stress = \"shear\"\nsigma_max = \"0 MPa\"\nsigma_min = \"-120 MPa\"" + limit,
                    "fatigue") == "not-covered");
  }

  TEST_CASE("A2: 900 MPa without a yield strength are not assessed, nor with one that has no safety factor") {
    CHECK(mode_with("fatigue.cycle", symmetric("900 MPa"), "yield") == "not-judged");
    CHECK(mode_with("fatigue.cycle", symmetric("200 MPa", "R_e = \"355 MPa\""), "yield") == "not-judged");
    CHECK(mode_with("fatigue.cycle", symmetric("900 MPa", "R_e = \"355 MPa\""), "yield") == "fail");
    CHECK(mode_with("fatigue.cycle", symmetric("200 MPa", "R_e = \"355 MPa\"\nS_F = 1.5"), "yield") == "pass");
    CHECK(mode_with("fatigue.cycle", symmetric("240 MPa", "R_e = \"355 MPa\"\nS_F = 1.5"), "yield") == "fail");
  }

  TEST_CASE("A29: a fatigue limit above the tensile strength, a design line that most bars do not survive") {
    const std::string measured = "R_m = \"400 MPa\"\nr_n = \nq = 0.8\n";
    CHECK(ExampleStep("fatigue.endurance", measured + "sigma_W = \"200 MPa\"").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.endurance", measured + "sigma_W = \"690 MPa\"").fault().empty());
    CHECK(ExampleStep("fatigue.wohler", "P_s = 0.5").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.wohler", "P_s = 0.01").fault().empty());
  }

  TEST_CASE("a cycle with a mean stress: a part that breaks or yields does not pass, uncovered cases are reported") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.life", lines, mode);
    };
    CHECK(state("", "fatigue") == "pass");
    CHECK(state("", "yield") == "pass");
    CHECK(state("", "multiaxial") == "open");
    CHECK(state("S_F = ", "yield") == "not-judged");
    CHECK(state("S_F = \nR_e = ", "yield") == "not-judged");
    CHECK(state("sigma_max = \"500 MPa\"\nsigma_min = \"460 MPa\"", "yield") == "fail");
    CHECK(state("sigma_max = \"20 MPa\"\nsigma_min = \"-700 MPa\"", "yield") == "fail");
    // mean stresses beyond strength, in both overload types, and by rules without such a bound
    CHECK(state("sigma_max = \"740 MPa\"\nsigma_min = \"739 MPa\"", "fatigue") == "fail");
    CHECK(state("sigma_max = \"740 MPa\"\nsigma_min = \"739 MPa\"\nmean = \"constant\"", "fatigue") == "fail");
    CHECK(state("sigma_max = \"740 MPa\"\nsigma_min = \"739 MPa\"\nrule = \"fkm\"", "yield") == "fail");
    CHECK(state("N = 500", "fatigue") == "not-covered");
    CHECK(state("N = 100000\nR_m = \"1500 MPa\"", "fatigue") == "not-covered");
    CHECK(state("group = \"wrought-aluminium\"\nN = 1000000000", "fatigue") == "not-covered");
    CHECK(state("sigma_max = \"100 MPa\"\nsigma_min = \"100 MPa\"", "fatigue") == "none");
    CHECK_FALSE(ExampleStep("fatigue.life", "group = \"wrought-aluminium\"").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.life", "group = ").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.life",
                            "group = \"cast-aluminium\"\nN = 1e6\nf = 0.8\nrule = \"morrow\"\nsigma_f = "
                            "\"900 MPa\"")
                    .fault()
                    .empty());
  }

  TEST_CASE("a part that breaks at once has not lasted, whatever its curve or its rule, yield assessed or not") {
    const std::string unknown = "R_e = \nS_F = \n";
    const auto history = [&](const std::string& peak) {
      return mode_with(
          "fatigue.history",
          unknown + "mean = \"none\"\nsigma_D = \"300 MPa\"\nk = 3\nblocks = [{ sigma_a = \"" + peak + "\", n = 1 }]",
          "fatigue");
    };
    CHECK(history("690 MPa") == "pass");
    CHECK(history("691 MPa") == "fail");
    CHECK(mode_with("fatigue.history", unknown + "blocks = [{ sigma_a = \"20 MPa\", sigma_m = \"-900 MPa\", n = 1 }]",
                    "fatigue") == "pass");
    const auto life = [&](const std::string& rule, const std::string& peak) {
      return mode_with("fatigue.life", unknown + rule + "\nsigma_max = \"" + peak + "\"\nsigma_min = \"640 MPa\"",
                       "fatigue");
    };
    for (const char* rule : {"rule = \"fkm\"", "rule = \"serensen\"\nK_D = 2"}) {
      INFO(rule);
      CHECK(life(rule, "690 MPa") == "pass");
      CHECK(life(rule, "691 MPa") == "fail");
    }
    const std::string heavy = unknown + "S_D = 1.1\nbecause.S_D = \"tested\"\nsigma_m = ";
    CHECK(mode_with("fatigue.combined", heavy + "\"624 MPa\"", "fatigue") == "pass");
    CHECK(mode_with("fatigue.combined", heavy + "\"625 MPa\"", "fatigue") == "fail");
  }

  TEST_CASE("the fatigue limit of one loading does not apply to another") {
    const auto limit = [](const std::string& loading) {
      return "[limit]\ncalculator = \"fatigue.endurance\"\nR_m = \"690 MPa\"\ngroup = \"carbon-steel\"\nrule = "
             "\"din743\"\nschool = \"serensen\"\nd = \"32 mm\"\nR_z = \"6.3 um\"\nloading = \"" +
             loading + "\"\n";
    };
    const auto says = [&](const std::string& loading, const std::string& taker, const std::string& what) {
      const std::string error = Solved(limit(loading) + "[part]\n" + taker).errors();
      CHECK_MESSAGE(contains(error, what), error);
      if (what.empty()) CHECK_MESSAGE(error.empty(), error);
    };
    const std::string life =
        "calculator = \"fatigue.life\"\nsigma_max = \"90 MPa\"\nsigma_min = \"-20 MPa\"\ngroup = \"carbon-steel\"\nR_m "
        "= \"690 MPa\"\nR_e = \"490 MPa\"\nS_D = 1.2\nS_F = 1.5\n";
    const std::string in_shear =
        "'sigma_D' takes a fatigue limit of a part in shear, and 'limit.sigma_D' is a fatigue limit of a part in "
        "normal stresses";
    says("bending", life + "sigma_D = \"=limit.sigma_D\"\n", "");
    says("tension", life + "sigma_D = \"=limit.sigma_D\"\n", "");
    says("torsion", life + "sigma_D = \"=limit.sigma_D\"\nstress = \"shear\"\n", "");
    says("bending", life + "sigma_D = \"=limit.sigma_D\"\nstress = \"shear\"\n", in_shear);
    says("bending", life + "sigma_D = \"=min(limit.sigma_D, 300 MPa)\"\nstress = \"shear\"\n", in_shear);
    says("torsion", life + "sigma_D = \"=limit.sigma_D\"\n", "is a fatigue limit of a part in shear");
    says("bending", life + "sigma_D = \"=limit.sigma_m1\"\n", "is a fatigue limit of smooth specimens in bending");
    says("torsion", life + "sigma_D = \"190 MPa\"\nK_D = \"=limit.K_D\"\n", "'K_D' takes a factor");
    // what a product makes is the user's word: shear from bending by von Mises
    says("bending", life + "sigma_D = \"=limit.sigma_D/sqrt(3)\"\nstress = \"shear\"\n", "");

    const std::string cycle =
        "calculator = \"fatigue.cycle\"\nsigma_max = \"90 MPa\"\nr = -1\nS_D = 1.2\nsigma_D = "
        "\"=limit.sigma_D\"\nstress = \"shear\"\n";
    says("bending", cycle, in_shear);
    says("torsion", cycle, "");
    const std::string history =
        "calculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"90 MPa\", n = 100 }]\nN_D = 1e6\nk = 5\nsigma_D = "
        "\"=limit.sigma_D\"\nstress = \"shear\"\n";
    says("bending", history, in_shear);
    says("torsion", history, "");
    const std::string combined =
        "calculator = \"fatigue.combined\"\nsigma_m = \"20 MPa\"\nsigma_a = \"60 MPa\"\ntau_m = \"40 MPa\"\ntau_a = "
        "\"10 MPa\"\nR_m = \"690 MPa\"\nR_e = \"490 MPa\"\nS_D = 1.8\nS_F = 1.5\n";
    says("bending", combined + "sigma_D = \"180 MPa\"\ntau_D = \"=limit.sigma_D\"\nK_sigma = 1.7\nK_tau = 1.5\n",
         "'tau_D' takes a fatigue limit of a part in shear");
    says("torsion", combined + "sigma_D = \"=limit.sigma_D\"\ntau_D = \"90 MPa\"\nK_sigma = 1.7\nK_tau = 1.5\n",
         "'sigma_D' takes a fatigue limit of a part in normal stresses");
    says("bending", combined + "sigma_D = \"180 MPa\"\ntau_D = \"110 MPa\"\nK_sigma = 1.7\nK_tau = \"=limit.K_D\"\n",
         "'K_tau' takes a factor");
  }

  TEST_CASE("a fatigue limit without a size or a surface is not assessed as that of a part") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.endurance", lines, mode);
    };
    CHECK(state("", "size") == "pass");
    CHECK(state("d = ", "size") == "not-judged");
    CHECK(state("", "surface") == "pass");
    CHECK(state("R_z = ", "surface") == "not-judged");
    // the user's word: as small, and as smooth as a specimen
    CHECK(state("d = \nepsilon = 1", "size") == "none");
    CHECK(state("R_z = \nbeta_F = 1", "surface") == "none");
    CHECK(state("d = \nloading = \"tension\"", "size") == "none");  // which knows no size effect
    CHECK(state("d = \nloading = \"torsion\"", "size") == "not-judged");
    CHECK(state("school = \"marin\"\nR_z = \nd = ", "size") == "not-judged");
    CHECK(state("school = \"marin\"\nR_z = \nfinish = \"machined\"", "surface") == "none");
  }

  TEST_CASE("formulas for steels do not apply to irons, aluminium and bronze, which their modulus shows") {
    const std::string din =
        "group = \nsigma_B = \nsigma_S = \nd_h = \"50 mm\"\nM_ba = \"10 N*m\"\nM_tm = \"0 N*m\"\nM_ta = \"5 N*m\"\n";
    const std::string fkm =
        "R_mN = \nR_eN = \nd_h = \"50 mm\"\nM_ba = \"10 N*m\"\nM_tm = \"0 N*m\"\nM_ta = \"5 N*m\"\n";
    for (const char* const metal : {"EN-GJS-400-15", "EN-GJS-700-2", "EN AW-6082-T6", "CuSn12-C"}) {
      const std::string of = "material = \"" + std::string(metal) + "\"\n";
      for (const char* const mode : {"fatigue", "yield"}) {
        CHECK_MESSAGE(mode_with("fatigue.din743", din + of, mode) == "not-covered", metal);
        CHECK_MESSAGE(mode_with("fatigue.fkm", fkm + of, mode) == "not-covered", metal);
      }
      CHECK_MESSAGE(mode_with("fatigue.endurance", "R_m = \n" + of, "metal") == "not-covered", metal);
      CHECK_MESSAGE(mode_with("shaft.design", of, "fatigue") == "not-covered", metal);
      CHECK_MESSAGE(mode_with("pin.joint", "R_m = \nF = \"1 kN\"\n" + of, "shear") == "not-covered", metal);
    }
    CHECK(mode_with("fatigue.din743", din + "material = \"C45E\"", "fatigue") == "pass");
    CHECK(mode_with("fatigue.endurance", "", "metal") == "none");
    CHECK(mode_with("fatigue.endurance", "R_m = \nmaterial = \"C45E\"", "metal") == "pass");
    const std::string iron = "R_m = \nR_e = \nmaterial = \"EN-GJS-400-15\"\nsigma_D = \"60 MPa\"\n";
    CHECK(mode_with("fatigue.life", iron + "sigma_max = \"20 MPa\"", "fatigue") == "not-covered");
    CHECK(mode_with("fatigue.life", iron + "sigma_max = \"20 MPa\"\ngroup = \"ductile-iron\"", "fatigue") == "pass");
    const std::string gentle = "tau_D = \"35 MPa\"\nsigma_a = \"10 MPa\"\nsigma_m = \"2 MPa\"\ntau_m = \"3 MPa\"\n";
    CHECK(mode_with("fatigue.combined", iron + gentle, "fatigue") == "not-covered");
    CHECK(mode_with("fatigue.combined", iron + gentle + "psi_sigma = 0.2\npsi_tau = 0.1", "fatigue") == "pass");
  }

  TEST_CASE("a notch as sharp as a crack has no sensitivity, a surface rougher than a rolled skin no factor") {
    CHECK(mode_with("fatigue.endurance", "r_n = \"0.001 mm\"", "notch") == "not-covered");
    CHECK(mode_with("fatigue.endurance", "R_z = \"5 mm\"", "surface") == "not-covered");
    CHECK(mode_with("fatigue.din743", "R_z = \"250 um\"", "fatigue") == "not-covered");
    const std::string given =
        "notches = [{ x = \"60 mm\", r = \"2 mm\" }, { x = \"140 mm\", r = \"2 mm\" }, { x = \"100 mm\", kind = "
        "\"given\", K_t = 4, K_ts = 4, r = \"";
    CHECK(mode_with("shaft.design", given + "0.1 mm\" }]", "fatigue") == "pass");
    CHECK(mode_with("shaft.design", given + "0.001 mm\" }]", "fatigue") == "not-covered");  // K_f of 1.2
  }

  TEST_CASE("no category of EN 1993-1-9 is above 160 MPa") {
    const std::string detail = "sigma_D = \nN_D = \nk = \nmean = \ncurve = \"en1993\"\n";
    CHECK(ExampleStep("fatigue.history", detail + "sigma_C = \"160 MPa\"").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.history", detail + "sigma_C = \"710 MPa\"").fault().empty());
    CHECK_FALSE(ExampleStep("fatigue.history", detail + "stress = \"shear\"\nsigma_C = \"125 MPa\"").fault().empty());
  }

  TEST_CASE("positions that are too few over a revolution hide its peak") {
    const auto errors = [](const std::string& positions) {
      return Solved(
                 "[m]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"90 mm\"\n"
                 "crank = { speed = \"60 rpm\", positions = " +
                 positions +
                 " }\nloads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = \"-2 kN\", F_y = \"0 N\" }]\n"
                 "[h]\ncalculator = \"fatigue.history\"\nsigma = \"=m.drive.M/(1 cm^3)\"\nsigma_D = \"120 MPa\"\nN_D = "
                 "1e6\n"
                 "k = 5\n[p]\ncalculator = \"fatigue.multiaxial\"\ntau_xy = \"=m.drive.M/(1 cm^3)\"\nsigma_D = \"240 "
                 "MPa\"\n"
                 "tau_D = \"150 MPa\"\nS_D = 1\n")
          .errors();
    };
    CHECK(errors("72").empty());
    const std::string few = errors("12");
    CHECK_MESSAGE(few.find("36 positions of a turn at least") != std::string::npos, few);
  }

  TEST_CASE("without a yield strength no rule passes the first cycle, and no line exceeds the tensile strength") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.life", lines, mode);
    };
    for (const char* const rule : {"goodman", "gerber", "fkm", "swt", "walker", "serensen"})
      CHECK_MESSAGE(state("S_F = \nR_e = \nrule = \"" + std::string(rule) + "\"", "yield") == "not-judged", rule);
    CHECK(state("S_F = \nR_e = \nR_m = \nrule = \"swt\"", "yield") == "not-judged");
    // N S^5 through 190 MPa at 1e6 cycles is at 756 MPa at 1e3: above the 690 MPa that break at once
    const std::string slope = "line = \"slope\"\nk = 5\nN = 1000\nsigma_min = \"-180 MPa\"\n";
    CHECK(std::abs(ExampleStep("fatigue.life", slope)("S_e") - 690e6) < 1.0);
    CHECK(std::abs(ExampleStep("fatigue.life", slope + "N = 10000")("S_e") - 190e6 * std::pow(100.0, 0.2)) < 1.0);
    CHECK(std::isnan(ExampleStep("fatigue.life", slope + "sigma_max = \"700 MPa\"\nsigma_min = \"-700 MPa\"")("N_f")));
  }

  TEST_CASE("the life under a cycle is assessed where fatigue.life takes the full cycle") {
    const std::string rod =
        "[rod]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"180 MPa\"\nsigma_min = \"-20 MPa\"\n"
        "[lasts]\ncalculator = \"fatigue.life\"\nsigma_D = \"190 MPa\"\ngroup = \"carbon-steel\"\nR_m = \"690 MPa\"\n"
        "R_e = \"490 MPa\"\nS_F = 1.5\ncycle = \"=rod.cycle\"\n";
    CHECK(mode_of(solved_as_found(rod + "S_D = 1.5\n"), "rod", "life") == "pass");
    CHECK(mode_of(solved_as_found(rod + "S_D = 1.6\n"), "rod", "life") == "fail");
    // what the cycle itself has no input for is judged there too
    CHECK(mode_of(solved_as_found(rod + "S_D = 1.5\n"), "rod", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(rod + "S_D = 1.6\n"), "rod", "fatigue") == "fail");
    CHECK(mode_of(solved_as_found(rod + "S_D = 1.5\n"), "rod", "yield") == "pass");
    // a value typed over the one of the cycle: another cycle, unless it is the same one
    const auto typed = [&](const std::string& most) {
      return mode_of(solved_as_found(rod + "S_D = 1.5\nsigma_max = \"" + most + "\"\n"), "rod", "fatigue");
    };
    CHECK(typed("180 MPa") == "pass");
    CHECK(typed("0.18 GPa") == "pass");
    CHECK(typed("100 MPa") == "not-judged");
    CHECK(contains(Solved(rod + "S_D = 1.5\nstress = \"shear\"\n").errors(), "'rod.cycle.stress' is \"normal\""));
    // a cycle with a limit of its own, which its mean stress leaves uncovered
    const std::string limited = "[rod]\nsigma_D = \"190 MPa\"\nS_D = 1.5\n" + rod.substr(6);
    CHECK(mode_of(solved_as_found(limited + "S_D = 1.5\n"), "rod", "fatigue") == "pass");
  }

  TEST_CASE("normal and shear stresses together: a part that breaks does not pass") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.combined", lines, mode);
    };
    CHECK(state("", "fatigue") == "pass");
    CHECK(state("", "yield") == "pass");
    CHECK(state("S_F = ", "yield") == "not-judged");
    CHECK(state("tau_m = \"300 MPa\"", "yield") == "fail");
    CHECK(state("tau_m = \"-300 MPa\"", "yield") == "fail");
    CHECK(state("sigma_m = \"-500 MPa\"", "yield") == "fail");
    CHECK(state("tau_a = \"80 MPa\"", "fatigue") == "fail");
    CHECK(state("sigma_a = \"0 MPa\"\ntau_a = \"0 MPa\"", "fatigue") == "none");
    CHECK(state("tau_D = \"60 MPa\"\nrule = \"gerber\"", "fatigue") == "not-covered");
  }

  TEST_CASE("sections of shafts that break do not pass by DIN 743") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.din743", lines, mode);
    };
    CHECK(state("", "fatigue") == "pass");
    CHECK(state("", "yield") == "pass");
    CHECK(state("M_ba = \"3000 N*m\"", "fatigue") == "fail");
    CHECK(state("f_max = 20", "yield") == "fail");
    CHECK(state("M_bmax = \"9 kN*m\"", "yield") == "fail");  // one is given, f_max gives the other
    CHECK(state("r = \"0.2 mm\"\nM_ba = \"1500 N*m\"", "fatigue") == "fail");
    // a mean stress beyond yielding leaves nothing to vary, in either way to grow
    CHECK(state("M_tm = \"9000 N*m\"\nM_ta = \"0.001 N*m\"\nM_ba = \"0.001 N*m\"", "fatigue") == "fail");
    CHECK(state("M_tm = \"9000 N*m\"\nM_ta = \"1 N*m\"\nmean = \"constant\"", "fatigue") == "fail");
    // compression helps until it yields itself
    CHECK(state("F_zdm = \"-1300 kN\"\nF_zda = \"0 N\"", "fatigue") == "fail");
    CHECK(state("F_zdm = \"-1300 kN\"\nF_zda = \"0 N\"", "yield") == "fail");
  }

  TEST_CASE("DIN 743: missing input is not assessed, unknown cases are not covered, static loads last") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.din743", lines, mode);
    };
    CHECK(state("f_max = ", "yield") == "not-judged");
    CHECK(state("f_max = \nM_bmax = \"2 kN*m\"", "yield") == "not-judged");
    CHECK(state("layer = \"hard\"", "layer") == "not-judged");
    CHECK(state("", "layer") == "none");
    CHECK(state("d_h = \"600 mm\"", "fatigue") == "not-covered");
    CHECK(state("d_bore = \"10 mm\"", "fatigue") == "not-covered");
    CHECK(state("notch = \"alpha\"\nD = \nr = \nalpha_b = 6.5\nalpha_t = 1\nM_ba = \"20 N*m\"", "fatigue") ==
          "not-covered");
    CHECK(state("M_ba = \"0 N*m\"\nM_ta = \"0 N*m\"", "fatigue") == "none");
    for (const char* const refused :
         {"R_z = ", "notch = ", "M_ba = \nM_tm = \nM_ta = ", "M_ta = ", "M_tmax = \"1000 N*m\"", "d_h = \"45 mm\"",
          "S_min = 1", "r = ", "group = ", "d = \"50 mm\""})
      CHECK_FALSE(ExampleStep("fatigue.din743", refused).fault().empty());
  }

  TEST_CASE("FKM: a part that breaks does not pass, missing input is not assessed, unknown cases are not covered") {
    const auto state = [](const std::string& lines, const std::string& mode) {
      return mode_with("fatigue.fkm", lines, mode);
    };
    CHECK(state("", "fatigue") == "pass");
    CHECK(state("", "yield") == "pass");
    for (const char* const overload : {"F1", "F2", "F3", "F4"})
      CHECK(state("M_ba = \"3000 N*m\"\noverload = \"" + std::string(overload) + "\"", "fatigue") == "fail");
    CHECK(state("f_max = 20", "yield") == "fail");
    CHECK(state("M_bmax = \"9 kN*m\"", "yield") == "fail");
    CHECK(state("F_zdm = \"-1300 kN\"\nF_zda = \"0 N\"", "yield") == "fail");
    CHECK(state("M_tm = \"9000 N*m\"", "yield") == "fail");
    CHECK(state("f_max = ", "yield") == "not-judged");
    CHECK(state("f_max = \nM_bmax = \"2 kN*m\"", "yield") == "not-judged");
    CHECK(state("layer = \"hard\"", "layer") == "not-judged");
    CHECK(state("d_h = \"260 mm\"", "fatigue") == "not-covered");
    CHECK(state("d_bore = \"10 mm\"", "fatigue") == "not-covered");
    CHECK(state("N = 1000", "fatigue") == "not-covered");
    CHECK(state("N = 100000\nM_ba = \"2000 N*m\"", "fatigue") == "fail");
    CHECK(state("M_ba = \"0 N*m\"\nM_ta = \"0 N*m\"", "fatigue") == "none");
    for (const char* const refused :
         {"R_z = ", "notch = ", "M_ba = \nM_tm = \nM_ta = ", "M_ta = ", "steel = ", "M_tmax = \"1000 N*m\"",
          "j_D = 0.5", "R_mN = \"5000 MPa\"", "a_dm = 0.9", "d_Nm = \"1 mm\"", "G_b = \"1/mm\"", "R_eN = "})
      CHECK_FALSE(ExampleStep("fatigue.fkm", refused).fault().empty());
  }

  TEST_CASE("a history is finite: no named pipe, no device, no single value") {
    const test::Desk desk;
    const auto& folder = desk.folder();
    const std::string pipe = (folder / "pipe.csv").string(), one = (folder / "one.csv").string();
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::ofstream(one) << "S\n180\n";
    const auto errors = [](const std::string& sigma) {
      return Solved("[h]\ncalculator = \"fatigue.history\"\nsigma_D = \"120 MPa\"\nN_D = 1e6\nk = 5\nsigma = " + sigma)
          .errors();
    };
    for (const char* const told : {"does not exist or cannot be read", "file = \"-\""})
      CHECK(contains(errors("{ file = \"" + pipe + "\", unit = \"MPa\" }"), told));
    CHECK(contains(errors("{ file = \"/dev/null\", unit = \"MPa\", form = \"f64\" }"),
                   "does not exist or cannot be read"));
    CHECK(contains(errors("{ file = \"" + folder.string() + "\", unit = \"MPa\", form = \"csv\" }"),
                   "does not exist or cannot be read"));
    CHECK(contains(errors("{ file = \"" + one + "\", unit = \"MPa\" }"), "the file has one value"));
    CHECK(contains(errors("{ values = [180], unit = \"MPa\" }"), "the list has one value"));
    CHECK(contains(errors("{ values = [], unit = \"MPa\" }"), "a history is a list of numbers"));
  }
}
