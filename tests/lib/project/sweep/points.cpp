// Points of the ranges, lists, stocks, words and distributions of a project, one by one.
#include "lib/project/solving/solve.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/sweep/swept.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::Solved;
using test::Swept;

namespace {

const std::string shaft =
    "[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nG = \"81 GPa\"\ntheta_adm = "
    "\"0.25 deg/m\"\nl = \"1 m\"\n";

double number_of(State state) { return static_cast<double>(state); }

/// The states of two points, each that of a run of its own, which differ.
void check_two_states(const std::string& text) {
  CAPTURE(text);
  const Swept swept(text, {});
  REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<Issue> issues;
    project::Project alone = swept.read(issues);
    project::set_point(alone, swept.plan, i, issues);
    project::solve(alone, issues);
    CHECK(number_of(account::overall(project::modes(alone))) == swept.column("state")[i]);
  }
  CHECK(swept.column("state")[0] != swept.column("state")[1]);
}

/// The same in either order of the two values that stand for '#'.
void check_in_either_order(const std::string& text, const std::string& a, const std::string& b) {
  for (const std::string& values : {"[" + a + ", " + b + "]", "[" + b + ", " + a + "]"}) {
    std::string all = text;
    all.replace(all.find('#'), 1, values);
    check_two_states(all);
  }
}

}  // namespace

