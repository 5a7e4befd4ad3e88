// Regression tests of fatigue limits: metals that have none, curves that are mixed, rules beyond their range.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string limit_fault(std::string_view calculator, const std::string& lines) {
  return ExampleStep(calculator, lines).fault();
}
void refuses_limit(std::string_view calculator, const std::string& lines, const std::string& what) {
  const std::string fault = limit_fault(calculator, lines);
  CHECK_MESSAGE(contains(fault, what), lines, fault);
}

}  // namespace

TEST_SUITE("found fatigue limits") {
  TEST_CASE("L: metals without a fatigue limit are assessed at a number of cycles, or not at all") {
    for (const char* const id : {"fatigue.cycle", "fatigue.combined", "fatigue.multiaxial"}) {
      INFO(id);
      const auto state = [&](const std::string& lines) {
        return mode_with(id, "R_m = \nR_e = \nS_F = \n" + lines, "cycles");
      };
      for (const char* const metal : {"EN AW-6061-T6", "EN AW-2014-T6", "CuSn12-C", "C86100", "Ti-6Al-4V"}) {
        const std::string of = "d_h = \"20 mm\"\nmaterial = \"" + std::string(metal) + "\"\n";
        CHECK_MESSAGE(state(of) == "not-judged", metal);
        CHECK_MESSAGE(state(of + "N = 1e7\n") == "not-judged", metal);
        CHECK_MESSAGE(state(of + "N = 1e7\nN_D = 1e8\n") == "pass", metal);
        CHECK_MESSAGE(state(of + "N = 1e9\nN_D = 1e8\n") == "not-covered", metal);
      }
      for (const char* const iron : {"C45E", "EN-GJL-250", "EN-GJS-400-15", "X5CrNi18-10"})
        CHECK_MESSAGE(state("d_h = \"20 mm\"\nmaterial = \"" + std::string(iron) + "\"\n") == "none", iron);
      CHECK(mode_with(id, "rho = \"2700 kg/m^3\"\n", "cycles") == "not-judged");
      CHECK(mode_with(id, "E = \"70 GPa\"\n", "cycles") == "not-judged");
      CHECK(mode_with(id, "", "cycles") == "none");
    }
  }

  TEST_CASE("L: a group of irons is not one of aluminium, and a fatigue strength is not a limit") {
    const std::string aluminium = "R_m = \nmaterial = \"EN AW-6082-T6\"\nd_h = \"20 mm\"\n";
    for (const char* const group : {"grey-iron", "ductile-iron", "malleable-iron"}) {
      const std::string of = aluminium + "group = \"" + std::string(group) + "\"\nrule = ";
      refuses_limit("fatigue.endurance", of + "\"fkm\"\nloading = \"tension\"\nd = \"20 mm\"\n",
                    "modulus and density are not those of iron or steel: give the group of the material");
      refuses_limit("fatigue.life", of + "\"goodman\"\nR_e = \nK_m = 1\nsigma_D = \"60 MPa\"\n",
                    "modulus and density are not those of iron or steel: give the group of the material");
    }
    const std::string strength =
        "[limit]\ncalculator = \"fatigue.endurance\"\nR_m = \"290 MPa\"\ngroup = \"wrought-aluminium\"\nrule = "
        "\"fkm\"\n"
        "loading = \"tension\"\nd = \"20 mm\"\nR_z = \"6.3 um\"\n";
    const std::string cycle =
        "[c]\ncalculator = \"fatigue.cycle\"\nsigma_a = \"40 MPa\"\nr = -1\nS_D = 1.2\nsigma_D = \"=limit.sigma_D\"\n";
    CHECK(contains(Solved(strength + cycle).errors(), "is a fatigue strength at some number of cycles"));
    const std::string life =
        "[c]\ncalculator = \"fatigue.life\"\nsigma_a = \"20 MPa\"\nr = -1\nR_m = \"290 MPa\"\nS_D = 1.2\nN = 1e7\nf = "
        "0.9\n"
        "sigma_D = \"=limit.sigma_D\"\ngroup = ";
    CHECK(Solved(strength + life + "\"wrought-aluminium\"\n").errors().empty());
    CHECK(contains(Solved(strength + life + "\"carbon-steel\"\n").errors(), "of a metal without a limit"));
    CHECK(contains(Solved(strength + life + "\"wrought-aluminium\"\nstress = \"shear\"\n").errors(),
                   "takes the same in shear"));
  }

  TEST_CASE("L: a history of aluminium by steel details, or by rules with a limit; a shaft of it for infinite life") {
    const std::string aluminium = "R_m = \nR_e = \nmaterial = \"EN AW-6061-T6\"\nd_h = \"20 mm\"\n";
    const auto state = [&](const std::string& lines) {
      return mode_with("fatigue.history", aluminium + lines, "metal");
    };
    CHECK(state("") == "none");
    CHECK(state("miner = \"elementary\"\n") == "none");
    for (const char* const rule : {"original", "consistent", "liu-zenner"})
      CHECK_MESSAGE(state("miner = \"" + std::string(rule) + "\"\n") == "not-judged", rule);
    const std::string detail = "sigma_D = \nN_D = \nk = \nmean = \"none\"\n";
    CHECK(state(detail + "curve = \"en1993\"\nsigma_C = \"80 MPa\"\n") == "not-judged");
    CHECK(state(detail + "curve = \"dnv\"\ndetail = \"C\"\n") == "not-judged");
    CHECK(mode_with("fatigue.history", "miner = \"original\"\n", "metal") == "none");
    const std::string shaft = "material = \"EN AW-6082-T6\"\nsigma_W = \"90 MPa\"\ngroup = ";
    CHECK(mode_with("shaft.design",
                    shaft + "\"wrought-aluminium\"\nnotches = \npieces = [{ l = \"200 mm\", d = \"40 mm\" }]",
                    "cycles") == "not-judged");
    CHECK(mode_with("shaft.design", "", "cycles") == "none");
  }

  TEST_CASE("F1: Miner's original rule applies while no cycle is above the limit") {
    const auto state = [](const std::string& blocks) {
      return mode_with("fatigue.history", "miner = \"original\"\nmean = \"none\"\nblocks = [" + blocks + "]",
                       "fatigue");
    };
    CHECK(state("{ sigma_a = \"119 MPa\", n = 1e9 }, { sigma_a = \"250 MPa\", n = 1000 }") == "not-covered");
    CHECK(state("{ sigma_a = \"119 MPa\", n = 1e9 }") == "pass");
    CHECK(state("{ sigma_a = \"180 MPa\", n = 500 }") == "pass");
    CHECK(state("{ sigma_a = \"180 MPa\", n = 500 }, { sigma_a = \"20 MPa\", n = 1e4 }") == "pass");
  }

  TEST_CASE("F3: the numbers of a curve of DNV-RP-C203 belong to one branch") {
    const std::string dnv =
        "sigma_D = \nN_D = \nk = \nmean = \"none\"\ncurve = \"dnv\"\nblocks = [{ sigma_a = \"100 MPa\", n = 1e8 }]\n";
    const ExampleStep named("fatigue.history", dnv + "detail = \"C\""), typed("fatigue.history", dnv + "lg_a = 12.592");
    CHECK(named("D") == typed("D"));
    CHECK(std::abs(named("D") / (1e8 / std::pow(10.0, 12.592 - 3.0 * std::log10(200.0))) - 1.0) < 1e-9);
    const ExampleStep best("fatigue.history", dnv + "detail = \"B1\""),
        own("fatigue.history", dnv + "lg_a = 15.117\nm_1 = 4");
    CHECK(best("D") == own("D"));
    for (const char* const mixed :
         {"lg_a = 16.320", "lg_a = 13.617", "lg_a = 15.117", "lg_a = 12.592\nm_1 = 2", "lg_a = 12.592\nm_1 = 2.5",
          "lg_a = 12.592\nN_1 = 1e5", "lg_a = 12.592\nm_2 = 12", "lg_a = 17.146\nm_1 = 4", "detail = \"C\"\nm_2 = 9"})
      refuses_limit("fatigue.history", dnv + mixed, "no detail of DNV-RP-C203 lasts so long");
    for (const char* const sound :
         {"lg_a = 10.970", "lg_a = 12.192\nN_1 = 1e6", "lg_a = 14.885\nm_1 = 4", "lg_a = 12.0"})
      CHECK_MESSAGE(limit_fault("fatigue.history", dnv + sound).empty(), sound);
    refuses_limit("fatigue.history", dnv + "detail = \"C\"\nlg_a = 12.592", "has its own lg a");
    refuses_limit("fatigue.history", "detail = \"C\"", "only the numbers of the chosen curve");
  }

  TEST_CASE("P3: a history is repeated once at least, and every block of it occurs") {
    CHECK_FALSE(limit_fault("fatigue.history", "n_req = 0.001").empty());
    CHECK_FALSE(limit_fault("fatigue.history", "n_req = 0.999").empty());
    CHECK(limit_fault("fatigue.history", "n_req = 1").empty());
    refuses_limit("fatigue.history", "blocks = [{ sigma_a = \"300 MPa\", n = 0.001 }]",
                  "a block must occur at least once");
    CHECK(limit_fault("fatigue.history", "blocks = [{ sigma_a = \"300 MPa\", n = 0.001 }]\nn_req = 1000").empty());
    CHECK(limit_fault("fatigue.history", "blocks = [{ sigma_a = \"300 MPa\", n = 0.5 }]").empty());
  }

  TEST_CASE("the equivalent stress of all categories of EN 1993-1-9 at the cut-off, where the curve ends") {
    const auto S_eq = [](double category, const char* stress) {
      const std::string C = std::to_string(category) + " MPa", half = std::to_string(category / 2.0) + " MPa";
      return ExampleStep("fatigue.history",
                         "sigma_D = \nN_D = \nk = \nmean = \"none\"\ncurve = \"en1993\"\nR_e = \"500 MPa\"\n"
                         "R_m = \"700 MPa\"\nstress = \"" +
                             std::string(stress) + "\"\nsigma_C = \"" + C + "\"\nblocks = [{ sigma_a = \"" + half +
                             "\", n = 2e6 }]\nN_eq = 1e8")("S_eq") /
             1e6;
    };
    for (const double C : {160.0, 140.0, 125.0, 112.0, 100.0, 90.0, 80.0, 71.0, 63.0, 56.0, 50.0, 45.0, 40.0, 36.0})
      CHECK_MESSAGE(std::abs(S_eq(C, "normal") / (C * std::cbrt(0.4) * std::pow(0.05, 0.2)) - 1.0) < 1e-9, C);
    for (const double C : {100.0, 80.0})
      CHECK_MESSAGE(std::abs(S_eq(C, "shear") / (C * std::pow(0.02, 0.2)) - 1.0) < 1e-9, C);
    CHECK(std::abs(S_eq(80.0, "shear") - 36.5844) < 1e-4);  // as computed by hand
  }

  TEST_CASE("Marin's method without a reliability counts half of the parts: it is required") {
    const std::string marin = "school = \"marin\"\nR_z = \nfinish = \"machined\"\n";
    CHECK(mode_with("fatigue.endurance", "", "reliability") == "none");
    CHECK(mode_with("fatigue.endurance", marin, "reliability") == "not-judged");
    CHECK(mode_with("fatigue.endurance", marin + "P_s = 0.99\n", "reliability") == "none");
    CHECK(mode_with("fatigue.endurance", marin + "P_s = 0.99\n", "typed_values") == "none");
    CHECK(mode_with("fatigue.endurance", marin + "P_s = 0.5\n", "typed_values") == "not-judged");
    CHECK(mode_with("fatigue.endurance", marin + "P_s = 0.5\nbecause.P_s = \"S_D covers the scatter\"\n",
                    "typed_values") == "none");
  }

  TEST_CASE("a fatigue limit in shear as high as in normal stresses needs a reason, a derived one does not") {
    CHECK(mode_with("fatigue.combined", "tau_D = \"125 MPa\"\n", "fatigue") == "pass");
    CHECK(mode_with("fatigue.combined", "tau_D = \"180 MPa\"\n", "fatigue") == "not-judged");
    CHECK(mode_with("fatigue.combined", "tau_D = \"=180 MPa\"\n", "fatigue") == "not-judged");
    CHECK(mode_with("fatigue.combined", "tau_D = \"180 MPa\"\nbecause.tau_D = \"tests\"\n", "fatigue") == "pass");
  }
}
