// Factors, motors and inertias of one step that another one leaves out.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string post_with(const std::string& factor) {
  return "[post]\ncalculator = \"column.buckling\"\nP = \"200 kN\"\nl = \"3.5 m\"\nsection = \"HEA 140\"\n"
         "ends = \"pinned_pinned\"\nmaterial = \"S235\"\nmethod = \"ec3\"\ngamma_M1 = 1.1\n" +
         factor +
         "[pin]\ncalculator = \"pin.en1993\"\nF = \"=post.P\"\ngamma_F = 1.35\ngamma_M0 = 1\ngamma_M2 = 1.25\n"
         "d = \"60 mm\"\nd_0 = \"61 mm\"\nt_1 = \"30 mm\"\nt_2 = \"20 mm\"\nc = \"2 mm\"\nf_yp = \"355 MPa\"\n"
         "f_up = \"490 MPa\"\nf_y_1 = \"235 MPa\"\nf_y_2 = \"235 MPa\"\n";
}

const std::string train = R"([train]
calculator = "drive.train"
P = "5 kW"
n_1 = "1450 rpm"
stages = [{ name = "c", kind = "gear", z_1 = 20, z_2 = 60, eta = 0.97 }]
)";

const std::string wheel = R"toml([wheel]
calculator = "machine.flywheel"
M_of_phi = "33 N*m + 60 N*m*sin(phi)"
omega = "1440 rpm"
J = "2 kg*m^2"
delta = 0.02
)toml";

struct Run {
  std::string parts = "", last = "33 N*m", n_2 = "1440 rpm", u = "=abs(1/train.i)", more = "";
};

std::string run_with(const Run& run) {
  return train +
         "[run]\ncalculator = \"machine.run_up\"\nparts = [{ J = \"0.05 kg*m^2\" }, { J = \"3.6 kg*m^2\", u = \"" +
         run.u + "\" }" + run.parts +
         "]\nmotor = [[\"0 rpm\", \"90 N*m\"], [\"1000 rpm\", \"80 N*m\"], [\"1450 rpm\", \"" + run.last +
         "\"]]\nload = [[\"0 rpm\", \"2 N*m\"], [\"1450 rpm\", \"30 N*m\"]]\nn_2 = \"" + run.n_2 +
         "\"\nt_adm = \"30 s\"\n" + run.more;
}

std::string time_of(const std::string& text) { return mode_of(solved_as_found(text), "run", "time"); }

std::string started(const std::string& motor, const std::string& more = "") {
  return "[gears]\ncalculator = \"gear.pair\"\nz_1 = 25\nz_2 = 60\nm_n = \"4 mm\"\nb = \"40 mm\"\nT_1 = \"150 N*m\"\n"
         "n_1 = \"1450 rpm\"\nK_A = 1.25\n"
         "[run]\ncalculator = \"machine.run_up\"\nparts = [{ J = \"1 kg*m^2\" }]\nmotor = [[\"0 rpm\", \"" +
         motor + "\"], [\"1450 rpm\", \"" + motor +
         "\"]]\nload = [[\"0 rpm\", \"50 N*m\"], [\"1450 rpm\", \"50 N*m\"]]\nn_2 = \"=gears.n_1\"\nt_adm = \"10 "
         "s\"\n" +
         more;
}

}  // namespace

