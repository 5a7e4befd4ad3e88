// Regression tests of kinds of stress: shear that is taken for a normal stress, and the reverse.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A shaft of 50 mm under 2 kN m: 81.5 MPa in shear.
const std::string twisted_bar =
    "[s]\ncalculator = \"shaft.torsion\"\nT = \"2 kN*m\"\nd = \"50 mm\"\ntau_adm = \"120 MPa\"\n";
const std::string cycle_of_it =
    "[c]\ncalculator = \"fatigue.cycle\"\nr = -1\nsigma_D = \"150 MPa\"\nS_D = 1.2\nR_e = \"150 MPa\"\nS_F = 1.2\n";

std::string stress_errors(const std::string& text) { return Solved(text).errors(); }

void refuses_stress(const std::string& text, const std::string& what) {
  const std::string errors = stress_errors(text);
  CHECK_MESSAGE(contains(errors, what), text, errors);
}
void takes_stress(const std::string& text) {
  const std::string errors = stress_errors(text);
  CHECK_MESSAGE(errors.empty(), text, errors);
}

}  // namespace

TEST_SUITE("found kinds of stress") {
  TEST_CASE("X1: a shear stress is not a normal stress, in whichever way it is passed") {
    const std::string wrong = "is a normal stress, but this expression is a shear stress";
    for (const char* const value : {"=s.tau_max", "=1.2*s.tau_max", "=s.tau_max/2", "=-s.tau_max", "=s.tau_max + 5 MPa",
                                    "=max(s.tau_max, 1 MPa)", "=s.segments[1].tau"})
      refuses_stress(twisted_bar + cycle_of_it + "sigma_max = \"" + value + "\"\n", wrong);
    refuses_stress("[values]\nown = \"=s.tau_max\"\n" + twisted_bar + cycle_of_it + "sigma_max = \"=values.own\"\n",
                   wrong);
    refuses_stress(
        twisted_bar +
            "[c]\ncalculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"=s.tau_max\", n = 100 }]\nN_D = 1e6\n"
            "k = 5\nsigma_D = \"150 MPa\"\n",
        wrong);
    refuses_stress(
        twisted_bar +
            "[c]\ncalculator = \"fatigue.life\"\nsigma_a = \"=s.tau_max\"\nr = -1\nsigma_D = \"150 MPa\"\ngroup = "
            "\"carbon-steel\"\nR_m = \"690 MPa\"\nS_D = 1.2\n",
        wrong);
    const std::string combined =
        "[c]\ncalculator = \"fatigue.combined\"\nsigma_D = \"180 MPa\"\ntau_D = \"110 MPa\"\nK_sigma = 1.7\nK_tau = "
        "1.5\n"
        "R_m = \"690 MPa\"\nS_D = 1.2\nsigma_m = \"0 MPa\"\ntau_m = \"0 MPa\"\n";
    refuses_stress(twisted_bar + combined + "sigma_a = \"=s.tau_max\"\ntau_a = \"0 MPa\"\n", wrong);
    takes_stress(twisted_bar + combined + "sigma_a = \"0 MPa\"\ntau_a = \"=0.5*s.tau_max\"\n");
    // given as shear, or converted to a normal stress
    takes_stress(twisted_bar + cycle_of_it + "stress = \"shear\"\nsigma_max = \"=s.tau_max\"\n");
    takes_stress(twisted_bar + cycle_of_it + "sigma_max = \"=mises(0 MPa, s.tau_max)\"\n");
    // a choice taken from another step, behind another one
    const std::string taker =
        "calculator = \"fatigue.life\"\nr = -1\nsigma_D = \"150 MPa\"\nR_m = \"690 MPa\"\nS_D = 1.2\nsigma_max = ";
    const std::string typed = "\"90 MPa\"\ngroup = \"carbon-steel\"\nstress = \"shear\"\n";
    takes_stress(twisted_bar + "[k]\n" + taker + typed + "[l]\n" + taker +
                 "\"=s.tau_max\"\ngroup = \"=k.group\"\nstress = \"=k.stress\"\n");
    // the strengths of a step in shear are no shear stresses
    refuses_stress(twisted_bar + cycle_of_it + "stress = \"shear\"\nsigma_max = \"90 MPa\"\n[l]\n" + taker +
                       "\"90 MPa\"\ngroup = \"carbon-steel\"\nstress = \"shear\"\nR_e = \"=s.tau_max\"\nS_F = 1.2\n",
                   "'R_e' is a strength, but this expression is a shear stress");
  }

  TEST_CASE("a normal stress is not a shear stress, and an equivalent one has no plane") {
    const std::string normal = "[n]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"80 MPa\"\nr = -1\n";
    refuses_stress(normal + cycle_of_it + "stress = \"shear\"\nsigma_max = \"=n.sigma_max\"\n",
                   "is a shear stress, but this expression is a normal stress");
    takes_stress(normal + cycle_of_it + "sigma_max = \"=n.sigma_max\"\n");
    refuses_stress(normal +
                       "[m]\ncalculator = \"fatigue.cycle\"\nstress = \"shear\"\nsigma_max = \"80 MPa\"\nr = -1\n" +
                       cycle_of_it + "sigma_max = \"=m.sigma_a\"\n",
                   "is a normal stress, but this expression is a shear stress");
    const std::string path =
        "[p]\ncalculator = \"fatigue.combined\"\nsigma_D = \"180 MPa\"\ntau_D = \"110 MPa\"\nK_sigma = 1.7\nK_tau = "
        "1.5\n"
        "R_m = \"690 MPa\"\nS_D = 1.2\nsigma_m = \"10 MPa\"\nsigma_a = \"20 MPa\"\ntau_m = \"0 MPa\"\ntau_a = \"9 "
        "MPa\"\n";
    refuses_stress(path + cycle_of_it + "sigma_max = \"=p.sigma_va\"\n", "this expression is an equivalent stress");
  }

  TEST_CASE("X3: a typed choice next to a record with another choice") {
    refuses_stress(twisted_bar + cycle_of_it + "cycle = \"=s.cycle\"\nstress = \"normal\"\n",
                   "'stress' is \"normal\" here, and 's.cycle.stress' is \"shear\"");
    takes_stress(twisted_bar + cycle_of_it + "cycle = \"=s.cycle\"\nstress = \"shear\"\n");
    takes_stress(twisted_bar + cycle_of_it + "cycle = \"=s.cycle\"\n");
    // through a cycle, in full, to its life
    refuses_stress(twisted_bar + cycle_of_it +
                       "cycle = \"=s.cycle\"\n[l]\ncalculator = \"fatigue.life\"\ncycle = \"=c.cycle\"\nstress = "
                       "\"normal\"\nsigma_D = \"150 MPa\"\ngroup = \"carbon-steel\"\nR_m = \"690 MPa\"\nS_D = 1.2\n",
                   "'c.cycle.stress' is \"shear\"");
  }

  TEST_CASE("the remedy depends on both kinds, as a table") {
    const std::string shaft = "[s]\ncalculator = \"shaft.torsion\"\nd = \"50 mm\"\ntau_adm = \"120 MPa\"\n";
    const std::string shoulder =
        "[p]\ncalculator = \"fatigue.combined\"\nsigma_D = \"180 MPa\"\ntau_D = \"110 MPa\"\nK_sigma = 1.7\nK_tau = "
        "1.5\nS_D = 1.2\nsigma_m = \"10 MPa\"\nsigma_a = \"20 MPa\"\ntau_a = \"9 MPa\"\n";
    const std::string bearing = "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6208\"\nF_r = \"2 kN\"\n";
    struct Row {
      std::string text, message, hint;  // without a message the value is taken
    };
    const std::string T = shaft + "T = ", tau = shoulder + "R_m = \"690 MPa\"\ntau_m = ",
                      R_m = twisted_bar + shoulder + "tau_m = \"0 MPa\"\nR_m = ";
    const std::string n = bearing + "L_h = \"9000 h\"\nn = ", L_h = bearing + "n = \"100 rpm\"\nL_h = ";
    const std::string mises = "write mises(sigma, tau)", speed = "write rpm, rev/s or rad/s; rev*f for turns per time",
                      none = "\n";
    const std::string energy = "a power over a frequency is the energy of one cycle";
    const std::vector<Row> rows{
        {twisted_bar + cycle_of_it + "sigma_max = \"=s.tau_max\"\n", "'sigma_max' is a normal stress", mises},
        {R_m + "\"=4*s.tau_max\"\n", "'R_m' is a strength, but this expression is a shear stress", none},
        {tau + "\"=2*mises(3 MPa, 2 MPa)\"\n", "'tau_m' is a shear stress, but this expression is an equivalent stress",
         none},
        {tau + "\"=0.1*tables.materials.own.R_m\"\n[tables.materials.own]\nR_m = \"500 MPa\"\nsource = \"sheet 3\"\n",
         "", ""},
        {cycle_of_it + "sigma_max = \"=tables.materials.C45E.E/2000\"\n", "", ""},
        {tau + "\"=tables.materials.C45E.E/20000\"\n", "", ""},
        {tau + "\"=tables.materials.C45E.G/20000\"\n", "", ""},
        {T + "\"=values.W/3\"\n[values]\nW = \"20 J\"\n", "'T' is a moment, but this expression is an energy", energy},
        {T + "\"=2*values.W\"\n[values]\nW = \"20 kJ\"\n", "'T' is a moment, but this expression is an energy", energy},
        {T + "\"=values.W\"\n[values]\nW = \"20 N*m\"\n", "", ""},
        {n + "\"=2*values.f\"\n[values]\nf = \"3 Hz\"\n", "'n' takes a value of", speed},
        {n + "\"=rev*values.f\"\n[values]\nf = \"3 Hz\"\n", "", ""},
        {n + "'=tables.bearings.\"6208\".n_max/20'\n", "", ""},
        {L_h + "\"=90000/(100 rpm)\"\n", "'L_h' takes a value of", "multiply the number of turns by rev"},
        {L_h + "\"=90000 rev/(100 rpm)\"\n", "", ""},
        {bearing + "n = \"100 rpm\"\nL_h = \"9000 h\"\nK_A = \"=2*(0.6 rad)\"\n", "'K_A' takes a value of",
         "divide by rev to count turns"},
    };
    for (const Row& row : rows) {
      INFO(row.text);
      const std::string errors = stress_errors(row.text);
      CHECK_MESSAGE(errors.empty() == row.message.empty(), errors);
      if (row.message.empty()) continue;
      CHECK_MESSAGE(contains(errors, row.message), errors);
      CHECK_MESSAGE(contains(errors, " = " + row.hint), errors);
    }
  }

  TEST_CASE("the choice of a kind of stress: of a record, of the step, of another step, or of none") {
    const std::string history = twisted_bar +
                                "[c]\ncalculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"=s.tau_max\", n = 100 "
                                "}]\nN_D = 1e6\nk = 5\nsigma_D = \"150 MPa\"\n";
    takes_stress(history + "stress = \"shear\"\n");
    refuses_stress(history + "stress = \"normal\"\n", "this expression is a shear stress");
    refuses_stress(twisted_bar + cycle_of_it + "sigma_max = \"=1.1*s.cycle.sigma_max\"\n",
                   "is a normal stress, but this expression is a shear stress");
    takes_stress(twisted_bar + cycle_of_it + "stress = \"shear\"\nsigma_max = \"=1.1*s.cycle.sigma_max\"\n");
    takes_stress("[n]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"80 MPa\"\nr = -1\n" + cycle_of_it +
                 "sigma_max = \"=1.1*n.cycle.sigma_max\"\n");
    for (const char* const source : {"zz.stress", "c.stress", "s.stress"})  // of no step, of itself, of one without it
      CHECK(!stress_errors(twisted_bar + cycle_of_it + "sigma_max = \"=1.1*s.tau_max\"\nstress = \"=" + source + "\"\n")
                 .empty());
  }

  TEST_CASE("an expression that cannot be calculated has one message") {
    const std::string bar = "[s]\ncalculator = \"shaft.torsion\"\nd = \"50 mm\"\ntau_adm = \"120 MPa\"\nT = ";
    const std::string bearing =
        "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6208\"\nF_r = \"2 kN\"\nn = \"100 "
        "rpm\"\nL_h = \"9000 h\"\nK_A = ";
    const std::string shear = twisted_bar + cycle_of_it + "sigma_max = ";
    for (const std::string& text :
         {bar + "\"=2*(3 mm)\"\n", bar + "\"=2*(3 mm) + 1 s\"\n", bearing + "\"=2*(3 mm) + 1 s\"\n",
          bearing + "\"=2*(3 mm)\"\n", shear + "\"=mises(s.tau_max, 1 MPa)\"\n"}) {
      const std::string errors = stress_errors(text);
      CHECK_MESSAGE(std::count(errors.begin(), errors.end(), '\n') == 1, text, errors);
    }
    takes_stress(press_of_heavy_rod + bar + "\"=peak(press.drive.M)\"\n");
  }
}
