// Motion under given forces against closed forms: resistance of the air, springs, central forces.
#include "calculators/dynamics/motion.hpp"

#include "tests/calculators/motion/solved.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <numbers>
#include <random>

using namespace loadpath::test;

namespace {

SolvedStep motion(const std::string& lines) { return {"dynamics.motion", lines}; }
std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

}  // namespace

TEST_SUITE("dynamics motion" * by_case) {
  TEST_CASE("a fall against quadratic resistance: tanh and ln cosh") {
    for (const double k : {0.002, 0.02, 0.5}) {
      CAPTURE(k);
      const SolvedStep s = motion("m = \"1 kg\"\nF_x = \"9.81 N - " + text(k) + " N*s^2/m^2*v_x*v\"\nt_2 = \"3 s\"\n");
      const double limit = std::sqrt(9.81 / k), x = limit * limit / 9.81 * std::log(std::cosh(9.81 * 3.0 / limit));
      CHECK(near(s("v_E"), limit * std::tanh(9.81 * 3.0 / limit)));
      CHECK(near(s("x_E"), x));
      CHECK(near(s("L"), x));
      CHECK(near(s("A"), s("E_2") - s("E_1"), 1e-8));
      CHECK(s.word("end") == "time");
      CHECK(s("delta") < 1e-8);
    }
  }

  TEST_CASE("a projectile with linear resistance lands where the closed form has its zero") {
    const double k = 0.3, g = 9.81, v_x = 20.0, v_y = 15.0;  // of 1 kg
    const SolvedStep s = motion(
        "m = \"1 kg\"\nv_x0 = \"20 m/s\"\nv_y0 = \"15 m/s\"\nF_x = \"-0.3 N*s/m*v_x\"\nF_y = \"-9.81 N - 0.3 "
        "N*s/m*v_y\"\nuntil = \"y\"\nt_2 = \"20 s\"\n");
    const double t = s("t_E"), fades = 1.0 - std::exp(-k * t);
    CHECK(s.word("end") == "until");
    CHECK(std::abs((v_y + g / k) / k * fades - g * t / k) < 1e-9);
    CHECK(near(s("x_E"), v_x / k * fades));
    CHECK(near(s("y_max"), (v_y - g / k * std::log(1.0 + k * v_y / g)) / k));
    CHECK(s("y_E") == 0.0);
  }

  TEST_CASE("without resistance it is the projectile") {
    const SolvedStep air = motion(
        "m = \"7 kg\"\nv_x0 = \"17.320508075688775 m/s\"\nv_y0 = \"10 m/s\"\nF_x = \"0 N\"\nF_y = \"-68.67 N\"\n"
        "until = \"y\"\nt_2 = \"100 s\"\n");
    const SolvedStep free("dynamics.throw", "V_0 = \"20 m/s\"\ntheta = \"30 deg\"\n");
    CHECK(near(air("t_E"), free("t_L")));
    CHECK(near(air("x_E"), free("L")));
    CHECK(near(air("y_max"), free("H")));
    CHECK(near(air("v_E"), 20.0));
  }

  TEST_CASE("springs oscillate as they must, and friction stops them") {
    const SolvedStep free = motion("m = \"2 kg\"\nx_0 = \"10 mm\"\nF_x = \"-800 N/m*x\"\nt_2 = \"1 s\"\n");
    CHECK(near(free("x_E"), 0.01 * std::cos(20.0), 1e-8));
    CHECK(near(free("v_xE"), -0.2 * std::sin(20.0), 1e-8));
    CHECK(near(free("v_max"), 0.2));
    CHECK(near(free("x_min"), -0.01));
    CHECK(near(free("L"), 0.12 + 0.01 * (1.0 - std::cos(20.0 - 6.0 * std::numbers::pi)), 1e-6));
    // underdamped: c = 8 N*s/m, decay 2/s
    const SolvedStep damped =
        motion("m = \"2 kg\"\nx_0 = \"10 mm\"\nF_x = \"-800 N/m*x - 8 N*s/m*v_x\"\nt_2 = \"2 s\"\n");
    const double w = std::sqrt(400.0 - 4.0);
    CHECK(near(damped("x_E"), 0.01 * std::exp(-4.0) * (std::cos(2.0 * w) + 2.0 / w * std::sin(2.0 * w)), 1e-7));
    const SolvedStep braked =
        motion("m = \"1200 kg\"\nv_x0 = \"90 km/h\"\nF_x = \"-6 kN\"\nuntil = \"v_x\"\nt_2 = \"1 min\"\n");
    CHECK(near(braked("t_E"), 5.0));
    CHECK(near(braked("x_E"), 62.5));
  }

  TEST_CASE("planets: half a turn by Kepler, area and energy are kept") {
    for (const double v : {0.8, 1.0, 1.2, 1.35}) {
      CAPTURE(v);
      const SolvedStep s =
          motion("m = \"1 kg\"\nx_0 = \"1 m\"\nv_y0 = \"" + text(v) +
                 " m/s\"\nF_x = \"-1 N*m^2*x/sqrt(x^2 + y^2)^3\"\nF_y = \"-1 N*m^2*y/sqrt(x^2 + y^2)^3\"\n"
                 "until = \"y\"\nt_2 = \"60 s\"\n");
      const double a = 1.0 / (2.0 - v * v);
      CHECK(near(s("t_E"), std::numbers::pi * std::pow(a, 1.5), 1e-8));
      CHECK(near(s("x_E"), 1.0 - 2.0 * a, 1e-8));
      CHECK(near(-s("x_E") * s("v_E"), v, 1e-8));
    }
  }

  TEST_CASE("forces over time: the impulse, and three axes") {
    const SolvedStep s = motion(
        "m = \"3 kg\"\nv_x0 = \"4 m/s\"\nF_x = \"3 N*(t/(1 s))^2 + 5 N\"\nF_z = \"2 N*sin(2*t/(1 s))\"\nt_2 = \"3 "
        "s\"\n");
    CHECK(near(s("v_xE"), 18.0));
    CHECK(near(s("v_zE"), (1.0 - std::cos(6.0)) / 3.0, 1e-8));
    CHECK(near(s("y_E") + 1.0, 1.0));
  }

  TEST_CASE("kinetic energy grows by the work, whatever the forces") {
    std::mt19937 random(3);
    const auto drawn = [&](double low, double high) {
      return text(low + (high - low) * static_cast<double>(random() % 1000) / 1000.0);
    };
    for (int i = 0; i < (sanitized ? 3 : 30); ++i) {
      CAPTURE(i);
      const SolvedStep s =
          motion("m = \"" + drawn(0.1, 20) + " kg\"\nx_0 = \"" + drawn(-2, 2) + " m\"\nv_y0 = \"" + drawn(-5, 5) +
                 " m/s\"\nF_x = \"-" + drawn(0, 200) + " N/m*x - " + drawn(0, 5) + " N*s/m*v_x\"\nF_y = \"" +
                 drawn(-50, 50) + " N*cos(3*t/(1 s)) - " + drawn(0, 2) + " N*s^2/m^2*v*v_y\"\nt_2 = \"2 s\"\n");
      CHECK(std::abs(s("A") - (s("E_2") - s("E_1"))) < 1e-8 * (s("E_1") + s("E_2") + std::abs(s("A"))));
      CHECK(s("x_min") <= s("x_E"));
      CHECK(s("x_E") <= s("x_max"));
      CHECK(s("v_E") <= s("v_max"));
    }
  }

  TEST_CASE("a force without a value, and an expression that is not a force, are refused with the place") {
    const std::string thrown = "m = \"1 kg\"\nt_2 = \"30 s\"\nx_0 = \"1 m\"\n";
    const std::string pole = thrown + "F_x = \"-1 N*m/x\"\n", root = thrown + "F_x = \"-1 N*sqrt(1 - t/(2 s))\"\n",
                      kind = thrown + "F_x = \"3 m\"\n", name = thrown + "F_x = \"3 N/m*s\"\n",
                      many = thrown + "F_x = \"0 N\"\nF_y = \"2 N*w\"\n";
    const Refused rows[] = {{pole.c_str(), "no value, or a pole, at t = 1.253 s"},
                            {root.c_str(), "no value, or a pole, at t = 2 s"},
                            {kind.c_str(), "force"},
                            {name.c_str(), "F_x"},
                            {many.c_str(), "F_y"}};
    check_refusals("dynamics.motion", rows);
    CHECK(motion(thrown + "F_x = \"1 N\"\nuntil = \"x + 2 m\"\n").word("end") == "time");
  }
}