TEST_SUITE("points of a sweep") {
  TEST_CASE("a range, crossed with a list: the last in the file runs fastest") {
    const Swept swept(shaft +
                          "T = { from = \"100 N*m\", to = \"300 N*m\", step = \"100 N*m\" }\nd = [\"40 mm\", \"60 "
                          "mm\"]\n",
                      {"shaft.tau_max", "shaft.passes"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    CHECK(swept.input("shaft.T") == std::vector<double>{100, 100, 200, 200, 300, 300});
    CHECK(swept.input("shaft.d") == std::vector<double>{0.04, 0.06, 0.04, 0.06, 0.04, 0.06});
    for (std::size_t i = 0; i < 6; ++i) {
      const double T = swept.input("shaft.T")[i], d = swept.input("shaft.d")[i];
      CHECK(swept.column("shaft.tau_max")[i] == Approx(16.0 * T / (M_PI * d * d * d)).epsilon(1e-12));
    }
  }

  TEST_CASE("a point is the machine with its values typed, to the bit") {
    const std::string text = shaft +
                             "d = [\"20 mm\", \"60 mm\"]\nT = { from = \"100 N*m\", to = \"1 kN*m\", log = 5 "
                             "}\n";
    const Swept swept(text, {"shaft.tau_max", "shaft.theta_max"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    for (std::size_t i = 0; i < 10; ++i) {
      std::vector<Issue> issues;
      project::Project alone = swept.read(issues);
      project::set_point(alone, swept.plan, i, issues);
      project::solve(alone, issues);
      REQUIRE(!has_errors(issues));
      CHECK(alone.value("shaft.tau_max")->si[0] == swept.column("shaft.tau_max")[i]);
      CHECK(alone.value("shaft.theta_max")->si[0] == swept.column("shaft.theta_max")[i]);
      const auto modes = project::modes(alone);
      CHECK(number_of(account::overall(modes)) == swept.column("state")[i]);
      for (const account::Mode& mode : modes)
        CHECK(number_of(mode.state) == swept.column(mode.step + ".modes." + mode.id + ".state")[i]);
    }
  }

  TEST_CASE("any number of threads gives the same bits in the same order") {
    const std::string text = shaft +
                             "d = { from = \"20 mm\", to = \"60 mm\", count = 41 }\nT = { mean = \"200 N*m\", sd "
                             "= \"10 %\" }\n[project]\nsweep = { samples = 20, seed = 7 }\n";
    const Swept one(text, {"shaft.tau_max"}, 1), three(text, {"shaft.tau_max"}, 3);
    REQUIRE_MESSAGE(one.errors().empty(), one.errors());
    REQUIRE(one.column("shaft.tau_max").size() == 820);
    CHECK(one.column("shaft.tau_max") == three.column("shaft.tau_max"));
    CHECK(one.input("shaft.T") == three.input("shaft.T"));
  }

  TEST_CASE("sizes of a stock, rows of tables, words") {
    const Swept sizes(shaft + "T = \"100 N*m\"\nd = { each = \"R40\", from = \"30 mm\", to = \"34 mm\" }\n",
                      {"shaft.tau_max"});
    REQUIRE_MESSAGE(sizes.errors().empty(), sizes.errors());
    CHECK(sizes.input("shaft.d").size() == 3);  // 30, 32, 34
    const std::string rows =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"100 N*m\"\nd = \"30 mm\"\ntau_adm = \"30 "
        "MPa\"\ntheta_adm = \"0.25 deg/m\"\nmaterial = [\"C45E\", \"S355\"]\n";
    const Swept materials(rows, {"shaft.tau_max", "shaft.G"});
    CHECK_MESSAGE(materials.errors().empty(), materials.errors());
  }

  TEST_CASE("inputs that vary together") {
    const Swept swept(shaft +
                          "T = [\"100 N*m\", \"200 N*m\"]\nd = [\"40 mm\", \"60 mm\"]\n[project]\nsweep = { zip = "
                          "[[\"shaft.T\", \"shaft.d\"]] }\n",
                      {"shaft.tau_max"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    CHECK(swept.input("shaft.T") == std::vector<double>{100, 200});
    CHECK(swept.input("shaft.d") == std::vector<double>{0.04, 0.06});
  }

  TEST_CASE("a value of [values] is one input, alone and in expressions") {
    const Swept swept(
        "[values]\nT = [\"100 N*m\", \"200 N*m\"]\n[a]\ncalculator = \"shaft.torsion\"\nT = "
        "\"=values.T\"\ntau_adm = \"30 MPa\"\n[b]\ncalculator = \"shaft.torsion\"\nT = "
        "\"=2*values.T\"\ntau_adm = \"30 MPa\"\n",
        {"a.T", "b.T"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    CHECK(swept.plan.inputs.size() == 1);
    CHECK(swept.column("a.T") == std::vector<double>{100, 200});
    CHECK(swept.column("b.T") == std::vector<double>{200, 400});
  }

  TEST_CASE("points that break a rule are marked, and do not affect the next ones") {
    const Swept swept(
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"100 N*m\"\ntau_adm = \"30 MPa\"\nd = \"30 "
        "mm\"\nd_h = [\"35 mm\", \"10 mm\", \"35 mm\"]\n",
        {"shaft.tau_max"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    CHECK(swept.column("state")[1] == account::refused_state);
    CHECK(std::isnan(swept.column("shaft.tau_max")[1]));
    CHECK(swept.refusals.size() == 1);
    CHECK(swept.column("shaft.tau_max")[0] == swept.column("shaft.tau_max")[2]);
  }

  TEST_CASE("data in a step on the part whose load it takes are compared at every point") {
    const auto shaft_modes = [](const std::string& d) {
      const Swept swept(
          "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"200 N*m\"\ntau_adm = \"40 MPa\"\nd = \"" + d +
              "\"\n[key]\ncalculator = \"shaft.key\"\nT = \"=shaft.T\"\ntorque = \"one_way\"\nd = \"50 mm\"\n"
              "key = \"14x9\"\nl = [\"70 mm\", \"71 mm\"]\nl_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\n"
              "R_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\n",
          {"key.u_t"});
      REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
      return swept.column("key.modes.shaft.state");
    };
    CHECK(shaft_modes("50 mm") == std::vector<double>(2, static_cast<double>(account::State::pass)));
    CHECK(shaft_modes("30 mm") == std::vector<double>(2, static_cast<double>(account::State::not_judged)));
  }

  TEST_CASE("data of the project next to a step are compared at every point, in either order") {
    const std::string left_out = "[values]\nT_start = \"150 N*m\"\n\n" + shaft + "d = \"60 mm\"\nT = ";
    const std::string limit =
        "[s]\ncalculator = \"fatigue.survival\"\nsigma_0 = \"288 MPa\"\nN_0 = 1e6\nT_S = 1.25\nk = 5\n"
        "P = 0.975\n\n[shaft]\ncalculator = \"fatigue.life\"\nsigma_max = \"100 MPa\"\nsigma_min = "
        "\"-100 MPa\"\nR_m = \"690 MPa\"\nR_e = \"490 MPa\"\ngroup = \"carbon-steel\"\nS_D = 1.5\nS_F = "
        "1.5\nsigma_D = ";
    check_in_either_order(left_out + "#\n", "\"160 N*m\"", "\"100 N*m\"");
    check_in_either_order(limit + "#\n", "\"200 MPa\"", "\"300 MPa\"");
  }

  TEST_CASE("names of stated values, motors and stages of trains are compared at every point") {
    check_in_either_order(
        "[values]\nlife = \"20000 h\"\n\n[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6308\"\nF_r = \"2 kN\"\n"
        "n = \"1000 rpm\"\ns_0 = 1.5\nL_h = #\n",
        "\"30000 h\"", "\"10000 h\"");
    const std::string wheels =
        "[w]\ncalculator = \"drive.friction_wheels\"\nn_1 = \"700 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"600 mm\"\nepsilon = "
        "0.02\nb = \"80 mm\"\npair = \"leather\"\nq_adm = \"30 N/mm\"\nP = ";
    check_in_either_order("[values]\nP_motor = \"1.1 kW\"\n\n" + wheels + "#\n", "\"1 kW\"", "\"1.5 kW\"");
    const auto train = [](const std::string& P) {
      return "\n[tr]\ncalculator = \"drive.train\"\nn_1 = \"700 rpm\"\nstages = [{ name = \"wheels\", kind = "
             "\"other\", i = "
             "3.0612, eta = 0.9 }]\nP = " +
             P + "\n";
    };
    check_in_either_order(wheels + "\"1.5 kW\"\n" + train("#"), "\"1.5 kW\"", "\"15 kW\"");
    check_in_either_order(wheels + "#\n" + train("\"1.5 kW\""), "\"1.5 kW\"", "\"0.7 kW\"");
  }

  TEST_CASE("a value that needs a reason at some points only, typed and by [values]") {
    const auto column = [](const std::string& rho) {
      return "[column]\ncalculator = \"column.stepped\"\nfoot = \"fixed\"\ntop = \"free\"\nparts = [{ name = "
             "\"lower\", "
             "l = \"3 m\", d = \"160 mm\", P = \"100 kN\" }, { name = \"upper\", l = \"2 m\", d = \"125 mm\", P = \"60 "
             "kN\" }]\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nn_st = 2.5\nrho = " +
             rho + "\n";
    };
    check_in_either_order(column("#"), "\"7850 kg/m^3\"", "\"2355 kg/m^3\"");
    check_in_either_order(column("\"=values.rho_s\"") + "\n[values]\nrho_s = #\n", "\"7850 kg/m^3\"",
                          "\"2355 kg/m^3\"");
  }

  TEST_CASE("the modes of a key that a stated peak concerns, at every point") {
    const std::string key =
        "[values]\nk_start = 2\n\n[key]\ncalculator = \"shaft.key\"\nT = \"300 N*m\"\ntorque = \"one_way\"\nd = \"50 "
        "mm\"\nkey = \"14x9\"\nl = \"70 mm\"\nl_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 "
        "MPa\"\nT_max = ";
    const auto pressed = [&](const std::string& T_max) {
      const Swept swept(key + T_max + "\n", {});
      REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
      return swept.column("key.modes.shaft.state");
    };
    const double pass = number_of(State::pass), held = number_of(State::not_judged);
    CHECK(pressed("[\"700 N*m\", \"400 N*m\"]") == std::vector<double>{pass, held});
    CHECK(pressed("[\"400 N*m\", \"700 N*m\"]") == std::vector<double>{held, pass});
  }

  TEST_CASE("errors in a range are reported") {
    const auto fault = [](const std::string& T, const std::string& more = "") {
      return Swept(shaft + "d = \"40 mm\"\nT = " + T + "\n" + more, {}).errors();
    };
    CHECK(contains(fault("{ from = \"100 N*m\", to = \"300 N*m\", step = \"1 N*m\", count = 3 }"),
                   "one of step, count, log"));
    CHECK(contains(fault("{ from = \"100 N*m\", to = \"300 N*m\", step = \"-1 N*m\" }"), "leads away"));
    CHECK(contains(fault("{ from = \"100 N*m\", to = \"300 mm\", count = 3 }"), "300 mm"));
    CHECK(contains(fault("{ from = \"100 N*m\", to = \"300 N*m\", count = 2.5 }"), "integer"));
    CHECK(contains(fault("[]"), "empty"));
    CHECK(contains(fault("{ mean = \"100 N*m\", sd = \"-5 N*m\" }"), "> 0"));
    CHECK(contains(fault("{ mean = \"100 N*m\", sd = \"5 mm\" }"), "moment"));
    CHECK(contains(fault("{ mean = \"100 N*m\" }"), "'sd' is missing"));
    CHECK(contains(fault("[\"1 N*m\", \"2 N*m\"]", "[project]\nsweep = { zip = [[\"shaft.X\"]] }\n"), "'shaft.X'"));
    CHECK(contains(Solved(shaft + "d = \"40 mm\"\nT = [\"1 N*m\", \"2 N*m\"]\n").errors(), "loadpath sweep"));
    CHECK(
        contains(Solved(shaft + "d = \"40 mm\"\nT = { mean = \"1 N*m\", sd = \"5 %\" }\n").messages(), "middle value"));
  }

  TEST_CASE("results that cannot be read are reported") {
    const auto fault = [](const std::string& result) {
      return Swept(shaft + "d = \"40 mm\"\nT = [\"1 N*m\", \"2 N*m\"]\n", {result}).errors();
    };
    CHECK(contains(fault("shaft.tau_mex"), "tau_max"));
    CHECK(contains(fault("axle.tau_max"), "unknown step 'axle'"));
    CHECK(contains(fault("shaft.modes.yields"), "did you mean"));
    CHECK(contains(fault("2*"), "project.sweep"));
    CHECK(fault("m = 2*shaft.tau_max").empty());
    CHECK(fault("shaft.utilisation").empty());
  }

  TEST_CASE("words and rows of tables keep their place in the file too") {
    const Swept swept(
        "[strut]\ncalculator = \"column.buckling\"\nsection = [\"HEA 160\", \"HEA 200\"]\nl = [\"3 m\", \"4 m\"]\n"
        "P = \"300 kN\"\nmaterial = [\"S235JR\", \"S355J2\"]\nends = \"pinned_pinned\"\n"
        "method = [\"ec3\", \"euler\"]\nsigma_P = \"190 MPa\"\nn_st = 3\ngamma_M1 = 1\ngamma_F = 1.4\n");
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    std::vector<std::string> names;
    for (const auto& input : swept.plan.inputs) names.push_back(input.name);
    CHECK(names == std::vector<std::string>{"strut.section", "strut.l", "strut.material", "strut.method"});
    CHECK(swept.plan.at(1) == std::vector<double>{0, 3, 0, 1});
    CHECK(swept.plan.at(8) == std::vector<double>{1, 3, 0, 0});
  }

  TEST_CASE("a result is shown in the unit of the numbers that it is made of") {
    const Swept swept(shaft + "T = [\"100 N*m\", \"200 N*m\"]\nd = \"60 mm\"\n",
                      {"twice = 2*shaft.T", "shaft.tau_max", "p = shaft.T*shaft.theta_max"});
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    CHECK(swept.plan.columns[0].unit == "N*m");
    CHECK(swept.plan.columns[1].unit == "MPa");
    CHECK(swept.plan.columns[2].unit == "kg*m*rad/s^2");
  }

  TEST_CASE("a name that is not a result is refused") {
    const auto refusal = [](const std::string& result) {
      return Swept(shaft + "T = [\"100 N*m\", \"200 N*m\"]\nd = \"60 mm\"\n", {result}).errors();
    };
    CHECK(contains(refusal("shaft.tau_max >= 3 MPa"), "a result is a number, not a comparison"));
    CHECK(contains(refusal("m == shaft.tau_max"), "a result is a number, not a comparison"));
    CHECK(contains(refusal("= shaft.tau_max"), "a name is missing before '='"));
    CHECK(contains(refusal("state = shaft.tau_max"), "'state' is a column of every sweep"));
    CHECK(contains(refusal("shaft.modes."), "'shaft' has no mode ''"));
    CHECK(refusal("state").empty());
    CHECK(refusal("utilisation = utilisation").empty());
  }
}
