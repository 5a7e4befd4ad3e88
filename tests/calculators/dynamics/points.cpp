// Force of a motion, throw and impulse.
#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;

TEST_SUITE("dynamics force") {
  TEST_CASE("on the ellipse the force points to the centre: P = -m pi^2 r") {
    for (const std::string t : {"0 s", "0.1 s", "0.6 s", "1.3 s"}) {
      const SolvedStep s("dynamics.force",
                         "m = \"2 kg\"\nx = \"3 m*sin(pi*t/(1 s))\"\ny = \"5 m*cos(pi*t/(1 s))\"\nt = \"" + t + "\"\n");
      const double time = std::stod(t), k = -2.0 * 9.869604401089358;
      CHECK(std::abs(s("P_x") - k * 3.0 * std::sin(3.141592653589793 * time)) < 1e-9);
      CHECK(std::abs(s("P_y") - k * 5.0 * std::cos(3.141592653589793 * time)) < 1e-9);
      CHECK(s("Phi_x") == -s("P_x"));
    }
  }

  TEST_CASE("a point at rest or in uniform motion needs the opposite of the known forces") {
    const SolvedStep s("dynamics.force", "m = \"7 kg\"\nx = \"3 m/s*t\"\nt = \"1 s\"\nF_z = \"-68.67 N\"\n");
    CHECK(s("P") == 0.0);
    CHECK(near(s("R"), 68.67));
  }

  TEST_CASE("a mass without a size, or an expression that is not a law, is refused") {
    const Refused rows[] = {
        {"m = \"0 kg\"\nx = \"1 m\"\nt = \"0 s\"\n", "must be"},
        {"m = \"1 kg\"\nx = \"1 kg\"\nt = \"0 s\"\n", "length"},
        {"m = \"1 kg\"\nx = \"1 m\"\nt = \"0 s\"\nt_1 = \"0 s\"\n", "give both t_1 and t_2, or neither"}};
    check_refusals("dynamics.force", rows);
  }
}

