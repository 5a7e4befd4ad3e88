#include "calculators/shaft/torsion/torsion.hpp"

#include "lib/quantity/units.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::rel;

constexpr auto solve = test::evaluated<shaft::Torsion>;

shaft::Torsion::Input shaft_under(double T, double tau_MPa) {
  shaft::Torsion::Input in;
  in.T = T * N_m;
  in.tau_adm = tau_MPa * MPa;
  return in;
}

/// [B19], worked example: four torques, G = 80 GPa, tau 30 MPa, 0.004 rad/m.
shaft::Torsion::Input line_shaft() {
  shaft::Torsion::Input in;
  in.G = 80.0 * GPa;
  in.tau_adm = 30.0 * MPa;
  in.theta_adm = from_si<Twist>(0.004);
  for (const auto& [x, T] : {std::pair{0.0, 900.0}, {0.3, -3600.0}, {0.8, 1500.0}, {1.0, 1200.0}})
    in.torques.push_back({Name(), x * m, T * N_m});
  return in;
}

}  // namespace

TEST_SUITE("shaft") {
  TEST_CASE("published shafts agree with the printed values") {
    struct Row {
      const char* source;
      double T, tau, chi, d_mm;
      int digits;
    };
    const Row rows[] = {
        {"[B19] worked example, printed", 2700, 30, NAN, 77, 2},
        {"[B19] worked example, exact", 2700, 30, NAN, 77.10292842, 9},
        {"[MecMovies] module 6.5", 5000, 65, NAN, 73.2, 3},
        {"[MecMovies] module 6.17", 424.413, 75, NAN, 30.660, 5},
        {"load path of the slotted lever, independent computation", 120.519, 30, NAN, 27.35, 4},
    };
    for (const Row& row : rows) {
      CAPTURE(row.source);
      shaft::Torsion::Input in = shaft_under(row.T, row.tau);
      in.chi = row.chi;
      const double unit = std::pow(10.0, std::floor(std::log10(row.d_mm)) + 1 - row.digits);
      CHECK(std::abs(solve(in).d_strength / mm - row.d_mm) <= 0.5 * unit);
    }
  }

  TEST_CASE("the line shaft of the textbook: moments, diameters and twist") {
    shaft::Torsion::Input in = line_shaft();
    in.d = 100.0 * mm;
    const auto r = solve(in);
    REQUIRE(r.segments.size() == 3);
    CHECK(rel(r.segments[0].M / N_m, 900) < 1e-12);
    CHECK(rel(r.segments[1].M / N_m, -2700) < 1e-12);
    CHECK(rel(r.segments[2].M / N_m, -1200) < 1e-12);
    CHECK(rel(r.d_stiffness / mm, 96.2838556) < 1e-9);
    CHECK(rel(r.phi, -0.001680676199) < 1e-9);
    CHECK(rel(in_si(r.tau_max), 13750987.08) < 1e-9);
    CHECK(rel(in_si(r.theta_max), 0.003437746771) < 1e-9);
  }

  TEST_CASE("a tube of 75 and 60 mm at 88 MPa has 70.4 MPa at its bore ([Mathix-tube])") {
    shaft::Torsion::Input in = shaft_under(4303.7, 90);
    in.G = 80.0 * GPa;
    shaft::Torsion::Segment tube;
    tube.l = 1.0 * m, tube.d = 75.0 * mm, tube.d_bore = 60.0 * mm, tube.rho = 30.0 * mm;
    in.segments.push_back(tube);
    const auto r = solve(in);
    CHECK(std::abs(in_si(r.tau_max) / 1e6 - 88.0) < 0.05);
    CHECK(std::abs(in_si(r.segments[0].tau_rho) / 1e6 - 70.4) < 0.05);
    CHECK(rel(in_si(r.segments[0].tau_rho), 80e9 * 0.030 * in_si(r.segments[0].theta)) < 1e-12);  // G rho theta
  }

  TEST_CASE("the shear stress is linear over the radius: zero at the axis, the largest at the surface") {
    for (const double share : {0.0, 0.25, 1.0}) {
      shaft::Torsion::Input in = shaft_under(1000, 90);
      shaft::Torsion::Segment bar;
      bar.l = 1.0 * m, bar.d = 113.98 * mm, bar.rho = share * 56.99 * mm;
      in.segments.push_back(bar);
      const auto r = solve(in);
      CHECK(std::abs(in_si(r.segments[0].tau_rho) - share * in_si(r.tau_max)) < 1e-6);
      CHECK(shaft::Torsion::radii_in_wall(in));
    }
  }

  TEST_CASE("a radius in the bore or outside the shaft is refused with its place") {
    shaft::Torsion::Input in = shaft_under(1000, 90);
    shaft::Torsion::Segment tube;
    tube.l = 1.0 * m, tube.d = 75.0 * mm, tube.chi = 0.8, tube.rho = 29.9 * mm;
    in.segments.push_back(tube);
    CHECK(!shaft::Torsion::radii_in_wall(in));
    CHECK(shaft::Torsion::radius_outside(in).path == "segments[1].rho");
    CHECK(shaft::Torsion::radius_outside(in).message.text().find("in the bore") != std::string::npos);
    in.segments[0].rho = 37.6 * mm;
    CHECK(!shaft::Torsion::radii_in_wall(in));
    CHECK(shaft::Torsion::radius_outside(in).message.text().find("outside the shaft") != std::string::npos);
    in.segments[0].rho = 0.0 * mm, in.segments[0].chi = unset<double>;
    CHECK(shaft::Torsion::radii_in_wall(in));
  }

  TEST_CASE("segments are springs in series: torque over twist, whatever the torques") {
    shaft::Torsion::Input in = shaft_under(12000, 60);
    in.G = 83.0 * GPa;
    for (const auto& [l, d] : {std::pair{2.0, 80.0}, {1.5, 100.0}, {2.5, 113.98}}) {
      shaft::Torsion::Segment s;
      s.l = l * m, s.d = d * mm;
      in.segments.push_back(s);
    }
    const auto r = solve(in);
    CHECK(rel(in_si(r.k_t), 12000 / r.phi) < 1e-12);
    for (const auto& s : r.segments) CHECK(rel(in_si(s.GI_t), 12000 / in_si(s.theta)) < 1e-12);
    in.T = unset<Moment>;
    in.fixed = shaft::Torsion::Fixed::left;
    in.torques.push_back({Name(), 3.0 * m, 500.0 * N_m});
    CHECK(rel(solve(in).k_t, r.k_t) < 1e-12);
  }

  TEST_CASE("12 kN m that twist 6 m of steel by 3 deg need 113.98 mm and give 41.27 MPa ([MATHalino] problem 305)") {
    shaft::Torsion::Input in = shaft_under(12000, 60);
    in.G = 83.0 * GPa;
    in.theta_adm = 3.0 * deg.one / (6.0 * m);
    in.d = 113.98 * mm;
    const auto r = solve(in);
    CHECK(std::abs(r.d_stiffness / mm - 113.98) < 0.005);
    CHECK(std::abs(r.tau_max / MPa - 41.27) < 0.005);
  }

  TEST_CASE("a ring of bore ratio 0.8 keeps 0.5904 of the section modulus") {
    shaft::Torsion::Input solid = shaft_under(1000, 40), ring = solid;
    ring.chi = 0.8;
    const double ratio_of_cubes = std::pow(solve(solid).d_strength / solve(ring).d_strength, 3);
    CHECK(rel(ratio_of_cubes, 0.5904) < 1e-12);
  }

  TEST_CASE("a bore as a size gives the same shaft as its ratio") {
    for (const double chi : {0.05, 0.3, 0.6, 0.9, 0.98}) {
      CAPTURE(chi);
      shaft::Torsion::Input by_ratio = line_shaft();
      by_ratio.chi = chi;
      const auto ring = solve(by_ratio);
      shaft::Torsion::Input by_size = line_shaft();
      by_size.d_bore = chi * ring.d_strength;
      CHECK(rel(in_si(solve(by_size).segments[1].d_strength), in_si(ring.d_strength)) < 1e-12);
    }
  }

  TEST_CASE("a shaft twice as thick transmits eight times the torque and is sixteen times as stiff") {
    shaft::Torsion::Input thin = line_shaft(), thick = line_shaft();
    thin.d = 50.0 * mm;
    thick.d = 100.0 * mm;
    CHECK(rel(solve(thin).tau_max / solve(thick).tau_max, 8) < 1e-12);
    CHECK(rel(solve(thin).theta_max / solve(thick).theta_max, 16) < 1e-12);
  }

  TEST_CASE("the order of the torques does not matter, and torques at one place act together") {
    shaft::Torsion::Input in = line_shaft(), mixed = line_shaft();
    std::swap(mixed.torques[0], mixed.torques[3]);
    std::swap(mixed.torques[1], mixed.torques[2]);
    mixed.torques[0].T = 700.0 * N_m;
    mixed.torques.push_back({Name(), mixed.torques[0].x, 500.0 * N_m});
    in.d = mixed.d = 90.0 * mm;
    CHECK(rel(solve(mixed).phi, solve(in).phi) < 1e-12);
    CHECK(solve(mixed).segments.size() == 3);
  }

  TEST_CASE("twists superpose like torques") {
    shaft::Torsion::Input a = line_shaft(), b = line_shaft(), sum = line_shaft();
    for (std::size_t i = 0; i < 4; ++i) {
      b.torques[i].T = (i == 1 ? 500.0 : i == 3 ? -500.0 : 0.0) * N_m;
      sum.torques[i].T = a.torques[i].T + b.torques[i].T;
    }
    a.d = b.d = sum.d = 80.0 * mm;
    CHECK(std::abs(solve(sum).phi - solve(a).phi - solve(b).phi) < 1e-15);
  }

  TEST_CASE("a fixed end takes the remaining torque") {
    shaft::Torsion::Input fixed = line_shaft(), free = line_shaft();
    fixed.torques.erase(fixed.torques.begin());
    fixed.fixed = shaft::Torsion::Fixed::left;
    fixed.d = free.d = 80.0 * mm;
    CHECK(rel(solve(fixed).phi, solve(free).phi) < 1e-12);
    CHECK(rel(solve(fixed).segments[0].M / N_m, 900) < 1e-12);
  }

  TEST_CASE("the twist between two sections is reported even where the ends turn less") {
    shaft::Torsion::Input in;
    in.G = 80.0 * GPa;
    in.tau_adm = 30.0 * MPa;
    in.d = 60.0 * mm;
    for (const auto& [x, T] : {std::pair{0.0, 500.0}, {0.5, -1000.0}, {1.0, 500.0}})
      in.torques.push_back({Name(), x * m, T * N_m});
    const auto r = solve(in);
    CHECK(std::abs(r.phi) < 1e-15);
    CHECK(rel(r.phi_max, std::abs(r.segments[0].phi)) < 1e-12);
  }

  TEST_CASE("a stepped shaft is assessed where it is thin") {
    shaft::Torsion::Input in;
    in.tau_adm = 40.0 * MPa;
    for (const auto& [x, T] : {std::pair{0.0, 800.0}, {0.9, -800.0}}) in.torques.push_back({Name(), x * m, T * N_m});
    for (const double d : {60.0, 40.0, 55.0}) {
      shaft::Torsion::Segment s;
      s.l = 300.0 * mm;
      s.d = d * mm;
      in.segments.push_back(s);
    }
    const auto r = solve(in);
    REQUIRE(r.segments.size() == 3);
    CHECK(rel(in_si(r.tau_max), 16 * 800 / (pi * std::pow(0.04, 3))) < 1e-12);
  }

  TEST_CASE("each factor acts once: twice the service factor is twice the stress and the utilisation") {
    shaft::Torsion::Input one = line_shaft(), two = line_shaft();
    two.K_A = 2.0;
    one.d = two.d = 100.0 * mm;
    CHECK(rel(solve(two).u_tau, 2 * solve(one).u_tau) < 1e-15);
    CHECK(rel(solve(two).u_theta, 2 * solve(one).u_theta) < 1e-15);
  }

  TEST_CASE("at the minimum diameter the governing condition is just met") {
    const auto r = solve(line_shaft());
    CHECK(rel(std::max(r.u_tau, r.u_theta), 1.0) < 1e-12);
    CHECK(r.d_stiffness > r.d_strength);
    CHECK(r.d_min < r.D_star);
  }

  TEST_CASE("the allowable stress from the yield strength is R_e over root three times S") {
    shaft::Torsion::Input in;
    in.T = 100.0 * N_m;
    in.R_e = 430.0 * MPa;
    in.S = 2.0;
    CHECK(rel(solve(in).tau_all / MPa, 430 / std::sqrt(3.0) / 2) < 1e-15);
  }

  TEST_CASE("a transverse force goes into the limit that does not cover it") {
    shaft::Torsion::Input in = shaft_under(100, 30);
    in.F = -3654.0 * N;
    CHECK(solve(in).F_bend / N == 3654.0);
    in.F = unset<Force>;
    CHECK_FALSE(is_set(solve(in).F_bend));
  }
}
