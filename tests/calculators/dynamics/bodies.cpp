// Momentum, centre of mass, angular momentum, work and lifts.
#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;
using loadpath::account::State;

TEST_SUITE("dynamics momentum") {
  TEST_CASE("an elastic impact conserves the energy, a plastic one has a common velocity") {
    const std::string bodies =
        "bodies = [{ name = \"a\", m = \"2 kg\", v_1 = \"3 m/s\" }, "
        "{ name = \"b\", m = \"5 kg\", v_1 = \"-1 m/s\" }]\n";
    CHECK(std::abs(SolvedStep("dynamics.momentum", bodies + "e = 1\n")("Delta_E")) < 1e-12);
    const SolvedStep plastic("dynamics.momentum", bodies + "e = 0\n"), together("dynamics.momentum", bodies);
    CHECK(near(plastic("after.a.v_2"), together("V_k")));
    CHECK(near(plastic("Delta_E"), together("Delta_E")));
    CHECK(near(SolvedStep("dynamics.momentum", bodies + "e = 0.3\n")("Delta_E"), plastic("Delta_E") * 0.91));
  }

  TEST_CASE("the impulses on the bodies add up to that from outside") {
    const SolvedStep s("dynamics.momentum",
                       "S = \"-4 N*s\"\nbodies = [{ name = \"a\", m = \"2 kg\", v_1 = \"3 m/s\" }, "
                       "{ name = \"b\", m = \"5 kg\", v_2 = \"1 m/s\" }, { name = \"c\", m = \"1 kg\" }]\n");
    CHECK(near(s("after.a.I") + s("after.b.I") + s("after.c.I"), -4.0));
  }

  TEST_CASE("no unknown, or no impact, is refused") {
    const Refused rows[] = {
        {"bodies = [{ m = \"2 kg\", v_2 = \"1 m/s\" }]\n", "omit v_2 of one body, which is calculated"},
        {"e = 0.5\nbodies = [{ m = \"2 kg\" }]\n", "impact of two bodies"},
        {"e = 0.5\nbodies = [{ m = \"2 kg\" }, { m = \"2 kg\" }]\n", "do not collide"},
        {"e = 1.5\nbodies = [{ m = \"2 kg\", v_1 = \"1 m/s\" }, { m = \"2 kg\" }]\n", "must be"},
        {"bodies = [{ m = \"-2 kg\" }]\n", "must be"}};
    check_refusals("dynamics.momentum", rows);
  }
}

TEST_SUITE("dynamics mass centre") {
  TEST_CASE("the centre of mass stays in place: displacements balance by mass") {
    const SolvedStep s("dynamics.mass_centre",
                       "bodies = [{ name = \"crane\", m = \"900 kg\" }, { name = \"a\", m = \"80 kg\", s = \"3 m\" }, "
                       "{ name = \"b\", m = \"20 kg\", s = \"-5 m\" }]\n");
    CHECK(std::abs(900 * s("after.crane.Delta_x") + 80 * s("after.a.Delta_x") + 20 * s("after.b.Delta_x")) < 1e-9);
    CHECK(near(s("Delta_x"), -0.14));
  }
  TEST_CASE("a very heavy carrier stays where it is") {
    CHECK(std::abs(SolvedStep("dynamics.mass_centre",
                              "bodies = [{ m = \"1e6 kg\" }, { m = \"1 kg\", s = \"1 m\" }]\n")("Delta_x")) < 1.1e-6);
  }
  TEST_CASE("bodies without a carrier are refused") {
    const Refused rows[] = {{"bodies = [{ m = \"1 kg\", s = \"1 m\" }]\n", "carrier"}, {"bodies = []\n", "is empty"}};
    check_refusals("dynamics.mass_centre", rows);
  }
}

