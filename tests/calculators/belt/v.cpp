#include "calculators/belt/v/v.hpp"

#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::rel;
using test::with;

belt::V::Input wedge() {
  belt::V::Input in;
  in.basis = belt::Basis::optibelt;
  in.section = "SPB";
  in.P = 30e3 * W;
  in.K_A = 1.2;
  in.n_1 = 1460.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = 400.0 * mm, in.L = 2650.0 * mm;
  return in;
}

belt::V::Input classical() {
  belt::V::Input in;
  in.basis = belt::Basis::iso;
  in.section = "B";
  in.belt_class = belt::V::BeltClass::IV;
  in.P = 7.5e3 * W;
  in.K_A = 1.2;
  in.n_1 = 1440.0 * rpm;
  in.d_1 = 140.0 * mm, in.d_2 = 280.0 * mm, in.L = 1800.0 * mm;
  return in;
}

constexpr auto solve = test::evaluated<belt::V>;

/// One belt on two equal pulleys, or with a ratio, far enough apart.
belt::V::Result rated(belt::Basis basis, const char* section, double d, double n, double ratio = 1.0) {
  belt::V::Input in = basis == belt::Basis::iso ? classical() : wedge();
  in.section = section;
  in.n_1 = n * rpm;
  in.d_1 = d * mm, in.d_2 = ratio * d * mm;
  in.L = unset<Length>, in.a = 2.0 * (in.d_1 + in.d_2);
  return solve(in);
}

double kW_of(Power P) { return in_si(P) / 1e3; }

const std::string text = R"(calculator = "belt.v"
basis = "iso"
section = "B"
belt_class = "IV"
P = "7.5 kW"
K_A = 1.2
n_1 = "1440 rpm"
d_1 = "140 mm"
d_2 = "280 mm"
L = "1800 mm"
)";
const std::string maker = R"(calculator = "belt.v"
basis = "optibelt"
section = "SPB"
P = "30 kW"
K_A = 1.2
n_1 = "1460 rpm"
d_1 = "200 mm"
d_2 = "400 mm"
L = "2650 mm"
)";

struct Printed {
  const char* section;
  double d, n, ratio, P;
};

}  // namespace