TEST_SUITE("dynamics throw") {
  TEST_CASE("energy is conserved over the flight") {
    for (const double h : {-3.0, 0.0, 25.0}) {
      const SolvedStep s("dynamics.throw",
                         "V_0 = \"15 m/s\"\ntheta = \"60 deg\"\nh = \"" + std::to_string(h) + " m\"\n");
      CHECK(near(s("V_L") * s("V_L"), 225.0 + 2.0 * 9.81 * h, 1e-12));
    }
  }

  TEST_CASE("no angle reaches farther than the angle of greatest range") {
    const std::string throw_from = "V_0 = \"15 m/s\"\nh = \"10 m\"\ntheta = ";
    const double most = SolvedStep("dynamics.throw", throw_from + "\"40 deg\"\n")("L_max");
    for (int theta = -80; theta <= 85; theta += 5) {
      CHECK(SolvedStep("dynamics.throw", throw_from + "\"" + std::to_string(theta) + " deg\"\n")("L") <=
            most * 1.0000001);
    }
  }

  TEST_CASE("the angles that are given for a distance reach that distance") {
    const SolvedStep aim("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"45 deg\"\nh = \"2 m\"\nL_req = \"30 m\"\n");
    for (const std::string of : {"theta_flat", "theta_steep"}) {
      const SolvedStep s("dynamics.throw",
                         "V_0 = \"20 m/s\"\nh = \"2 m\"\ntheta = \"" + std::to_string(aim(of)) + " rad\"\n");
      CHECK(near(s("L"), 30.0, 1e-5));
    }
  }

  TEST_CASE("out of range is a check that fails, on both sides of its limit") {
    CHECK(SolvedStep("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"45 deg\"\nL_req = \"40 m\"\n").worst() ==
          loadpath::account::State::pass);
    CHECK(SolvedStep("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"45 deg\"\nL_req = \"41 m\"\n").worst() ==
          loadpath::account::State::fail);
    CHECK(SolvedStep("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"45 deg\"\nh = \"-10 m\"\n").worst() ==
          loadpath::account::State::pass);
    CHECK(SolvedStep("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"45 deg\"\nh = \"-11 m\"\n").worst() ==
          loadpath::account::State::fail);
  }

  TEST_CASE("the weight by latitude and altitude") {
    const std::string level = "V_0 = \"20 m/s\"\ntheta = \"30 deg\"\n";
    const auto g_at = [&](const std::string& place) { return SolvedStep("dynamics.throw", level + place)("g"); };
    CHECK(near(g_at("latitude = \"0 deg\"\n"), 9.7803253359));
    CHECK(near(g_at("latitude = \"-90 deg\"\n"), 9.8321849378, 1e-11));      // [WGS84]
    CHECK(std::abs(g_at("latitude = \"45 deg\"\n") - 9.8061992026) < 2e-6);  // [CFR-1065], constants of 1980
    CHECK(g_at("latitude = \"45 deg\"\naltitude = \"0 m\"\n") == g_at("latitude = \"45 deg\"\n"));
    // the free-air gradient of the field, 0.3086 mGal/m
    const double gradient = (g_at("latitude = \"45 deg\"\n") - g_at("latitude = \"45 deg\"\naltitude = \"1 km\"\n"));
    CHECK(std::abs(gradient / 1000 - 3.086e-6) < 1.5e-9);
    // 100 km above the pole: GM/r^2 less the oblateness, 3 J_2 (a/r)^2 + 5 J_4 (a/r)^4
    CHECK(near(g_at("latitude = \"90 deg\"\naltitude = \"100 km\"\n"), 9.53094266, 2e-5));
    CHECK(g_at("") == 9.81);
    CHECK(g_at("g = \"9.8 m/s^2\"\n") == 9.8);
    const SolvedStep here("dynamics.throw", level + "latitude = \"60 deg\"\n");
    CHECK(near(here("L"), 400 * std::sin(3.141592653589793 / 3) / here("g")));
    const SolvedStep slide("dynamics.work", "m = \"2 kg\"\ns = \"3 m\"\nalpha = \"-90 deg\"\nlatitude = \"60 deg\"\n");
    CHECK(near(slide("A_G"), 6 * here("g")));
    const SolvedStep lift("dynamics.lift", "s = \"3 m\"\nlatitude = \"60 deg\"\nweights = [{ m = \"2 kg\" }]\n");
    CHECK(near(lift("a"), here("g")));
  }

  TEST_CASE("a weight that is given twice, or an altitude without a latitude, is refused") {
    const std::string level = "V_0 = \"20 m/s\"\ntheta = \"30 deg\"\n";
    const std::string twice = level + "g = \"9.81 m/s^2\"\nlatitude = \"45 deg\"\n";
    const std::string nowhere = level + "altitude = \"500 m\"\n", beyond = level + "latitude = \"91 deg\"\n";
    const Refused rows[] = {
        {twice.c_str(), "give one of them"}, {nowhere.c_str(), "needs the latitude"}, {beyond.c_str(), "must be"}};
    check_refusals("dynamics.throw", rows);
  }

  TEST_CASE("an impossible throw is refused") {
    const Refused rows[] = {{"V_0 = \"0 m/s\"\ntheta = \"45 deg\"\n", "must be"},
                            {"V_0 = \"9 m/s\"\ntheta = \"91 deg\"\n", "must be"},
                            {"V_0 = \"9 m/s\"\ntheta = \"45\"\n", "unit"},
                            {"V_0 = \"9 m/s\"\ntheta = \"-5 deg\"\nh = \"-1 m\"\n",
                             "with theta <= 0 the body cannot land higher: increase theta, or give h >= 0"}};
    check_refusals("dynamics.throw", rows);
  }
}

