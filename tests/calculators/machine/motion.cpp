#include "calculators/machine/motion/periodic_cells.hpp"
#include "tests/calculators/motion/solved.hpp"

#include <array>

using namespace loadpath::test;
using loadpath::account::State;

namespace {

SolvedStep machine(const std::string& lines) { return {"machine.motion", lines}; }

// 120 N m at rest, straight to zero at 100 rpm
const std::string straight = "M_A = \"120 N*m\"\nn_0 = \"100 rpm\"\n";
const double tau = 20.0 * (100.0 * 3.141592653589793 / 30.0) / 120.0;  // of 20 kg m^2

/// A slider crank under this machine, solved.
struct CrankPress {
  std::vector<loadpath::Issue> issues;
  loadpath::project::Project project;

  explicit CrankPress(const std::string& lines)
      : project(loadpath::project::read_project(text(lines), "press.toml", loadpath::catalogue(), issues)) {
    if (!loadpath::has_errors(issues)) loadpath::project::solve(project, issues);
  }
  static std::string text(const std::string& lines) {
    return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"80 mm\"\nl = \"240 "
           "mm\"\ncrank = { speed = \"300 rpm\", positions = 180 }\ngravity = \"9.81 m/s^2\"\nlinks.rod.mass = \"14 "
           "kg\"\nlinks.slider.mass = \"35 kg\"\n[m]\ncalculator = \"machine.motion\"\nJ_red = "
           "\"=press.drive.J_red\"\nJ_F = \"2 kg*m^2\"\nM_A = \"120 N*m\"\nn_0 = \"300 rpm\"\n" +
           lines;
  }
  [[nodiscard]] double operator()(const std::string& path) const {
    REQUIRE(!loadpath::has_errors(issues));
    return project.value("m." + path)->si[0];
  }
};

}  // namespace