TEST_SUITE("belt v") {
  TEST_CASE("rated powers are those printed in GOST 1284.3-96, tables 12 to 17") {
    for (const Printed& row : {Printed{"Z", 80, 1450, 1, 0.84},
                               {"Z", 112, 2850, 3, 2.77},
                               {"A", 100, 1450, 1, 2.02},
                               {"A", 125, 2200, 1.2, 4.35},
                               {"A", 160, 3600, 3, 8.41},
                               {"B", 140, 1450, 1, 3.85},
                               {"B", 180, 1450, 1.5, 6.61},
                               {"B", 280, 1600, 3, 12.43},
                               {"C", 200, 800, 1, 5.20},
                               {"C", 315, 950, 1.2, 12.81},
                               {"C", 400, 1450, 3, 21.67},
                               {"D", 355, 550, 1, 10.50},
                               {"D", 630, 500, 1.5, 23.21},
                               {"E", 500, 500, 1, 26.78},
                               {"E", 1000, 500, 3, 63.29},
                               {"E", 500, 1100, 1.05, 38.56}}) {
      CAPTURE(row.section);
      CAPTURE(row.d);
      CAPTURE(row.n);
      CAPTURE(row.ratio);
      CHECK(std::abs(kW_of(rated(belt::Basis::iso, row.section, row.d, row.n, row.ratio).P_N) - row.P) < 0.05);
    }
  }

  TEST_CASE("rated powers are those printed by the manufacturer at 700/min") {
    for (const Printed& row : {Printed{"SPZ", 63, 700, 1, 0.50},
                               {"SPZ", 100, 700, 1, 1.33},
                               {"SPZ", 200, 700, 1, 3.47},
                               {"SPA", 90, 700, 1, 1.17},
                               {"SPA", 160, 700, 1, 3.73},
                               {"SPA", 315, 700, 1, 9.01},
                               {"SPB", 140, 700, 1, 3.46},
                               {"SPB", 200, 700, 1, 6.91},
                               {"SPB", 400, 700, 1, 17.59},
                               {"SPC", 224, 700, 1, 10.46},
                               {"SPC", 450, 700, 1, 32.24},
                               {"SPC", 710, 700, 1, 53.19},
                               {"Z", 71, 700, 1, 0.42},
                               {"A", 100, 700, 1, 1.21},
                               {"B", 180, 700, 1, 3.89},
                               {"C", 250, 700, 1, 8.47},
                               {"D", 500, 700, 1, 32.05},
                               {"E", 800, 700, 1, 55.67}}) {
      CAPTURE(row.section);
      CAPTURE(row.d);
      CHECK(std::abs(kW_of(rated(belt::Basis::optibelt, row.section, row.d, row.n).P_0) - row.P) < 0.013);
    }
  }

  TEST_CASE("a drive of each basis, computed by an independent program from the printed factors") {
    const auto a = solve(wedge());
    CHECK(rel(in_si(a.a), 0.8478570162) < 1e-9);
    CHECK(rel(kW_of(a.P_N), 13.79835070) < 1e-8);
    CHECK(a.c_alpha == doctest::Approx(0.99).epsilon(1e-12));
    CHECK(a.c_L == 0.95);
    CHECK(a.z == 3);
    CHECK(rel(a.u_P, 0.9246880970) < 1e-8);
    CHECK(rel(in_si(a.F_0), 452.7065386) < 1e-8);
    CHECK(rel(in_si(a.f_s), 28.98817581) < 1e-8);
    CHECK(rel(in_si(a.R), 2448.459206) < 1e-8);
    CHECK(rel(in_si(a.Q), 28.26509011) < 1e-8);
    CHECK(in_si(a.B) == doctest::Approx(0.063));
    const auto b = solve(classical());
    CHECK(b.z == 3);
    CHECK(rel(b.c_alpha, 0.9661206525) < 1e-8);
    CHECK(rel(b.u_P, 0.9726354159) < 1e-8);
    CHECK(rel(in_si(b.F_0), 245.6681683) < 1e-8);
    CHECK(rel(in_si(b.R_0), 1462.684579) < 1e-8);
    CHECK(rel(b.theta_R, 4.490133665 * pi / 180) < 1e-8);
    CHECK(rel(in_si(b.Q), 16.60426052) < 1e-8);
    CHECK(rel(in_si(b.Delta_2), 0.0442) < 1e-12);
    CHECK(rel(in_si(b.Delta_1), 0.036) < 1e-12);
  }

  TEST_CASE("both shafts are pulled to each other by the largest pull, that of new belts") {
    const auto a = solve(wedge());
    // From the values of the other program above: 2 z 1.3 F_0 cos(gamma), sin(gamma) = 100 mm/a.
    const double pull = 2 * 3 * 1.3 * 452.7065386 * std::sqrt(1.0 - std::pow(0.1 / 0.8478570162, 2));
    CHECK(pull > 2448.459206);  // in running
    const auto b = solve(classical());
    for (const auto& [load, F] : {std::pair{a.shaft_1, pull},
                                  {a.shaft_2, pull},
                                  {b.shaft_1, 1.3 * 1462.684579},
                                  {b.shaft_2, 1.3 * 1462.684579}}) {
      CHECK(rel(in_si(load.F), F) < 1e-8);
      CHECK(rel(in_si(load.F_x), F) < 1e-8);
      CHECK(in_si(load.F_y) == 0.0);
      CHECK(in_si(load.F_z) == 0.0);
    }
  }

  TEST_CASE("on equal pulleys the friction is Euler's with the wedge friction of half a turn") {
    belt::V::Input in = wedge();
    in.d_2 = in.d_1, in.mu = 0.3;
    const auto r = solve(in);
    const double F_t = in_si(r.S_1 - r.S_2), N_0 = in_si(r.F_0 - r.F_c);
    const double ratio = std::exp(pi * 0.3 / std::sin(0.5 * r.phi_1));
    CHECK(rel(r.u_grip, 0.5 * F_t * (ratio + 1.0) / (ratio - 1.0) / N_0) < 1e-10);
  }

  TEST_CASE("a new belt is tensioned to 1.3 times, and every measure of the tension follows") {
    const auto wedge_belt = solve(wedge()), classical_belt = solve(classical());
    for (const auto& r : {wedge_belt, classical_belt}) {
      CHECK(rel(in_si(r.F_0_new), 1.3 * in_si(r.F_0)) < 1e-12);
      CHECK(rel(in_si(r.R_new), 1.3 * in_si(r.R_0)) < 1e-12);
      CHECK(rel(in_si(r.f_s_new), std::sqrt(1.3) * in_si(r.f_s)) < 1e-12);
      CHECK(rel(in_si(r.y), 0.0155 * in_si(r.a)) < 1e-12);
    }
    CHECK(rel(in_si(wedge_belt.Q_new), 1.3 * in_si(wedge_belt.Q)) < 1e-12);
    // GOST 1284.3-96, (18) and (19): both include the stiffness of the belt
    CHECK(rel(in_si(classical_belt.Q_new - classical_belt.Q), 0.3 * in_si(classical_belt.F_0) / 16.0) < 1e-12);
  }

  TEST_CASE("the arc-of-contact factor of the basis iso is that of its table to two digits") {
    for (const auto& [deg_of_wrap, printed] : {std::pair{180, 1.00},
                                               {170, 0.98},
                                               {160, 0.95},
                                               {150, 0.92},
                                               {140, 0.89},
                                               {130, 0.86},
                                               {120, 0.82},
                                               {110, 0.78},
                                               {100, 0.74},
                                               {90, 0.69}}) {
      belt::V::Input in = classical();
      in.L = unset<Length>;
      in.a = 0.5 * (in.d_2 - in.d_1) / std::sin(0.5 * (pi - deg_of_wrap * pi / 180)) + 1e-12 * mm;
      CHECK(std::abs(solve(in).c_alpha - printed) < 0.0051);
    }
  }

  TEST_CASE("the service factor acts once on the power and once on the tension") {
    belt::V::Input in = classical();
    in.z = 5;
    const auto one = solve(in);
    in.K_A = 1.2 * 1.25;
    const auto r = solve(in);
    CHECK(rel(r.u_P / one.u_P, 1.25) < 1e-12);
    CHECK(rel(in_si((r.F_0 - r.F_c) / (one.F_0 - one.F_c)), 1.25) < 1e-12);
    CHECK(rel(in_si(r.P_N), in_si(one.P_N)) < 1e-15);
    in.K_A_1 = 1.2;
    CHECK(rel(in_si(solve(in).F_0), in_si(one.F_0)) < 1e-12);
  }

  TEST_CASE("the number of belts is the smallest that passes") {
    for (const belt::V::Input& drive : {wedge(), classical()}) {
      belt::V::Input in = drive;
      const auto z = static_cast<int>(solve(in).z);
      CHECK(solve(in).u_P <= 1.0);
      in.z = z - 1;
      CHECK(solve(in).u_P > 1.0);
    }
  }

  TEST_CASE("the count factor belongs to one basis only, and its high end never needs more belts") {
    CHECK(solve(wedge()).C_K == 1.0);
    belt::V::Input in = classical();
    CHECK(solve(in).C_K == 0.77);
    in.C_K_end = belt::V::End::high;
    CHECK(solve(in).z <= solve(classical()).z);
  }

  TEST_CASE("service factors of the manufacturer by load, motor and hours") {
    const std::string by_duty =
        with(with(maker, "K_A", ""), "duty", "\"heavy\"") + "motor = \"high\"\nh_day = \"12 h\"\n";
    CHECK(BeltStep(by_duty).value("K_A") == 1.5);
    CHECK(BeltStep(with(by_duty, "h_day", "\"10 h\"")).value("K_A") == 1.4);
    CHECK(BeltStep(with(by_duty, "h_day", "\"16.1 h\"")).value("K_A") == 1.6);
  }

  TEST_CASE("traction follows Euler's condition with the groove of the actual pulley") {
    belt::V::Input in = classical();
    in.d_1 = in.d_2 = 180.0 * mm;  // groove of 34 degrees
    in.mu = 0.3;
    const auto small = solve(in);
    CHECK(rel(small.phi_1, 34 * pi / 180) < 1e-12);
    const double m_e = std::exp(0.3 / std::sin(17 * pi / 180) * pi);
    CHECK(std::abs(m_e - 25.1) < 0.05);
    const double F_t = in_si(small.S_1 - small.S_2), N_0 = in_si(small.F_0 - small.F_c);
    CHECK(rel(small.u_grip, F_t / 2 * (m_e + 1) / (m_e - 1) / N_0) < 1e-12);
    in.d_1 = in.d_2 = 200.0 * mm;
    CHECK(rel(solve(in).phi_1, 38 * pi / 180) < 1e-12);
  }

  TEST_CASE("a tensioner with constant force needs no centrifugal part at standstill; the frequency is the same") {
    belt::V::Input in = wedge();
    const auto fixed = solve(in);
    in.tensioning = belt::V::Tensioning::constant_force;
    const auto pulled = solve(in);
    CHECK(rel(in_si(fixed.F_0 - pulled.F_0), in_si(fixed.F_c)) < 1e-12);
    CHECK(in_si(pulled.S_1) == in_si(fixed.S_1));
  }

  TEST_CASE("the test force and the frequency agree: both follow from the tension") {
    const auto r = solve(wedge());
    const double m = in_si(r.F_c) / (in_si(r.v) * in_si(r.v));
    CHECK(rel(4 * m * std::pow(in_si(r.l_s) * in_si(r.f_s), 2), in_si(r.F_0)) < 1e-12);
    CHECK(rel(in_si(r.Q) * in_si(r.l_s) / (4 * in_si(r.y)), in_si(r.F_0)) < 1e-12);
    CHECK(rel(in_si(r.F_0_new / r.F_0), 1.3) < 1e-12);
    CHECK(rel(in_si(r.R_new / r.R_0), 1.3) < 1e-12);
  }

  TEST_CASE("a speed-up drive is rated by its smaller, driven pulley") {
    belt::V::Input in = classical();
    std::swap(in.d_1, in.d_2);
    in.n_1 = 720.0 * rpm;
    const auto up = solve(in), down = solve(classical());
    CHECK(rel(in_si(up.P_N), in_si(down.P_N)) < 1e-12);
    CHECK(up.n_2 > in.n_1);
  }

  TEST_CASE("one more belt carries less than its full share") {
    for (int z = 2; z < 9; ++z) {
      belt::V::Input in = classical();
      in.z = z;
      const auto r = solve(in);
      CHECK(r.P_all < static_cast<double>(z) * r.P_N * r.c_alpha * r.c_L);
    }
  }

  TEST_CASE("nothing outside the range of the basis is covered, on both sides") {
    CHECK(BeltStep(text).worst() == account::State::pass);
    CHECK(BeltStep(maker).worst() == account::State::pass);
    const auto with_pulley = [&](const char* d) {
      return BeltStep(with(with(text, "d_1", d), "d_2", "\"300 mm\"")).worst();
    };
    CHECK(with_pulley("\"281 mm\"") == account::State::not_covered);
    CHECK(with_pulley("\"124 mm\"") == account::State::fail);  // below the least that the section bends around
    CHECK(BeltStep(with(text, "d_1", "\"125 mm\"")).value("x_d") == 0.0);
    CHECK(BeltStep(with(text, "n_1", "\"190 rpm\"")).value("x_n") < 0.0);
    CHECK(BeltStep(with(text, "L", "\"6400 mm\"")).worst() != account::State::pass);
    CHECK(std::isnan(BeltStep(with(text, "L", "\"6400 mm\"")).value("c_L")));
    CHECK(BeltStep(with(text, "n_1", "\"4400 rpm\"")).value("x_v") > 1.0);
    CHECK(BeltStep(with(with(text, "L", ""), "a", "\"215 mm\"")).value("x_alpha") > 1.0);
  }

  TEST_CASE("life is given only where the basis states it") {
    CHECK(BeltStep(maker).value("L_h") == 25000 * 3600.0);
    CHECK(std::isnan(BeltStep(text).value("L_h")));
    CHECK(rel(BeltStep(with(text, "duty", "\"medium\"")).value("L_h"), 3700 * 3600.0) < 1e-12);
    CHECK(rel(BeltStep(with(with(text, "duty", "\"heavy\""), "belt_class", "\"III\"")).value("L_h"), 1350 * 3600.0) <
          1e-12);
  }

  TEST_CASE("wrong input is reported, and bases are not mixed") {
    CHECK(BeltStep(with(text, "basis", "")).says("the belt class requires the basis iso"));
    CHECK(BeltStep(with(text, "basis", "")).issues.size() == 1);
    CHECK(BeltStep(with(text, "basis", "\"din\"")).says("optibelt"));
    CHECK(BeltStep(with(text, "section", "\"SPB\"")).says("the basis iso does not rate a section 'SPB'"));
    CHECK(BeltStep(with(text, "section", "\"SPB\"")).says("Z, A, B, C, D, E"));
    CHECK(BeltStep(with(text, "belt_class", "")).says("give belt_class = \"III\" or \"IV\""));
    CHECK(BeltStep(with(text, "belt_class", "\"0_II\"")).says("classes 0 to II carry about 20 % less"));
    CHECK(BeltStep(with(maker, "belt_class", "\"III\"")).says("the belt class requires the basis iso"));
    CHECK(BeltStep(with(maker, "K_A_1", "1.1"))
              .says("K_A_1 requires the basis iso; the basis optibelt uses K_A for the tension"));
    CHECK(BeltStep(with(maker, "C_K_end", "\"high\"")).says("the belt-number factor requires the basis iso"));
    CHECK(BeltStep(with(text, "K_A", "")).says("give either K_A or"));
    CHECK(BeltStep(with(maker, "motor", "\"normal\"")).says("give either K_A or"));
    CHECK(BeltStep(with(text, "L", "")).says("give either the centre distance a or the belt length"));
    CHECK(BeltStep(with(text, "L", "\"900 mm\"")).says("too short for these pulleys"));
    CHECK(!BeltStep(with(text, "z", "-1")).issues.empty());
    CHECK(!BeltStep(with(text, "P", "\"-7 kW\"")).issues.empty());
    CHECK(!BeltStep(with(text, "h_day", "\"25 h\"")).issues.empty());
  }

  TEST_CASE("a drive that cannot transmit the power is reported so") {
    const BeltStep weak(with(text, "z", "1"));
    CHECK(weak.worst() == account::State::fail);
    CHECK(weak.value("u_P") > 1.0);
    CHECK(BeltStep(with(text, "P", "\"3000 kW\"")).worst() != account::State::pass);
  }
}