TEST_SUITE("dynamics impulse") {
  TEST_CASE("twice the duration of a force gives twice the impulse") {
    const SolvedStep a("dynamics.impulse", "m = \"2 kg\"\nF_x = \"30 N\"\nt_2 = \"1 s\"\n");
    const SolvedStep b("dynamics.impulse", "m = \"2 kg\"\nF_x = \"30 N\"\nt_2 = \"2 s\"\n");
    CHECK(near(a("I"), 30.0));
    CHECK(near(b("I"), 60.0));
    CHECK(near(b("F_m"), a("F_m")));
  }

  TEST_CASE("the work is the change of the kinetic energy") {
    const SolvedStep s(
        "dynamics.impulse",
        "m = \"2 kg\"\nF_x = \"30 N\"\nF_y = \"-10 N\"\nt_2 = \"1 s\"\nv_1x = \"1 m/s\"\nv_1y = \"2 m/s\"\n");
    // constant force: the path is the mean velocity times the time
    CHECK(near(s("A"), 30.0 * (1.0 + s("v_2x")) / 2.0 - 10.0 * (2.0 + s("v_2y")) / 2.0));
  }

  TEST_CASE("along three axes: momentum, mean force and work, the axes being equal") {
    const std::string more = "m = \"12 kg\"\nt_2 = \"4 s\"\n";
    const SolvedStep s("dynamics.impulse", more +
                                               "F_x = \"21 N\"\nF_y = \"-11 N\"\nF_z = \"44 N\"\nv_1x = \"100 m/s\"\n"
                                               "v_1y = \"84.66666667 m/s\"\nv_1z = \"89.33333333 m/s\"\n");
    CHECK(near(s("v_2x"), 107.0));  // [YaGuru-3759452]
    CHECK(near(s("v_2z"), 104.0));
    CHECK(near(s("I"), 4.0 * std::sqrt(21.0 * 21 + 11 * 11 + 44 * 44)));
    CHECK(near(s("F_m"), s("I") / 4.0));
    CHECK(near(s("v_2"), std::sqrt(107.0 * 107 + 81.0 * 81 + 104.0 * 104)));
    const double mean = 0.5 * (89.33333333 + 104.0);  // of a constant force
    CHECK(near(s("A"), 4.0 * (21 * 103.5 - 11 * 0.5 * (84.66666667 + 81.0) + 44 * mean)));
    const std::string law = "\"6 N*t/(1 s)\"\n";
    const SolvedStep x("dynamics.impulse", more + "F_x = " + law + "v_1x = \"2 m/s\"\n");
    const SolvedStep z("dynamics.impulse", more + "F_x = \"0 N\"\nF_z = " + law + "v_1z = \"2 m/s\"\n");
    for (const char* const result : {"I", "F_m", "v_2", "A"}) CHECK(x(result) == z(result));
    CHECK(x("q_2x") == z("q_2z"));
    CHECK(z("v_2x") == 0.0);
  }

  TEST_CASE("an expression that is not a force over a time is refused") {
    const Refused rows[] = {{"m = \"2 kg\"\nF_x = \"30 N\"\nF_z = \"1 N*tan(t/(1 s))\"\nt_2 = \"2 s\"\n", "F_z"},
                            {"m = \"2 kg\"\nF_x = \"30 kg\"\nt_2 = \"1 s\"\n", "force"},
                            {"m = \"2 kg\"\nF_x = \"30 N\"\nt_1 = \"1 s\"\nt_2 = \"1 s\"\n", "end after its start"},
                            {"m = \"2 kg\"\nF_x = \"30 N/(t/(1 s))\"\nt_2 = \"1 s\"\n", "no value"},
                            {"m = \"2 kg\"\nF_x = \"1 N*tan(t/(1 s))\"\nt_2 = \"2 s\"\n", "jumps"},
                            {"m = \"2 kg\"\nF_x = \"1e300 N\"\nt_2 = \"1 s\"\n", "no value"}};
    check_refusals("dynamics.impulse", rows);
  }
}