TEST_SUITE("found factors elsewhere") {
  TEST_CASE("a load has the partial factor that the step which takes it applies") {
    CHECK(mode_of(solved_as_found(post_with("gamma_F = 1\n")), "post", "buckling") == "not-judged");
    CHECK(mode_of(solved_as_found(post_with("gamma_F = 1.35\n")), "post", "buckling") == "pass");
    CHECK(mode_of(solved_as_found(post_with("gamma_F = 1\nbecause.gamma_F = \"P is a design load\"\n")), "post",
                  "buckling") == "pass");
  }

  TEST_CASE("a run ends at the speed of a shaft, by a motor of the power of the train") {
    CHECK(time_of(run_with({})) == "pass");
    CHECK(time_of(run_with({.n_2 = "300 rpm"})) == "not-judged");
    CHECK(time_of(run_with({.last = "330 N*m"})) == "not-judged");
    CHECK(time_of(run_with({.last = "330 N*m", .more = "because.motor = \"drives two trains\"\n"})) == "pass");
  }

  TEST_CASE("a ratio of speeds is a ratio or its reciprocal") {
    CHECK(time_of(run_with({.u = "=1/train.i^2"})) == "not-judged");
    CHECK(time_of(run_with({.u = "=1/train.i"})) == "pass");
    CHECK(time_of(run_with({.parts = ", { J = \"1 kg*m^2\", u = \"=abs(1/train.i)\" }", .u = "0.001"})) ==
          "not-judged");  // no shaft of the train turns so slowly
  }

  TEST_CASE("a flywheel at the speed of the run is accelerated in full") {
    CHECK(time_of(wheel + run_with({})) == "not-judged");
    CHECK(time_of(wheel + run_with({.parts = ", { J = \"=wheel.J/100\" }"})) == "not-judged");
    CHECK(time_of(wheel + run_with({.parts = ", { J = \"=wheel.J\" }"})) == "pass");
    CHECK(time_of(wheel + run_with({.parts = ", { J = \"2 kg*m^2\" }"})) == "pass");
    CHECK(time_of(wheel + run_with({.more = "because.parts = \"behind a clutch\"\n"})) == "pass");
    CHECK(time_of(wheel + run_with({.n_2 = "=wheel.omega"})) == "not-judged");  // which takes its speed only
  }

  TEST_CASE("a run is by the motor that the flywheel is made for") {
    const auto with = [](const std::string& P_n) {
      return time_of(wheel + "P_n = \"" + P_n + "\"\n" + run_with({.parts = ", { J = \"=wheel.J\" }"}));
    };
    CHECK(with("5 kW") == "pass");
    CHECK(with("1 kW") == "not-judged");  // 6.6 N m, and the motor has 90 N m
  }

  TEST_CASE("a motor that starts a shaft beyond its application factor needs a peak factor") {
    CHECK(mode_of(solved_as_found(started("450 N*m")), "run", "stall") == "not-judged");
    CHECK(mode_of(solved_as_found(started("180 N*m")), "run", "stall") == "pass");
    CHECK(mode_of(solved_as_found(started("450 N*m", "because.motor = \"rotor takes two thirds\"\n")), "run",
                  "stall") == "pass");
  }

  TEST_CASE("a motor that starts a shaft without an application factor needs the peak torque of its key") {
    const auto key = [](const std::string& T_max) {
      return run_with({.n_2 = "=train.n_1"}) + "[key]\ncalculator = \"shaft.key\"\nT = \"=train.T_1\"\n" + T_max +
             "torque = \"one_way\"\nd = \"25 mm\"\nkey = \"8x7\"\nl = \"40 mm\"\nl_n = \"45 mm\"\n"
             "R_e_1 = \"370 MPa\"\nR_e_2 = \"200 MPa\"\nR_e_k = \"420 MPa\"\n";
    };
    CHECK(time_of(key("")) == "not-judged");
    CHECK(time_of(key("T_max = \"90 N*m\"\n")) == "pass");
  }

  TEST_CASE("the peak torque of a start is stated with or without the application factor, the service torque with it") {
    const auto key = [](const std::string& lines) {
      return "[gears]\ncalculator = \"gear.pair\"\nz_1 = 25\nz_2 = 60\nm_n = \"4 mm\"\nb = \"40 mm\"\nT_1 = \"40 "
             "N*m\"\nn_1 = \"1450 rpm\"\nK_A = 1.25\n[key]\ncalculator = \"shaft.key\"\ntorque = \"one_way\"\nd = \"40 "
             "mm\"\nkey = \"12x8\"\nl = \"45 mm\"\nl_n = \"50 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"370 MPa\"\nR_e_k = "
             "\"420 MPa\"\nS_F = 1.5\n" +
             lines;
    };
    const auto pressure = [&](const std::string& lines) { return mode_of(solved_as_found(key(lines)), "key", "key"); };
    const std::string with = "T = \"=gears.gear_2.T\"\n", without = "T = \"=gears.gear_2.T/gears.K_A\"\n",
                      peak = "T_max = \"=2.5*gears.gear_2.T\"\n",
                      nominal_peak = "T_max = \"=2.5/gears.K_A*gears.gear_2.T\"\n", K_A = "K_A = \"=gears.K_A\"\n";
    for (const std::string& start : {peak, nominal_peak}) {
      CHECK(pressure(with + start) == "pass");
      CHECK(pressure(without + start + K_A) == "pass");
      CHECK(pressure(without + start) == "not-judged");
      CHECK(first_error_of(key(with + start + K_A)).find("K_A would be applied twice: 'T'") != std::string::npos);
    }
  }

  TEST_CASE("a key with the typed torque of a machine has its application factor") {
    const auto pressed = [](const std::string& T, const std::string& more = "") {
      return mode_of(
          solved_as_found("[gears]\ncalculator = \"gear.pair\"\nz_1 = 25\nz_2 = 60\nm_n = \"4 mm\"\nb = \"40 "
                          "mm\"\nT_1 = \"300 N*m\"\nn_1 = \"1450 rpm\"\nK_A = 1.25\n\n[key]\ncalculator = "
                          "\"shaft.key\"\ntorque = \"one_way\"\nd = \"50 mm\"\nkey = \"14x9\"\nl = \"70 mm\"\n"
                          "l_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nT = \"" +
                          T + "\"\n" + more),
          "key", "shaft");
    };
    CHECK(pressed("300 N*m") == "not-judged");
    CHECK(pressed("300 N*m", "K_A = 1.25\n") == "pass");
    CHECK(pressed("300 N*m", "because.K_A = \"on the side of the smooth load\"\n") == "pass");
    CHECK(pressed("310 N*m") == "pass");  // another shaft
    CHECK(pressed("375 N*m") == "pass");  // with the factor
  }

  TEST_CASE("a torque divided by its factor, in a step that applies this factor, is the full torque") {
    const auto key = [](const std::string& T, const std::string& K_A) {
      const std::string text =
          "[values]\nK_A = 1.25\n\n[wheels]\ncalculator = \"drive.friction_wheels\"\nP = \"1.5 kW\"\nK_A = "
          "\"=values.K_A\"\nn_1 = \"700 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"600 mm\"\nb = \"80 mm\"\npair = "
          "\"leather\"\nq_adm = \"30 N/mm\"\n\n[key]\ncalculator = \"shaft.key\"\nT = \"" +
          T + "\"\nK_A = " + K_A +
          "\ntorque = \"one_way\"\nd = \"25 mm\"\nkey = \"8x7\"\nl = \"40 mm\"\nl_n = \"45 mm\"\n"
          "R_e_1 = \"370 MPa\"\nR_e_2 = \"200 MPa\"\nR_e_k = \"420 MPa\"\n";
      return mode_of(solved_as_found(text), "key", "hub");
    };
    CHECK(key("=wheels.shaft_2.T/values.K_A", "\"=values.K_A\"") == "pass");
    CHECK(key("=0.8*wheels.shaft_2.T/values.K_A", "\"=values.K_A\"") == "not-judged");
    CHECK(key("=wheels.shaft_2.T/1.25", "1") == "not-judged");
  }
}