TEST_SUITE("dynamics angular momentum") {
  TEST_CASE("a wheel coupled to one at rest and twice as heavy turns at a third: 810 rpm become 270") {
    const SolvedStep s("dynamics.angular_momentum",
                       "parts = [{ J_1 = \"1 kg*m^2\", omega_1 = \"810 rpm\" }, { J_1 = \"2 kg*m^2\" }]\n");
    CHECK(near(s("n_2"), 270.0 * 2.0 * 3.141592653589793 / 60.0));
    CHECK(near(s("E_2"), s("E_1") / 3.0));
  }
  TEST_CASE("the skater who draws in her arms supplies the energy: three times as much at a third of the inertia") {
    const SolvedStep s("dynamics.angular_momentum",
                       "parts = [{ J_1 = \"6 kg*m^2\", J_2 = \"2 kg*m^2\", omega_1 = \"2 rps\" }]\n");
    CHECK(near(s("E_2"), 3.0 * s("E_1")));
  }
  TEST_CASE("a moment for a time and the time of a moment are inverse to each other") {
    const std::string part = "J_1 = \"0.8 kg*m^2\", omega_1 = \"60 rad/s\"";
    const SolvedStep a("dynamics.angular_momentum", "M = \"-5 N*m\"\nt = \"4 s\"\nparts = [{ " + part + " }]\n");
    CHECK(near(a("omega_2"), 35.0));
    const SolvedStep b("dynamics.angular_momentum",
                       "M = \"-5 N*m\"\nparts = [{ " + part + ", omega_2 = \"35 rad/s\" }]\n");
    CHECK(near(b("t_M"), 4.0));
  }
  TEST_CASE("moments without a time, or of the wrong sign, are refused") {
    const Refused rows[] = {
        {"parts = [{ omega_1 = \"1 rad/s\" }]\n", "give one of the two"},
        {"parts = [{ J_1 = \"1 kg*m^2\", m = \"1 kg\", R_1 = \"1 m\" }]\n", "give one of the two"},
        {"M = \"1 N*m\"\nparts = [{ J_1 = \"1 kg*m^2\" }]\n", "give t"},
        {"M = \"1 N*m\"\nt = \"1 s\"\nparts = [{ J_1 = \"1 kg*m^2\", omega_2 = \"1 rad/s\" }]\n", "omit t"},
        {"M = \"1 N*m\"\nparts = [{ J_1 = \"1 kg*m^2\", omega_1 = \"2 rad/s\", omega_2 = \"1 rad/s\" }]\n",
         "change its sign"}};
    check_refusals("dynamics.angular_momentum", rows);
  }
}

TEST_SUITE("dynamics work") {
  TEST_CASE("the speed at the end does not depend on the mass of a body that slides") {
    const std::string way = "s = \"2 m\"\nalpha = \"-30 deg\"\nmu = 0.1\nm = ";
    CHECK(near(SolvedStep("dynamics.work", way + "\"1 kg\"\n")("v_2"),
               SolvedStep("dynamics.work", way + "\"70 kg\"\n")("v_2")));
  }
  TEST_CASE("a body that does not get to the end fails the check and has no speed there") {
    const std::string up = "m = \"1 kg\"\nalpha = \"30 deg\"\nv_1 = \"4 m/s\"\ns = ";
    const SolvedStep there("dynamics.work", up + "\"1.6 m\"\n"), beyond("dynamics.work", up + "\"1.7 m\"\n");
    CHECK(near(there("s_stop"), 16.0 / 9.81));
    CHECK(there.worst() == State::pass);
    CHECK(beyond.worst() == State::fail);
    CHECK(std::isnan(beyond("v_2")));
  }
  TEST_CASE("a body at rest that nothing drives does not move") {
    CHECK(SolvedStep("dynamics.work", "m = \"1 kg\"\ns = \"1 m\"\nmu = 0.2\n").worst() != State::pass);
  }
  TEST_CASE("a spring that is released and stretched again does no work") {
    CHECK(SolvedStep("dynamics.work",
                     "m = \"1 kg\"\ns = \"1 m\"\nc = \"2 N/mm\"\nz_1 = \"-30 mm\"\nz_2 = \"30 mm\"\nv_1 = \"1 m/s\"\n")(
              "A_c") == 0.0);
  }
  TEST_CASE("half a spring is refused") {
    const Refused rows[] = {{"m = \"1 kg\"\ns = \"1 m\"\nc = \"2 N/mm\"\n", "all three or none"},
                            {"m = \"1 kg\"\ns = \"1 m\"\nz_1 = \"2 mm\"\n", "needs the stiffness"},
                            {"m = \"1 kg\"\ns = \"0 m\"\n", "must be"},
                            {"m = \"1 kg\"\ns = \"1 m\"\nalpha = \"95 deg\"\n", "must be"},
                            {"m = \"1 kg\"\ns = \"1 m\"\nmu = -0.1\n", "must be"}};
    check_refusals("dynamics.work", rows);
  }
}

