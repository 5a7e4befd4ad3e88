#include "calculators/drive/friction_wheels.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/calculators/motion/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using test::rel;
using Wheels = drive::FrictionWheels;
using Shape = Wheels::Shape;

constexpr auto solve = test::evaluated<Wheels>;

Wheels::Input wheels() {
  Wheels::Input in;
  in.T_1 = 30.0 * N_m;
  in.n_1 = 600.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = 500.0 * mm;
  in.b = 60.0 * mm;
  in.mu = 0.2;
  return in;
}

Wheels::Input bevel() {
  Wheels::Input in = wheels();
  in.shape = Shape::bevel;
  return in;
}

/// Whether the reader says this of the wheels with other lines.
bool says(const std::string& lines, const std::string& part) {
  std::vector<Issue> issues;
  project::read_project(
      "[w]\ncalculator = \"drive.friction_wheels\"\nn_1 = \"600 rpm\"\n" +
          std::string(lines.find("b = ") == 0 || lines.find("\nb = ") != std::string::npos ? "" : "b = \"60 mm\"\n") +
          lines,
      "w.toml", catalogue(), issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("friction wheels") {
  TEST_CASE("a roller 10 cm wide carries 50 kgf over where 200 to 500 kgf press it ([Lueger])") {
    Wheels::Input in = wheels();
    const Force kgf = 9.80665 * N.one;
    in.T_1 = 50.0 * kgf * in.d_1 / 2.0, in.b = 100.0 * mm, in.S_min = 1.0;
    in.mu = 0.25;  // leather, in the middle
    CHECK(rel(solve(in).F_pmin, 200.0 * kgf) < 1e-12);
    in.mu = unset<double>, in.pair = Wheels::Pair::cast_iron;
    CHECK(rel(solve(in).F_pmin, 500.0 * kgf) < 1e-12);
    CHECK(rel(solve(in).F_t / in.b, 5.0 * kgf / (10.0 * mm)) < 1e-12);  // 5 kgf on a centimetre
  }

  TEST_CASE("Q = 1.5 to 2 M/(f R) presses the wheels together, by either of the torques ([Artobolevsky])") {
    for (const double x : {1.5, 2.0}) {
      Wheels::Input in = wheels();
      in.S_min = x;
      const auto r = solve(in);
      CHECK(rel(in_si(r.F_p), 30.0 * x / (0.2 * 0.1)) < 1e-12);
      CHECK(rel(in_si(r.F_p), 75.0 * x / (0.2 * 0.25)) < 1e-12);
      CHECK(rel(in_si(r.shaft_2.T), 75.0) < 1e-12);
      CHECK(rel(r.S_R, x) < 1e-12);
      CHECK(r.u_S == 1.0);
    }
  }

  TEST_CASE("speeds and centre distances of the exercises of [Ruedas]") {
    Wheels::Input in = wheels();
    in.n_1 = 1800.0 * rpm, in.d_1 = 80.0 * mm, in.d_2 = 96.0 * mm;
    CHECK(rel(solve(in).n_2, 1500.0 * rpm) < 1e-12);
    in.n_1 = 2400.0 * rpm, in.d_1 = 120.0 * mm, in.d_2 = 150.0 * mm;
    CHECK(rel(in_si(solve(in).n_2), 32.0 * 2.0 * pi) < 1e-12);
    in.d_1 = 160.0 * mm, in.d_2 = 80.0 * mm;
    CHECK(rel(solve(in).a, 120.0 * mm) < 1e-12);
  }

  TEST_CASE("steel of 50 mm radius under 35 kN/mm on aluminium: 3585 MPa over 2 x 6.21 mm ([FENET-D3613])") {
    Wheels::Input in = wheels();
    in.d_1 = in.d_2 = 200.0 * mm;  // the curvature of 50 mm on a plane
    in.E_1 = 210.0 * GPa, in.E_2 = 70.0 * GPa;
    in.b = 10.0 * mm, in.F_p = 350e3 * N.one;
    const auto r = solve(in);
    CHECK(std::abs(in_si(r.p_H) / 1e6 - 3585.0) < 0.5);
    CHECK(std::abs(in_si(r.b_H) * 1e3 - 6.21) < 0.005);
    CHECK(rel(in_si(r.p_H) * pi / 4 * 2 * in_si(r.b_H), 35e6) < 1e-12);  // a half ellipse holds the line load
  }

  TEST_CASE("the minimum contact length brings the pressure to its limit, by either of the limits") {
    Wheels::Input in = wheels();
    in.E_1 = in.E_2 = 206.0 * GPa, in.p_adm = 400.0 * MPa, in.q_adm = 20.0 * N_per_mm;
    for (const auto shape : {Shape::cylindrical, Shape::grooved, Shape::bevel}) {
      in.shape = shape;
      in.alpha = shape == Shape::grooved ? 0.3 : unset<double>, in.z = shape == Shape::grooved ? 3 : 1;
      in.b = solve(in).b_min;
      const auto r = solve(in);
      CHECK(rel(r.u_p, 1.0) < 1e-12);
    }
    in.q_adm = unset<Stiffness>, in.b = solve(in).b_min;
    CHECK(rel(solve(in).u_p, 1.0) < 1e-12);
  }

  TEST_CASE("the groove flanks balance the pressing force: by their normal forces and friction as vectors") {
    Wheels::Input in = wheels();
    in.shape = Shape::grooved, in.z = 4;
    in.alpha = std::atan(0.3);
    CHECK(std::abs(2 * in.alpha * 180 / pi - 33.5) < 0.15);  // 33 1/2 deg in [Lueger]
    for (const double c_r : {0.0, 0.5, 1.0}) {
      in.c_r = c_r;
      const auto r = solve(in);
      double across = 0.0, along = 0.0;
      for (const double side : {-1.0, 1.0}) {  // x along the shaft, y along the line of centres
        const double n_x = side * std::cos(in.alpha), n_y = std::sin(in.alpha);
        const double t_x = -side * std::sin(in.alpha), t_y = std::cos(in.alpha);
        const double N = in_si(r.F_n) / 2, R = c_r * 0.2 * N;
        across += N * n_y + R * t_y, along += N * n_x + R * t_x;
      }
      CHECK(std::abs(along) < 1e-9);
      CHECK(rel(across, in_si(r.F_p)) < 1e-12);
      CHECK(rel(in_si(r.F_n), 1.5 * 300 / 0.2) < 1e-12);
      CHECK(rel(in_si(r.q), in_si(r.F_n) / (8 * 0.06)) < 1e-12);
    }
  }

  TEST_CASE("without friction against pressing in, grooves that open to a plane are pressed like cylinders") {
    Wheels::Input in = wheels();
    in.E_1 = in.E_2 = 206.0 * GPa;
    const auto plain = solve(in);
    in.shape = Shape::grooved, in.alpha = pi / 2, in.c_r = 0.0, in.b = 30.0 * mm;  // two flanks of 30 mm
    const auto r = solve(in);
    CHECK(rel(r.F_p, plain.F_p) < 1e-12);
    CHECK(rel(r.p_H, plain.p_H) < 1e-12);
  }

  TEST_CASE("the contact ends before the axis of a wheel and before the apex of the cones") {
    const std::string sizes = "d_1 = \"60 mm\"\nd_2 = \"60 mm\"\nT_1 = \"10 N*m\"\nmu = 0.2\n";
    const std::string words = "beyond the axis of a wheel or the apex";
    says(sizes + "b = \"90 mm\"\nshape = \"bevel\"\n", words);  // cones of 45 deg end after 84.9 mm
    says(sizes + "b = \"63 mm\"\nshape = \"grooved\"\nalpha = \"15 deg\"\n", words);
    Wheels::Input in = wheels();
    in.shape = Shape::bevel, in.d_1 = in.d_2 = 60.0 * mm;
    CHECK(rel(Wheels::most_length_of_cones(in), 0.4 * 0.03 * std::sqrt(2.0)) < 1e-12);
    in.b = 84.0 * mm;
    CHECK(Wheels::ends_before_axis(in));
    in.b = 85.0 * mm;
    CHECK_FALSE(Wheels::ends_before_axis(in));
  }

  TEST_CASE("bevel wheels roll on cones: equal speeds of all points of the line of contact, forces in balance") {
    for (const double Sigma : {60.0, 90.0, 110.0}) {
      Wheels::Input in = bevel();
      in.Sigma = Sigma * pi / 180;
      const auto r = solve(in);
      CHECK(rel(std::sin(r.delta_2) / std::sin(r.delta_1), 2.5) < 1e-12);  // diameters at any distance of the apex
      CHECK(rel(r.delta_1 + r.delta_2, in.Sigma) < 1e-12);
      const double fr_1 = in_si(r.F_r1), fa_1 = in_si(r.F_a1), fr_2 = in_si(r.F_r2), fa_2 = in_si(r.F_a2);
      CHECK(rel(std::hypot(fr_1, fa_1), in_si(r.F_n)) < 1e-12);
      CHECK(rel(std::hypot(fr_2, fa_2), in_si(r.F_n)) < 1e-12);
      // Shaft 1 along x and shaft 2 along x turned by Sigma, both away from the apex. Each is pushed along its shaft
      // and from the line of contact, which lies between them, so that the two forces cancel.
      const double c = std::cos(in.Sigma), s = std::sin(in.Sigma);
      CHECK(std::abs(fa_1 + fa_2 * c - fr_2 * s) < 1e-9);
      CHECK(std::abs(-fr_1 + fa_2 * s + fr_2 * c) < 1e-9);
    }
  }

  TEST_CASE("the loads push the wheels apart, and friction brakes one wheel with the force that drives the other") {
    const auto r = solve(wheels());
    CHECK(in_si(r.shaft_1.F_x) == -in_si(r.F_p));
    CHECK(in_si(r.shaft_2.F_x) == -in_si(r.F_p));
    CHECK(in_si(r.shaft_1.F_y) == -in_si(r.F_t));
    CHECK(in_si(r.shaft_2.F_y) == -in_si(r.F_t));
    CHECK(rel(in_si(r.shaft_1.T), 30.0) < 1e-12);
    CHECK(in_si(r.shaft_2.n) == -in_si(r.n_2));
  }

  TEST_CASE("wrong wheels are reported with their remedy") {
    const std::string sizes = "d_1 = \"200 mm\"\nd_2 = \"500 mm\"\n", load = "T_1 = \"30 N*m\"\n";
    says(sizes + load, "give either the coefficient of friction mu or the pair of materials");
    says(sizes + load + "mu = 0.2\nshape = \"grooved\"\n", "need the half groove angle alpha");
    says(sizes + load + "mu = 0.2\nz = 3\n", "only grooved wheels have a number of grooves");
    says(sizes + load + "mu = 0.2\np_adm = \"400 MPa\"\n", "the Hertzian pressure needs E_1 and E_2");
    says(sizes + load + "mu = 0.2\nshape = \"bevel\"\nSigma = \"140 deg\"\n", "a wheel would be a disc or a ring");
    says(sizes + "mu = 0.2\n", "give either P or T_1");
  }

  TEST_CASE("a contact length is searched for by a limit of the contact only") {
    const auto fault = [](const std::string& lines) {
      return test::SolvedStep("drive.friction_wheels",
                              "n_1 = \"600 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"500 mm\"\nT_1 = \"30 N*m\"\n"
                              "mu = 0.2\n" +
                                  lines)
          .fault();
    };
    CHECK(test::contains(fault("b = \"?\"\n"), "give q_adm of soft rims, or p_adm with E_1 and E_2"));
    CHECK(fault("b = \"?\"\nq_adm = \"30 N/mm\"\n").empty());
    CHECK(fault("b = \"60 mm\"\n").empty());
    CHECK(test::contains(fault("q_adm = \"30 N/mm\"\n"), "'b' is missing"));
  }
}
