#include "calculators/machine/energy_of_turning.hpp"
#include "tests/calculators/motion/solved.hpp"

#include <algorithm>
#include <array>

using namespace loadpath::test;
using loadpath::account::State;

namespace {

SolvedStep wheel(const std::string& lines) { return {"machine.flywheel", lines}; }

const std::string three_cranks =
    "M_of_phi = \"5000 N*m + 1500 N*m*sin(3*phi)\"\nrole = \"drive\"\nomega = \"300 rpm\"\n";

}  // namespace

TEST_SUITE("machine flywheel") {
  TEST_CASE("the inertia is inversely proportional to the unevenness and to the square of the speed") {
    const double J = wheel(three_cranks + "delta = 0.01\n")("J_F");
    CHECK(near(wheel(three_cranks + "delta = 0.02\n")("J_F"), J / 2.0));
    CHECK(near(wheel("M_of_phi = \"5000 N*m + 1500 N*m*sin(3*phi)\"\nomega = \"600 rpm\"\ndelta = 0.01\n")("J_F"),
               J / 4.0));
  }

  TEST_CASE("integrating the motion with that flywheel gives the required unevenness") {
    const auto r = wheel(three_cranks + "delta = 0.05\n");
    const double J = r("J_F"), omega = 300.0 * 2.0 * 3.141592653589793 / 60.0, M_m = r("M_m");
    // J d(omega)/dt = M - M_m, small steps of time over two turns, from the mean speed where the wave starts
    double w = omega * (1.0 - 0.025), phi = 0.0, low = 1e9, high = 0.0;
    const double dt = 1e-6;
    while (phi < 4.0 * 3.141592653589793) {
      const double middle = w + 0.5 * dt * 1500.0 * std::sin(3.0 * phi) / J;
      w += dt * (5000.0 + 1500.0 * std::sin(3.0 * (phi + 0.5 * dt * w)) - M_m) / J;
      phi += dt * middle;
      low = std::min(low, w), high = std::max(high, w);
    }
    CHECK(near((high - low) / (0.5 * (high + low)), 0.05, 1e-3));
  }

  TEST_CASE("the drawn energy is the area between the moment and its mean") {
    using loadpath::machine::Sample;
    const std::array<Sample, 4> saw{{{1.0, 2.0}, {2.0, 6.0}, {4.0, 2.0}, {5.0, 0.0}}};
    const double mean = 3.0, areas[] = {0.0, 4.0 - 3.0, 12.0 - 9.0, 13.0 - 12.0};
    for (std::size_t i = 0; i < saw.size(); ++i) CHECK(near(loadpath::machine::energy_at(saw, mean, i), areas[i]));
  }

  TEST_CASE("the same moment as load and as drive needs the same flywheel, fast and slow change places") {
    const std::string of =
        "points = [[\"0 deg\", \"10 N*m\"], [\"90 deg\", \"80 N*m\"], [\"180 deg\", \"10 N*m\"]]\nomega = \"10 "
        "rad/s\"\ndelta = 0.05\n";
    const auto load = wheel(of), drive = wheel(of + "role = \"drive\"\n");
    CHECK(near(load("J_F"), drive("J_F")));
    CHECK(near(load("phi_fast"), drive("phi_slow")));
    CHECK(load.word("work") == "absorbed");
    CHECK(drive.word("work") == "delivered");
  }

  TEST_CASE("a constant moment needs no flywheel, and one without a mean no motor") {
    CHECK(wheel("M_of_phi = \"70 N*m\"\nomega = \"10 rad/s\"\ndelta = 0.05\n")("J_F") < 1e-12);
    const auto idle = wheel("M_of_phi = \"70 N*m*sin(phi)\"\nomega = \"10 rad/s\"\ndelta = 0.05\n");
    CHECK(idle.word("work") == "none");
    CHECK(std::isnan(idle("P_m")));
    CHECK(near(idle("Delta_E"), 140.0, 1e-5));
    CHECK(idle.worst() == State::pass);
    CHECK(wheel("M_of_phi = \"70 N*m*sin(phi)\"\nomega = \"10 rad/s\"\ndelta = 0.05\nP_n = \"1 kW\"\n").worst() !=
          State::pass);
  }

  TEST_CASE("inertia at a constant ratio is subtracted once, and no more than there is") {
    const double J = wheel(three_cranks + "delta = 0.01\n")("J_F");
    CHECK(near(wheel(three_cranks + "delta = 0.01\nJ_0 = \"40 kg*m^2\"\n")("J_add"), J - 40.0));
    CHECK(wheel(three_cranks + "delta = 0.01\nJ_0 = \"400 kg*m^2\"\n")("J_add") == 0.0);
  }

  TEST_CASE("a given flywheel passes on one side of its limit and fails on the other") {
    const double J = wheel(three_cranks + "delta = 0.01\n")("J_F");
    CHECK(wheel(three_cranks + "delta = 0.01\nJ = \"" + std::to_string(J * 1.001) + " kg*m^2\"\n").worst() ==
          State::pass);
    CHECK(wheel(three_cranks + "delta = 0.01\nJ = \"" + std::to_string(J * 0.999) + " kg*m^2\"\n").worst() ==
          State::fail);
  }

  TEST_CASE("one efficiency and one rated power, each applied once") {
    const auto r = wheel("M_of_phi = \"70 N*m\"\nomega = \"10 rad/s\"\ndelta = 0.05\neta = 0.8\nP_n = \"1 kW\"\n");
    CHECK(near(r("P"), 875.0));
    CHECK(near(r("u_P"), 0.875));
  }

  TEST_CASE("a single value is refused as a moment over a cycle, with the reason") {
    const std::string rest = "omega = \"10 rad/s\"\ndelta = 0.05\n";
    const std::string rows[][2] = {
        {rest, "give the torque over the cycle once"},
        {rest + "M = \"5 N*m\"\n", "a single value is not a moment over a cycle"},
        {rest + "M_of_phi = \"5 N*m\"\npoints = [[\"0 deg\", \"1 N*m\"], [\"9 deg\", \"2 N*m\"]]\n",
         "give the torque over the cycle once"},
        {rest + "M_of_phi = \"5 N*t\"\n", "t"},
        {rest + "M_of_phi = \"5 N\"\n", "moment"},
        {rest + "M_of_phi = \"5 N*m/sin(phi)\"\n", "no value"},
        {rest + "M_of_phi = \"5 N*m*tan(phi)\"\n", "no value at phi = 90°"},
        {rest + "M_of_phi = \"5 N*m*tan(phi + 0.1 deg)\"\n", "jumps"},
        {rest + "M_of_phi = \"10 N*m + 5 N*m*sin(1440*phi)\"\n", "too fast to be followed"},
        {rest + "points = [[\"9 deg\", \"1 N*m\"], [\"0 deg\", \"2 N*m\"]]\n", "none below the one before"},
        {rest + "points = [[\"0 deg\", \"1 N*m\"], [\"400 deg\", \"2 N*m\"]]\n", "within one period"},
        {rest + "M = \"=line.M_max\"\n[line]\ncalculator = \"shaft.torsion\"\nT = \"9 N*m\"\ntau_adm = \"30 MPa\"\n",
         "a single value is not a moment over a cycle"},
        {"omega = \"10 rad/s\"\nM_of_phi = \"5 N*m\"\n", "give the permissible speed fluctuation"},
        {rest + "M_of_phi = \"5 N*m\"\nv_adm = \"35 m/s\"\n", "diameter"}};
    for (const auto& row : rows) {
      CAPTURE(row[0]);
      const std::string fault = wheel(row[0]).fault();
      CAPTURE(fault);
      CHECK(contains(fault, row[1]));
    }
  }
}
