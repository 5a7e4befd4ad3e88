#include "calculators/belt/synchronous.hpp"

#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::rel;
using test::with;

constexpr auto solve = test::evaluated<belt::Synchronous>;

/// A belt of the base width by ANSI/RMA IP-24: HP = d r/1000 (A - B (d r/1000)^2), d in inches, r in rpm.
struct Rated {
  const char* section;
  double p_b, b_0, F_a, m_0;
  double A, B;
};
constexpr Rated sections[] = {{"XL", 5.08, 9.5, 51.36, 0.02241, 0.0916, 7.07e-5},
                              {"L", 9.525, 25.4, 244.5, 0.09542, 0.436, 3.01e-4},
                              {"H", 12.7, 76.2, 2091, 0.447, 3.73, 1.41e-3},
                              {"XH", 22.225, 101.6, 4043, 1.484, 7.21, 4.68e-3},
                              {"XXH", 31.75, 127, 6392, 2.476, 11.4, 7.81e-3}};

belt::Synchronous::Input of(const Rated& row) {
  belt::Synchronous::Input in;
  in.p_b = row.p_b * mm, in.b_0 = row.b_0 * mm, in.b = in.b_0;
  in.F_a = row.F_a * N, in.m_0 = row.m_0 * kg_per_m;
  in.P = 4.0 * kW, in.K_A = 1.5;
  in.n_1 = 1450.0 * rpm;
  in.z_1 = 20, in.z_2 = 40;
  in.a = 40.0 * in.p_b;
  return in;
}

belt::Synchronous::Input pump() {
  auto in = of(sections[2]);
  in.a = 500.0 * mm, in.b = 50.8 * mm;
  return in;
}

const std::string text = R"(calculator = "belt.synchronous"
synchronous_belt = "H"
P = "4 kW"
K_A = 1.5
n_1 = "1450 rpm"
z_1 = 20
z_2 = 40
a = "500 mm"
b = "50.8 mm"
)";

}  // namespace

TEST_SUITE("belt synchronous") {
  TEST_CASE("belts of the base width have the power of the formulas of ANSI/RMA IP-24") {
    for (const Rated& row : sections) {
      for (const double n : {100.0, 870.0, 1450.0}) {
        CAPTURE(row.section);
        CAPTURE(n);
        auto in = of(row);
        in.n_1 = n * rpm;
        const double x = in.z_1 * (row.p_b / 25.4) / std::acos(-1.0) * n / 1000.0;
        const double horsepower = x * (row.A - row.B * x * x);
        CHECK(rel(in_si(solve(in).P_R), 745.7 * horsepower) < 5e-4);
      }
    }
  }

  TEST_CASE("the rows of the table are those of the formulas") {
    for (const Rated& row : sections) {
      CAPTURE(row.section);
      const BeltStep step(with(with(text, "synchronous_belt", '"' + std::string(row.section) + '"'), "a", "\"2 m\""));
      auto in = of(row);
      in.a = 2.0 * m, in.b = 50.8 * mm;
      CHECK(rel(step.value("P_R"), in_si(solve(in).P_R)) < 1e-12);
      CHECK(rel(step.value("L"), in_si(solve(in).L)) < 1e-12);
    }
  }

  TEST_CASE("belts of one inch width transmit what a manufacturer's tables of ZR belts state, within 5 %") {
    for (const auto& row : {std::pair{2, 624.0}, {3, 850.0}, {4, 1043.0}}) {
      const auto& section = sections[row.first];
      auto in = of(section);
      in.b = 25.4 * mm;
      CAPTURE(section.section);
      CHECK(rel(solve(in).k_w * in_si(in.F_a), row.second) < 0.05);
    }
  }

  TEST_CASE("a drive computed by an independent program, its centre distance by bisection") {
    const auto r = solve(pump());
    CHECK(rel(r.z_0, 108.99765375358375) < 1e-12);
    CHECK(r.z_B == 109.0);
    CHECK(rel(in_si(r.a), 0.5000149475983897) < 1e-12);
    CHECK(r.z_m == 9.0);
    CHECK(rel(in_si(r.P_R), 8015.712348527804) < 1e-12);
    CHECK(rel(r.u_P, 0.7485298547548281) < 1e-12);
    CHECK(rel(in_si(r.S_1), 1233.0584124280676) < 1e-12);
    CHECK(rel(in_si(r.F_0), 744.3264004812851) < 1e-12);
    CHECK(rel(in_si(r.R_0), 1483.7795746955471) < 1e-12);
    CHECK(rel(in_si(r.R), 1463.5314723703477) < 1e-12);
  }

  TEST_CASE("centre distance and number of belt teeth are the inverse of each other") {
    auto in = pump();
    for (const int z : {52, 60, 109, 400}) {
      in.a = unset<Length>, in.z_B = z;
      const auto r = solve(in);
      in.a = r.a, in.z_B = 0;
      CAPTURE(z);
      CHECK(rel(solve(in).z_0, z) < 1e-12);
      CHECK(rel(solve(in).a, r.a) < 1e-12);
    }
  }

  TEST_CASE("a fifth of the rating is lost for each tooth in mesh below six") {
    auto in = pump();
    in.z_1 = 12, in.z_2 = 12;
    CHECK(solve(in).k_z == 1.0);
    for (const auto& row : {std::pair{11, 0.8}, {10, 0.8}, {9, 0.6}, {8, 0.6}, {6, 0.4}}) {
      in.z_1 = row.first, in.z_2 = row.first;
      CAPTURE(row.first);
      CHECK(solve(in).k_z == doctest::Approx(row.second).epsilon(1e-12));
    }
    CHECK(solve(in).z_m == 3.0);
  }

  TEST_CASE("speed-up drives have a larger service factor") {
    auto in = pump();
    for (const auto& row : {std::pair{20, 0.0}, {24, 0.0}, {25, 0.1}, {35, 0.2}, {50, 0.3}, {70, 0.4}}) {
      in.z_1 = row.first, in.z_2 = 20, in.a = 1.0 * m;
      CAPTURE(row.first);
      CHECK(solve(in).c_i == row.second);
      CHECK(solve(in).n_k == solve(in).n_2);
    }
  }

  TEST_CASE("torque and speed give the same as the power") {
    auto in = pump();
    const auto by_power = solve(in);
    in.T_1 = in.P / in.n_1, in.P = unset<Power>;
    CHECK(rel(solve(in).u_P, by_power.u_P) < 1e-12);
    CHECK(rel(solve(in).R, by_power.R) < 1e-12);
  }

  TEST_CASE("the smallest standard width that transmits the power is found") {
    const BeltStep step(with(text, "b", "\"?\""));
    CHECK(step.value("k_w") == doctest::Approx(std::pow(50.8 / 76.2, 1.14)).epsilon(1e-9));
    CHECK(step.worst() == account::State::pass);
  }

  TEST_CASE("contradictory input is named with its remedy") {
    CHECK(BeltStep(with(text, "z_B", "109")).says("give either the centre distance a or the number of belt teeth z_B"));
    CHECK(BeltStep(with(text, "a", "\"120 mm\"")).says("the pulleys would touch"));
    CHECK(BeltStep(with(with(text, "a", ""), "z_B", "50")).says("give at least 51"));
    CHECK(BeltStep(with(text, "synchronous_belt", "")).says("give the pitch p_b, or a belt"));
    CHECK(BeltStep(with(text, "T_1", "\"10 N*m\"")).says("give either P or T_1"));
  }
}
