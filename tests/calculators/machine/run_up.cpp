#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;
using loadpath::account::State;

namespace {

SolvedStep run(const std::string& lines) { return {"machine.run_up", "parts = [{ J = \"0.5 kg*m^2\" }]\n" + lines}; }

}  // namespace

TEST_SUITE("machine run up") {
  TEST_CASE("a constant moment: t = J omega/M, and half of the revolutions of the end speed in that time") {
    const auto r = run("motor = [[\"0 rpm\", \"10 N*m\"]]\nn_2 = \"100 rad/s\"\n");
    CHECK(near(r("t"), 5.0));
    CHECK(near(r("turns"), 250.0 / (2.0 * 3.141592653589793)));
    CHECK(near(r("A_M"), 2500.0));
  }

  TEST_CASE("time and work agree with small time steps") {
    const auto r =
        run("motor = [[\"0 rad/s\", \"20 N*m\"], [\"60 rad/s\", \"28 N*m\"], [\"100 rad/s\", \"12 N*m\"]]\n"
            "load = [[\"0 rad/s\", \"1 N*m\"], [\"100 rad/s\", \"9 N*m\"]]\nn_2 = \"100 rad/s\"\n");
    double t = 0.0, w = 0.0, motor_work = 0.0, load_work = 0.0;
    const double dt = 2e-6;
    while (w < 100.0) {
      const double M = w < 60.0 ? 20.0 + 8.0 * w / 60.0 : 28.0 - 16.0 * (w - 60.0) / 40.0, L = 1.0 + 8.0 * w / 100.0;
      motor_work += M * w * dt, load_work += L * w * dt;
      w += (M - L) / 0.5 * dt;
      t += dt;
    }
    CHECK(near(r("t"), t, 1e-5));
    CHECK(near(r("A_M"), motor_work, 1e-4));
    CHECK(near(r("A_L"), load_work, 1e-4));
  }

  TEST_CASE("a part at twice the speed counts four times") {
    const SolvedStep r("machine.run_up",
                       "parts = [{ J = \"1 kg*m^2\", u = 2 }]\nmotor = [[\"0 rpm\", \"1 N*m\"]]\nn_2 = \"1 rad/s\"\n");
    CHECK(near(r("J_red"), 4.0));
    CHECK(near(r("t"), 4.0));
  }

  TEST_CASE("a load above the motor torque is never run up: on both sides of the limit") {
    const std::string motor =
        "motor = [[\"0 rpm\", \"10 N*m\"]]\nn_2 = \"100 rad/s\"\nload = [[\"0 rad/s\", \"2 N*m\"], [\"100 rad/s\", ";
    const auto carried = run(motor + "\"9.9 N*m\"]]\n"), stuck = run(motor + "\"10.1 N*m\"]]\n");
    CHECK(carried.worst() == State::pass);
    CHECK(near(carried("u_M"), 0.99));
    CHECK(stuck.worst() == State::fail);
    CHECK(std::isnan(stuck("t")));
    CHECK(run(motor + "\"10 N*m\"]]\n").worst() == State::not_available);  // it nears the speed for ever
  }

  TEST_CASE("a load helps to brake, and the brake takes the rest as heat") {
    const auto r = run(
        "n_1 = \"100 rad/s\"\nn_2 = \"0 rad/s\"\nmotor = [[\"0 rpm\", \"-6 N*m\"]]\nload = [[\"0 rpm\", \"4 N*m\"]]\n");
    CHECK(near(r("t"), 5.0));
    CHECK(near(r("A_M"), -1500.0));
    CHECK(near(r("A_L"), 1000.0, 1e-9));
  }

  TEST_CASE("coasting down against the load alone, and without any load") {
    CHECK(near(run("n_1 = \"100 rad/s\"\nn_2 = \"0 rad/s\"\nmotor = [[\"0 rpm\", \"0 N*m\"]]\nload = [[\"0 rpm\", \"4 "
                   "N*m\"]]\n")("t"),
               12.5));
    CHECK(run("n_1 = \"100 rad/s\"\nn_2 = \"0 rad/s\"\nmotor = [[\"0 rpm\", \"0 N*m\"]]\n").worst() != State::pass);
  }

  TEST_CASE("the allowed time is a check") {
    const std::string motor = "motor = [[\"0 rpm\", \"10 N*m\"]]\nn_2 = \"100 rad/s\"\nt_adm = ";
    CHECK(run(motor + "\"5.01 s\"\n").worst() == State::pass);
    CHECK(run(motor + "\"4.99 s\"\n").worst() == State::fail);
  }

  TEST_CASE("a motor may be overhauled by its load: no contradiction of signs") {
    const auto stopped = run(
        "n_1 = \"100 rad/s\"\nn_2 = \"0 rad/s\"\nmotor = [[\"0 rpm\", \"2 N*m\"]]\nload = [[\"0 rpm\", \"7 N*m\"]]\n");
    CHECK(near(stopped("t"), 10.0));
    const auto lowered =
        run("n_2 = \"100 rad/s\"\nmotor = [[\"0 rpm\", \"-2 N*m\"]]\nload = [[\"0 rpm\", \"-7 N*m\"]]\n");
    CHECK(near(lowered("t"), 10.0));
    CHECK(run("n_1 = \"100 rad/s\"\nn_2 = \"0 rad/s\"\nmotor = [[\"0 rpm\", \"-2 N*m\"]]\nload = [[\"0 rpm\", \"-7 "
              "N*m\"]]\n")
              .worst() == State::fail);
  }

  TEST_CASE("contradictory speeds and motor curves are refused with the reason") {
    const std::string rows[][2] = {
        {"motor = [[\"0 rpm\", \"1 N*m\"]]\nn_2 = \"0 rpm\"\n", "initial and final speed must differ"},
        {"motor = []\nn_2 = \"9 rpm\"\n", "is empty"},
        {"motor = [[\"9 rpm\", \"1 N*m\"], [\"9 rpm\", \"2 N*m\"]]\nn_2 = \"9 rpm\"\n", "must increase"},
        {"motor = [[\"0 rpm\", \"1 N*m\"], [\"9 rpm\", \"2 N*m\"]]\nn_2 = \"10 rpm\"\n", "the line goes from"},
        {"motor = [[\"0 rpm\", \"5 N*m\"]]\nn_1 = \"900 rpm\"\nn_2 = \"100 rpm\"\n",
         "n_2 = 100 rpm is below n_1 = 900 rpm, but the motor torque of 5 N·m at n_1 is positive: it accelerates"},
        {"motor = [[\"0 rpm\", \"-5 N*m\"]]\nn_2 = \"100 rpm\"\n",
         "n_2 = 100 rpm is above n_1 = 0 rpm, but the motor torque of -5 N·m at n_1 is negative: it brakes"},
        {"motor = [[\"0 Hz\", \"1 N*m\"]]\nn_2 = \"10 rpm\"\n", "Hz"}};
    for (const auto& row : rows) {
      CAPTURE(row[0]);
      const std::string fault = run(row[0]).fault();
      CAPTURE(fault);
      CHECK(contains(fault, row[1]));
    }
  }
}
