// Expressions are literals that arrive later, and what a value is beyond its dimension goes with it.
#include "lib/project/solving/read_project.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

const std::string fan =
    "[fan]\ncalculator = \"motion.compound\"\nxi = \"1 m\"\nv_eta = \"2 m/s\"\n";  // omega is required
const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\n";

/// The angular velocity of a frame that an expression gives.
double omega_of(const std::string& values, const std::string& expression) {
  const Solved solved((values.empty() ? "" : "[values]\n" + values) + fan + "omega = \"=" + expression + "\"\n");
  REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
  return solved.value("fan.omega");
}

std::string refused(const std::string& values, const std::string& step) {
  return Solved((values.empty() ? "" : "[values]\n" + values) + step).errors();
}

}  // namespace

TEST_SUITE("found expressions") {
  TEST_CASE("a frequency is not an angular velocity, whatever is computed from it") {
    const std::string values = "f = \"25 Hz\"\nk = \"25 1/s\"\npole_pairs = 1\nt = \"40 ms\"\n";
    for (const char* f :
         {"values.f/values.pole_pairs", "2*values.f", "values.f + 1 Hz", "-values.f", "max(values.f, 1 Hz)",
          "values.f*values.pole_pairs", "1*values.k", "1/values.t", "1*values.f", "25 Hz"}) {
      const std::string said = refused(values, fan + "omega = \"=" + f + "\"\n");
      CHECK_MESSAGE(contains(said, "'omega' takes a value of angular velocity"), f, ": ", said);
      CHECK_MESSAGE(contains(said, "rev*f"), f, ": ", said);
    }
    for (const char* turns : {"rev*values.f/values.pole_pairs", "2*pi*values.f", "values.f*(2*pi*1 rad)",
                              "rev/values.t", "1500 rpm", "rev*values.k", "1 rev*values.f"})
      CHECK_MESSAGE(std::abs(omega_of(values, turns) / (50.0 * pi) - 1.0) < 1e-12, turns);
  }

  TEST_CASE("a speed over a radius, a power over a moment and a root of a stiffness over a mass are radians per time") {
    const std::string values =
        "v = \"15 m/s\"\nr = \"300 mm\"\nP = \"5 kW\"\nM = \"100 N*m\"\nc = \"250 N/m\"\nm = \"0.1 kg\"\n";
    for (const char* w : {"15 m/s/(300 mm)", "values.v/(300 mm)", "values.v/values.r", "values.P/values.M",
                          "sqrt(values.c/values.m)", "(values.c/values.m)^0.5", "1*values.v/values.r"})
      CHECK_MESSAGE(std::abs(omega_of(values, w) / 50.0 - 1.0) < 1e-12, w);
    CHECK(contains(refused(values, fan + "omega = \"=values.v/(2*pi*values.r)\"\n"), "angular velocity"));  // turns
  }

  TEST_CASE("conversions that are applied twice, or to a diameter in place of a radius") {
    const std::string values =
        "n = \"1450 rpm\"\nf = \"24 Hz\"\nd = \"40 mm\"\nr = \"20 mm\"\nP = \"5 kW\"\nF = \"10 kN\"\n"
        "T = \"20 N*m\"\n";
    const auto said = [&](const std::string& t) { return refused(values, axle + "T = \"=" + t + "\"\n"); };
    CHECK(contains(said("values.P/(2*pi*values.n)"), "leave out 2*pi"));
    CHECK(contains(said("values.P/values.n/2/pi"), "leave out 2*pi"));
    CHECK(contains(said("values.P/(2*pi*1450 rpm)"), "leave out 2*pi"));
    CHECK(said("values.P/values.n").empty());
    CHECK(said("values.P/(2*pi*values.f)").empty());
    CHECK(said("pi/16*values.d^3*30 MPa").empty());
    CHECK(contains(refused(values, fan + "omega = \"=2*pi*values.n\"\n"), "leave out 2*pi"));
    CHECK(contains(refused(values, fan + "omega = \"=values.n*pi/(30)\"\n"), "leave out 2*pi"));
    CHECK(contains(refused(values, fan + "omega = \"=30/pi*values.n\"\n"), "but this expression is a frequency"));
    CHECK(refused(values, fan + "omega = \"=2*pi*values.f\"\n").empty());
    CHECK(refused(values, fan + "omega = \"=10*pi*1 rad/s\"\n").empty());
    CHECK(refused(values, fan + "omega = \"=pi/2*25 rpm\"\n").empty());
    CHECK(said("0.8 kg*m^2*3000 rpm*2*pi*0.5 Hz").empty());
    const std::string slide = "[b]\ncalculator = \"motion.compound\"\nxi = \"1 m\"\nv_eta = \"=";
    CHECK(contains(refused(values, slide + "values.n*values.d\"\n"), "write d/2"));
    CHECK(contains(refused(values, slide + "pi*values.d*values.n\"\n"), "write d/2 in place of pi*d"));
    CHECK(contains(refused(values, slide + "2*pi*values.r*values.n\"\n"), "leave out 2*pi"));
    CHECK_FALSE(contains(refused(values, slide + "values.n*values.d/2\"\n"), "v_eta"));
    CHECK_FALSE(contains(refused(values, slide + "pi*values.d*values.f\"\n"), "v_eta"));
    const std::string cycle = "[c]\ncalculator = \"fatigue.cycle\"\nr = -1\nsigma_max = \"=";
    CHECK(contains(refused(values, cycle + "values.F/(pi*values.d^2)\"\n"), "write pi*d^2/4"));
    CHECK(contains(refused(values, cycle + "values.F/pi/values.d/values.d\"\n"), "write pi*d^2/4"));
    for (const char* sigma : {"4*values.F/(pi*values.d^2)", "values.F/(pi*values.d^2/4)", "values.F/(pi/4*values.d^2)",
                              "values.F/(pi*values.r^2)", "32*values.T/(pi*values.d^3)"})
      CHECK_MESSAGE(!contains(refused(values, cycle + sigma + "\"\n"), "area of a circle"), sigma);
  }

  TEST_CASE("an expression of constants that divides by zero is an error at its place") {
    const std::string shaft = "[s]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\nT = ";
    for (const char* T : {"\"=values.T/0\"", "\"=values.T*sqrt(-1)\"", "\"=1 N*m/(2 - 2)\""})
      CHECK(
          contains(refused("T = \"10 N*m\"\n", shaft + T + "\n"), "'T' has no value: its expression divides by zero"));
  }

  TEST_CASE("what cannot be taken together is named with its remedy") {
    const std::string values =
        "[values]\nE = \"20 J\"\nf = \"25 Hz\"\nv = \"15 m/s\"\nr = \"300 mm\"\n"
        "[bar]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\nT = \"20 N*m\"\n";
    const auto said = [&](const std::string& T) { return Solved(values + axle + "T = \"=" + T + "\"\n").errors(); };
    const std::string by_angle = "= divide the energy by the angle, as in E/(2*pi rad)";
    for (const std::string T : {"bar.T + values.E", "values.E + bar.T"}) CHECK_MESSAGE(contains(said(T), by_angle), T);
    const std::string turns = Solved(values + fan + "omega = \"=values.f + values.v/values.r\"\n").errors();
    CHECK_MESSAGE(contains(turns, "a frequency and radians per time cannot be taken together"), turns);
    CHECK_MESSAGE(contains(turns, "= write rev*f for a frequency of turns"), turns);
  }

  TEST_CASE("the difference of two temperatures is a rise, a temperature less a rise is none") {
    const std::string part =
        "[values]\ndT = \"60 K\"\n[part]\ncalculator = \"fatigue.endurance\"\nschool = \"marin\"\nd = \"40 mm\"\n"
        "R_m = \"690 MPa\"\nT = \"120 degC\"\nfinish = \"machined\"\nloading = \"bending\"\n";
    const auto said = [&](const std::string& dT_1) {
      return Solved(part +
                    "[tubes]\ncalculator = \"vessel.compound\"\np = \"250 MPa\"\nd_i = \"100 mm\"\nd = \"200 mm\"\n"
                    "D = \"400 mm\"\nU_min = \"240 um\"\nU_max = \"280 um\"\nends = \"open\"\n"
                    "material = \"42CrMo4\"\nR_e_1 = \"650 MPa\"\nR_e_2 = \"650 MPa\"\nS = 1.5\ndT_2 = \"20 K\"\n"
                    "dT_1 = \"=" +
                    dT_1 + "\"\n")
          .errors();
    };
    CHECK(said("part.T - part.T").empty());
    for (const std::string none : {"part.T", "part.T - values.dT", "values.dT + part.T"}) {
      CHECK_MESSAGE(contains(said(none), "is a temperature difference, but this expression is a temperature"), none);
    }
  }

  TEST_CASE("revolutions are counted by rev, not by radians") {
    const std::string life = "[b]\ncalculator = \"motion.compound\"\nxi = \"1 m\"\nv_eta = \"2 m/s\"\n";
    CHECK(contains(refused("", axle + "T = \"20 N*m\"\nK_A = \"=1450 rpm*1 s\"\n"), "divide by rev"));
    CHECK(refused("", axle + "T = \"20 N*m\"\nK_A = \"=1450 rpm*0.1 s/rev\"\n").empty());
  }

  TEST_CASE("work is not a torque, and a torque is not work") {
    const std::string values = "P = \"30 kW\"\nf = \"1500 Hz\"\nE = \"20 J\"\n";
    for (const char* work : {"values.P/values.f", "30 kW/(1500 Hz)", "values.E", "2*values.E", "values.E + 1 N*m"})
      CHECK_MESSAGE(contains(refused(values, axle + "T = \"=" + std::string(work) + "\"\n"), "is an energy"), work);
    for (const char* torque : {"values.E/(2*pi)", "values.E/rev", "values.P/(rev*values.f)", "20 N*m"})
      CHECK_MESSAGE(refused(values, axle + "T = \"=" + std::string(torque) + "\"\n").empty(), torque);
  }

  TEST_CASE("a shear stress is not a normal stress; mises makes one of both") {
    const std::string cycle = axle + "T = \"120 N*m\"\n[c]\ncalculator = \"fatigue.cycle\"\nr = -1\nsigma_max = \"=";
    for (const char* shear : {"axle.tau_max", "2*axle.tau_max", "axle.tau_max + 1 MPa", "abs(-axle.tau_max)",
                              "max(axle.tau_max, 1 MPa)", "values.k*axle.tau_max", "axle.tau_max/2"}) {
      const std::string said = refused("k = 1.2\n", cycle + shear + "\"\n");
      CHECK_MESSAGE(contains(said, "'sigma_max' is a normal stress, but this expression is a shear stress"), shear,
                    ": ", said);
      CHECK_MESSAGE(contains(said, "mises(sigma, tau)"), shear);
      const std::string taken = refused("k = 1.2\n", cycle + shear + "\"\nstress = \"shear\"\n");
      CHECK_MESSAGE(taken.empty(), shear, ": ", taken);
    }
    const Solved both(cycle + "mises(30 MPa, axle.tau_max)\"\n");
    REQUIRE_MESSAGE(both.errors().empty(), both.errors());
    const double tau = 16.0 * 120.0 / (pi * std::pow(0.04, 3));  // 16 T/(pi d^3)
    CHECK(std::abs(both.value("c.sigma_max") / std::sqrt(30e6 * 30e6 + 3.0 * tau * tau) - 1.0) < 1e-12);
    CHECK(contains(refused("", cycle + "mises(axle.tau_max, 30 MPa)\"\n"), "a normal stress first"));
  }

  TEST_CASE("a strength is accepted as any allowable stress, and a stress as none") {
    const std::string limit =
        "[limit]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\nT = \"20 N*m\"\nR_e = \"355 MPa\"\nS = 2\n";
    const std::string part = "[p]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\nT = \"20 N*m\"\ntau_adm = \"=";
    CHECK_MESSAGE(refused("", limit + part + "0.4*limit.R_e\"\n").empty(),
                  refused("", limit + part + "0.4*limit.R_e\"\n"));
    CHECK(contains(refused("", limit + part + "limit.tau_max\"\n"), "'tau_adm' is a strength"));
  }

  TEST_CASE("values refer to each other, in any order") {
    const Solved solved(
        "[values]\nT = \"=2*values.half\"\nhalf = \"=values.P/values.n/2\"\nP = \"15 kW\"\nn = \"1450 rpm\"\n" + axle +
        "T = \"=1*values.T\"\n");
    REQUIRE_MESSAGE(solved.messages().empty(), solved.messages());
    CHECK(std::abs(solved.value("axle.M_max") / (15e3 / (1450.0 * pi / 30.0)) - 1.0) < 1e-12);
    const Solved alone("[values]\na = \"=values.b\"\nb = \"=1.5*values.c\"\nc = \"20 N*m\"\n" + axle +
                       "T = \"=values.a\"\n");
    REQUIRE_MESSAGE(alone.messages().empty(), alone.messages());
    CHECK(alone.value("axle.M_max") == 30.0);
  }

  TEST_CASE("a value may calculate with a result") {
    const Solved solved(
        "[values]\nT = \"=2*first.M_max\"\n" + axle + "T = \"=values.T + 1 N*m\"\n" +
        "[first]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\nT = \"7 N*m\"\n");
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    CHECK(solved.value("axle.M_max") == 15.0);
  }

  TEST_CASE("a circle of values names its members; an unused value is reported, and nothing else") {
    const std::string said =
        refused("a = \"=2*values.b\"\nb = \"=values.c/2\"\nc = \"=values.a + 1 N*m\"\n", axle + "T = \"=values.a\"\n");
    CHECK_MESSAGE(contains(said, "circular reference between values: values.a -> values.b -> values.c -> values.a"),
                  said);
    CHECK(contains(refused("a = \"=2*values.a\"\n", axle + "T = \"=values.a\"\n"), "'values.a' refers to itself"));
    const Solved idle("[values]\na = \"20 N*m\"\nb = \"=2*values.a\"\n" + axle + "T = \"3 N*m\"\n");
    CHECK_MESSAGE(contains(idle.messages(), "nothing refers to 'values.b'"), idle.messages());
    CHECK_MESSAGE(!contains(idle.messages(), "nothing refers to 'values.a'"), idle.messages());
    const Solved wrong("[values]\na = \"20 N*m\"\n" + axle + "T = \"=2*values.a\"\nno_field = 3\n");
    CHECK_MESSAGE(!contains(wrong.messages(), "nothing refers"), wrong.messages());
  }

  TEST_CASE("an expression does not silently take one of several values") {
    for (const char* T : {"=values.T", "=2*values.T", "=values.twice", "=1*values.twice"}) {
      const std::string said =
          refused("T = [\"10 N*m\", \"20 N*m\"]\ntwice = \"=2*values.T\"\n", axle + "T = \"" + T + "\"\n");
      CHECK_MESSAGE(contains(said, "these are 2 values; a single value is required"), T, said);
    }
    const Solved middle("[values]\nT = { mean = \"10 N*m\", sd = \"1 N*m\" }\n" + axle + "T = \"=2*values.T\"\n");
    CHECK_MESSAGE(contains(middle.messages(), "'values.T' is uncertain; computed at its middle value"),
                  middle.messages());
  }

  TEST_CASE("numbers that are read at once may be expressions, too: ranges, distributions, histories, tables") {
    const std::string values = "[values]\nd = \"40 mm\"\nk = 2\nR = \"=0.5*710 MPa\"\n";
    const auto said = [&](const std::string& text) {
      std::vector<Issue> issues;
      const project::Project read =
          project::read_project(values + text, "found.toml", catalogue(), issues, project::Ranges::taken);
      std::string all;
      for (const Issue& issue : issues)
        if (issue.severity == Severity::error) all += issue.message.text() + "\n";
      return all;
    };
    const std::string shaft = "[s]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"100 N*m\"\nd = ";
    CHECK(said(shaft + "{ from = \"=values.d\", to = \"=values.k*values.d\", step = \"=values.d/8\" }\n").empty());
    CHECK(said(shaft + "[\"40 mm\", \"=30 mm + 15 mm\"]\n").empty());
    CHECK(said(shaft + "{ mean = \"=values.d\", sd = \"=5 %\" }\n").empty());
    CHECK(said("[w]\ncalculator = \"fatigue.history\"\ncurve = \"en1993\"\nsigma_C = \"80 MPa\"\nn_req = 1e5\n"
               "sigma = { values = [0, \"=30*values.k\", \"=-10\", 40, 0], unit = \"=values.k*0.5 MPa\" }\n")
              .empty());
    const Solved own(
        values + "[tables.materials.mine]\nR_e = \"=values.R\"\nE = \"=210 GPa\"\nsource = \"certificate\"\n" +
        axle.substr(0, axle.find("tau_adm")) + "d = \"40 mm\"\nT = \"20 N*m\"\nmaterial = \"mine\"\nS = 2\n");
    REQUIRE_MESSAGE(own.errors().empty(), own.errors());
    CHECK(own.value("axle.R_e") == 355e6);
  }

  TEST_CASE("dependencies refer to results: an input of a step that is not yet solved can be taken") {
    const std::string a =
        "[a]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\nT = \"20 N*m\"\nR_e = \"355 MPa\"\nS = 2\nl = "
        "\"=2*b.d_max\"\nG = \"80 GPa\"\n";
    const std::string b =
        "[b]\ncalculator = \"shaft.torsion\"\nd = \"30 mm\"\nT = \"20 N*m\"\nR_e = \"=a.R_e\"\nS = 2\n";
    for (const std::string& text : {a + b, b + a}) {
      const Solved solved(text);
      REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
      CHECK(solved.value("b.R_e") == 355e6);
      CHECK(solved.value("a.l") == 0.06);
    }
    CHECK(contains(
        refused("",
                "[a]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\nT = \"20 N*m\"\nR_e = \"=b.R_e\"\nS = 2\n"
                "[b]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\nT = \"20 N*m\"\nR_e = \"=a.R_e\"\nS = 2\n"),
        "circular reference between steps"));
  }

  TEST_CASE("a step does not wait for itself") {
    const std::string own =
        axle.substr(0, axle.find("tau_adm")) + "T = \"200 N*m\"\nmaterial = \"C45E\"\ntau_adm = \"=0.4*axle.R_e\"\n";
    CHECK(contains(refused("", own), "circular reference between steps: axle -> axle"));
    CHECK(contains(refused("", own + "d = \"40 mm\"\nR_e = \"=axle.R_e\"\n"),
                   "circular reference between steps: axle -> axle"));
  }

  TEST_CASE("a deferred input takes a value that depends on a search which needs the step") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\n"
        "pieces = [{ l = \"60 mm\", d = \"?\" }, { l = \"140 mm\", d = \"?\" }]\n"
        "supports = [{ x = \"70 mm\", holds = \"both\" }, { x = \"190 mm\" }]\n"
        "seats = [{ x = \"30 mm\", T = \"100 N*m\", F_x = \"2 kN\", way = \"drives\" }, "
        "{ x = \"130 mm\", T = \"100 N*m\", way = \"takes\" }]\n"
        "notches = [{ x = \"45 mm\", part = \"=key.notch\" }, { x = \"60 mm\", kind = \"shoulder\", r = \"1 mm\" }]\n"
        "S_F = 1.5\nS_D = 1.5\nr_T = 0\nR_z = \"6.3 um\"\n";
    const std::string key =
        "[key]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\ntorque = \"one_way\"\nd = \"40 mm\"\nkey = \"12x8\"\n"
        "l = \"45 mm\"\nl_n = \"50 mm\"\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n";
    const Solved typed(shaft + key + "R_e_1 = \"300 MPa\"\n");
    for (const std::string& text :
         {shaft + key + "R_e_1 = \"=shaft.R_e\"\n", key + "R_e_1 = \"=shaft.R_e\"\n" + shaft}) {
      const Solved solved(text);
      REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
      CHECK(solved.value("key.R_e_1") == solved.value("shaft.R_e"));
      CHECK(solved.value("shaft.pieces[1].d") == typed.value("shaft.pieces[1].d"));
    }
  }

  TEST_CASE("formulas of books for numbers without units, and circles without pi, are refused") {
    const std::string of_drive = "P = \"3 kW\"\nn = \"960 rpm\"\nd = \"80 mm\"\nv = \"2 m/s\"\np = \"16 MPa\"\n";
    for (const char* const T : {"9550*values.P/values.n", "9.55*values.P/values.n", "9549.3*values.P/values.n"})
      CHECK_MESSAGE(contains(refused(of_drive, axle + "T = \"=" + T + "\"\n"), "converts kW and rpm to N m"), T);
    CHECK(refused(of_drive, axle + "T = \"=95*values.P/values.n\"\n").empty());
    CHECK(contains(refused(of_drive, fan + "omega = \"=values.v/values.d\"\n"), "is half the angular velocity"));
    CHECK(omega_of("v = \"2 m/s\"\nd = \"80 mm\"\n", "2*values.v/values.d") == doctest::Approx(50.0));
    CHECK(omega_of("v = \"2 m/s\"\nr = \"40 mm\"\n", "values.v/values.r") == doctest::Approx(50.0));
    const auto lug = [&](const std::string& F) {
      return refused(of_drive,
                     "[lug]\ncalculator = \"pin.lug\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 "
                     "mm\"\nsigma_adm = \"80 MPa\"\ntau_adm = \"40 MPa\"\np_adm = \"80 MPa\"\nF = \"=" +
                         F + "\"\n");
    };
    CHECK(contains(lug("values.d^2/4*values.p"), "is not the area of a circle"));
    CHECK(lug("pi*values.d^2/4*values.p").empty());
    CHECK(contains(lug("pi*values.d^2/16*values.p"), "is a quarter of the area of a circle"));
    CHECK(lug("pi*values.d^2/4*values.p/4").empty());  // four rods
    CHECK(lug("values.d^2*values.p").empty());
  }

  TEST_CASE("the arm of a force is half of its diameter, and 16 T/(pi d^3) is a shear stress") {
    const std::string of_drum = "F = \"2 kN\"\nd = \"80 mm\"\nl = \"80 mm\"\nM = \"90 N*m\"\n";
    const auto torque = [&](const std::string& T) { return refused(of_drum, axle + "T = \"=" + T + "\"\n"); };
    for (const char* const T : {"values.F*values.d/4", "0.25*values.F*values.d"})
      CHECK_MESSAGE(contains(torque(T), "half of the torque"), T);
    for (const char* const T : {"values.F*values.d/2", "values.F/2*values.d/2", "values.F*values.l/4"})
      CHECK_MESSAGE(torque(T).empty(), T);
    const auto stress = [&](const std::string& sigma) {
      return refused(of_drum, "[c]\ncalculator = \"fatigue.cycle\"\nr = -1\nsigma_max = \"=" + sigma + "\"\n");
    };
    CHECK(contains(stress("16*values.M/(pi*values.d^3)"), "shear stress"));
    CHECK(contains(stress("90 N*m*16/(pi*values.d^3)"), "shear stress"));
    CHECK(stress("32*values.M/(pi*values.d^3)").empty());
    CHECK(stress("16/(pi*values.d^3)*(values.M + values.F*values.l)").empty());
  }

  TEST_CASE("an expression gets the same warnings and errors as its number") {
    for (const char* G : {"\"900 GPa\"", "\"=900 GPa\"", "\"=3*values.G\""}) {
      const Solved solved("[values]\nG = \"300 GPa\"\n" + axle + "T = \"20 N*m\"\nl = \"1 m\"\nG = " + G + "\n");
      CHECK_MESSAGE(contains(solved.messages(), "G = 900 GPa is unusual"), G, solved.messages());
    }
    for (const char* T : {"\"1e40 N*m\"", "\"=1e40 N*m\"", "\"=1e30*values.T\""})
      CHECK_MESSAGE(contains(refused("T = \"1e10 N*m\"\n", axle + "T = " + T + "\n"), "is implausible"), T);
    for (const char* n : {"2,5 kN*m", "=2,5 kN*m", "=2.5 kN*m"}) {
      const Solved solved(axle + "T = \"" + n + "\"\n");
      CHECK_MESSAGE(solved.errors().empty(), solved.errors());
      CHECK(solved.value("axle.M_max") == 2500.0);
    }
  }
}