TEST_SUITE("machine motion") {
  TEST_CASE("driving torque less the inertia at constant speed is the reduced moment of the loads") {
    const CrankPress by_loads("M = \"=-press.drive.M_red\"\n");
    const CrankPress by_drive("M = \"=press.drive.M\"\nn_M = \"300 rpm\"\n");
    CHECK(near(by_loads("delta"), by_drive("delta"), 1e-4));
    CHECK(near(by_loads("n_m"), by_drive("n_m"), 1e-5));
    CHECK(near(by_loads("t_E"), by_drive("t_E"), 1e-3));
  }

  TEST_CASE("a driving torque with inertia forces, without the speed of its analysis, is refused") {
    const CrankPress twice("M = \"=press.drive.M\"\n");
    REQUIRE(loadpath::has_errors(twice.issues));
    CHECK(contains(twice.issues.front().message.text(), "includes the inertia forces"));
  }

  TEST_CASE("a moment of a mechanism with the sign of a driving moment is refused as a load") {
    for (const std::string load : {"M = \"=press.drive.M_red\"\n", "M = \"=-press.drive.M\"\nn_M = \"300 rpm\"\n"}) {
      CAPTURE(load);
      const CrankPress turned(load);
      REQUIRE(loadpath::has_errors(turned.issues));
      CHECK(contains(turned.issues.front().message.text(), "positive"));
    }
  }

  TEST_CASE("a motor with a linear characteristic runs up a constant load as an exponential of the time") {
    const auto r = machine(straight + "J_F = \"20 kg*m^2\"\nM = \"60 N*m\"\n");
    CHECK(near(r("t_E"), tau * std::log(200.0), 1e-6));
    CHECK(near(r("turns"), (tau * std::log(200.0) - tau * 0.995) * 5.0 / 6.0, 1e-6));
    CHECK(near(r("n_m"), 50.0 * 3.141592653589793 / 30.0, 1e-8));
    CHECK(r("delta") < 1e-8);
  }

  TEST_CASE("rotor and flywheel count with the square of their speeds") {
    const auto r = machine(
        "M_A = \"12 N*m\"\nn_0 = \"1000 rpm\"\ni = 10\nJ_F = \"10 kg*m^2\"\nJ_M = \"0.1 kg*m^2\"\nM = \"60 N*m\"\n");
    CHECK(near(r("J_m"), 20.0));
    CHECK(near(r("t_E"), tau * std::log(200.0), 1e-6));
  }

  TEST_CASE("without load the energy is constant, and the speed follows the variable inertia") {
    const auto r = machine(
        "M_A = \"1 N*m\"\nn_0 = \"100 rpm\"\nM = \"0 N*m\"\nJ_F = \"20 kg*m^2\"\nJ_of_phi = \"2 kg*m^2 - 2 "
        "kg*m^2*cos(2*phi)\"\n");
    CHECK(near(r("n_max") / r("n_min"), std::sqrt(24.0 / 20.0), 1e-3));
  }

  TEST_CASE("a small fluctuation agrees with the flywheel formula: Delta_E/(J omega^2)") {
    // the motor hardly falls within a cycle: M_L = 60 + 30 sin phi, Delta_E = 60 J
    const auto r = machine(straight + "J_F = \"2000 kg*m^2\"\nM_of_phi = \"60 N*m + 30 N*m*sin(phi)\"\n");
    CHECK(near(r("delta"), 60.0 / (2000.0 * r("n_m") * r("n_m")), 1e-3));
    CHECK(near(r("A_L"), 120.0 * 3.141592653589793, 1e-9));
    CHECK(r("x_A") < 1e-6);
    CHECK(r("x_t") < 1e-5);
  }

  TEST_CASE("a motor below its load does not start, and one that a peak load stops stalls") {
    const auto stuck = machine(straight + "J_F = \"20 kg*m^2\"\nM = \"121 N*m\"\n");
    CHECK(stuck.worst() == State::fail);
    CHECK(near(stuck("u_A"), 121.0 / 120.0));
    CHECK(std::isnan(stuck("t_E")));
    const auto stalled = machine(straight +
                                 "J_F = \"0.1 kg*m^2\"\npoints = [[\"0 deg\", \"0 N*m\"], [\"180 deg\", \"0 "
                                 "N*m\"], [\"180 deg\", \"200 N*m\"], [\"360 deg\", \"200 N*m\"]]\n");
    CHECK(stalled.worst() == State::fail);
    CHECK(near(stalled("u_S"), 200.0 / 120.0));
    CHECK(std::isnan(stalled("delta")));
  }

  TEST_CASE("a load that equals the torque of the motor at rest does not start") {
    const auto held = machine(straight + "J_F = \"20 kg*m^2\"\nM = \"120 N*m\"\n");
    CHECK(held.worst() == State::fail);
    CHECK(held("u_S") > 1.0);
  }

  TEST_CASE("a formula that is zero at both ends and in the middle of the period repeats") {
    const auto r = machine(straight + "J_F = \"20 kg*m^2\"\nM_of_phi = \"30 N*m*sin(phi)\"\n");
    CHECK(std::abs(r("A_L")) < 1e-9);
    CHECK(r("n_m") > 90.0 * 3.141592653589793 / 30.0);
  }

  TEST_CASE("a load over two revolutions takes the period of both") {
    const auto r = machine(straight +
                           "J_F = \"20 kg*m^2\"\nM_of_phi = \"60 N*m + 30 N*m*sin(phi/2)\"\nperiod = "
                           "\"720 deg\"\n");
    CHECK(near(r("A_L"), 240.0 * 3.141592653589793, 1e-9));
  }

  TEST_CASE("an induction motor by its rated values has the breakdown slip of Kloss") {
    const std::string lines = "M = \"10 N*m\"\nJ_F = \"1 kg*m^2\"\nM_K = \"40 N*m\"\nn_0 = \"1500 rpm\"\n";
    // s_n = 0.04, M_K/M_n = 2.5: s_K = 0.04 (2.5 + sqrt(5.25)) = 0.191651514
    const auto rated = machine(lines + "M_n = \"16 N*m\"\nn_n = \"1440 rpm\"\n");
    CHECK(near(rated("M_start"), machine(lines + "s_K = 0.19165151389911679\n")("M_start"), 1e-12));
    CHECK(near(machine(lines + "s_K = 0.19165151389911679\nM_n = \"16 N*m\"\n")("u_M"), 10.0 / 16.0, 1e-6));
  }

  TEST_CASE("slopes of equally spaced samples are those of the curve through five of them") {
    using namespace loadpath::machine;
    std::vector<Sample> samples;
    const double period = 2.0 * 3.141592653589793;
    for (int k = 0; k < 180; ++k) samples.push_back({period * k / 180, std::sin(2.0 * period * k / 180)});
    add_slopes(samples, period);
    for (const Sample& sample : samples) CHECK(std::abs(sample.slope - 2.0 * std::cos(2.0 * sample.phi)) < 2e-6);
    double area = 0.0, fall = 0.0;
    for (const PeriodCell& cell : period_cells(samples, samples, 3.0, period, 1.0))
      area += cell.width * cell.J.integral(), fall += cell.M.v_1 - cell.M.v_0;
    CHECK(near(area, 3.0 * period, 1e-9));
    CHECK(std::abs(fall) < 1e-12);
  }

  TEST_CASE("inputs that contradict each other are refused with the reason") {
    check_refusals(
        "machine.motion",
        {{"M_A = \"1 N*m\"\nn_0 = \"9 rpm\"\nJ_F = \"1 kg*m^2\"\n", "give the load once"},
         {"M_A = \"1 N*m\"\nn_0 = \"9 rpm\"\nM = \"1 N*m\"\n", "moment of inertia of the flywheel"},
         {"M_A = \"1 N*m\"\nJ_F = \"1 kg*m^2\"\nM = \"1 N*m\"\n", "give the motor once"},
         {"M_K = \"1 N*m\"\nn_0 = \"9 rpm\"\nJ_F = \"1 kg*m^2\"\nM = \"1 N*m\"\n", "breakdown slip"},
         {"motor = [[\"9 rpm\", \"2 N*m\"], [\"12 rpm\", \"1 N*m\"]]\nJ_F = \"1 kg*m^2\"\nM = \"1 N*m\"\n",
          "rising speeds, from 0"},
         {"M_A = \"1 N*m\"\nn_0 = \"9 rpm\"\nJ_F = \"1 kg*m^2\"\nM_of_phi = \"1 N*m*phi/(1 rad)\"\n",
          "does not repeat"},
         {"M_A = \"1 N*m\"\nn_0 = \"9 rpm\"\nJ_F = \"1 kg*m^2\"\nM_of_phi = \"60 N*m + 30 N*m*sin(phi/2)\"\n",
          "it is 71.48 N·m at 45°, and 48.52 N·m a period later"},
         {"M_A = \"1 N*m\"\nn_0 = \"9 rpm\"\nJ_F = \"1 kg*m^2\"\nM_of_phi = \"60 N*m + 30 N*m*cos(720*phi)\"\n",
          "too fast to be followed"}});
  }
}