TEST_SUITE("dynamics lift") {
  TEST_CASE("a lift that friction holds stays at rest, and one that is pulled backwards is reported") {
    const std::string drum =
        "s = \"1 m\"\nweights = [{ m = \"10 kg\" }, { m = \"9 kg\", i = -1 }]\nwheels = [{ J = \"0.1 kg*m^2\", r = "
        "\"0.1 m\", M_f = ";
    CHECK(SolvedStep("dynamics.lift", drum + "\"0.99 N*m\" }]\n").word("moves") == "stands");
    CHECK(SolvedStep("dynamics.lift", drum + "\"0.97 N*m\" }]\n").word("moves") == "forwards");
    const SolvedStep back("dynamics.lift", drum + "\"0 N*m\", M_d = \"-5 N*m\" }]\n");
    CHECK(back.word("moves") == "backwards");
    CHECK(back("a") < 0.0);
  }
  TEST_CASE("the energies of the parts add up to the work") {
    const SolvedStep s(
        "dynamics.lift",
        "s = \"1.2 m\"\nweights = [{ name = \"a\", m = \"8 kg\" }, { name = \"b\", m = \"3 kg\", i = -0.5 }]\n"
        "wheels = [{ name = \"w\", J = \"0.2 kg*m^2\", r = \"150 mm\", i = 2, M_f = \"0.9 N*m\" }]\n");
    CHECK(near(s("weight_states.a.E") + s("weight_states.b.E") + s("wheel_states.w.E"), s("A"), 1e-12));
  }
  TEST_CASE("a moving lift that is braked stops, and the path to standstill is reported") {
    const std::string brake =
        "v_0 = \"2 m/s\"\nweights = [{ m = \"100 kg\" }]\nwheels = [{ J = \"2 kg*m^2\", r = \"0.2 m\", M_f = \"300 "
        "N*m\" }]\ns = ";
    const double stop = SolvedStep("dynamics.lift", brake + "\"0.1 m\"\n")("s_stop");
    CHECK(near(stop, 0.5 * 150.0 * 4.0 / (1500.0 - 981.0)));
    CHECK(SolvedStep("dynamics.lift", brake + "\"0.57 m\"\n").worst() == State::pass);
    CHECK(SolvedStep("dynamics.lift", brake + "\"0.58 m\"\n").worst() == State::fail);
  }
  TEST_CASE("a weight on a rough level track: its thread pulls forwards") {
    const SolvedStep s("dynamics.lift",
                       "s = \"1 m\"\nweights = [{ name = \"hangs\", m = \"2 kg\" }, { name = \"slides\", m = \"4 kg\", "
                       "alpha = \"0 deg\", mu = 0.2 }]\n");
    const double a = (2.0 - 0.8) * 9.81 / 6.0;
    CHECK(near(s("a"), a));
    CHECK(near(s("weight_states.hangs.T"), 2.0 * (9.81 - a)));
    CHECK(near(-s("weight_states.slides.T"), s("weight_states.hangs.T")));
  }
  TEST_CASE("a system in which nothing moves is refused") {
    const Refused rows[] = {{"s = \"1 m\"\n", "give at least one weight or wheel"},
                            {"s = \"1 m\"\nweights = [{ m = \"1 kg\", i = 0 }]\n",
                             "at least one part with a mass must move with the path s"},
                            {"s = \"1 m\"\nwheels = [{ J = \"1 kg*m^2\", r = \"0 mm\" }]\n", "must be"}};
    check_refusals("dynamics.lift", rows);
  }
}
