#include "calculators/vessel/shell.hpp"

#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

#include <functional>

namespace {

using namespace loadpath;
using namespace loadpath::tests;

/// A meridian r(t), z(t), t from 0 to 1, in metres.
vessel::Shell::Input along(int n, const std::function<vessel::Shell::Point(double)>& point) {
  vessel::Shell::Input in;
  in.p = 1.0 * MPa;
  in.delta = 10.0 * mm;
  in.sigma_adm = 200.0 * MPa;
  for (int i = 0; i < n; ++i) in.points.push_back(point(static_cast<double>(i) / (n - 1)));
  return in;
}

vessel::Shell::Input bowl(int n, double sign) {
  return along(n, [&](double t) {
    const double psi = t * pi / 2;
    return vessel::Shell::Point{std::sin(psi) * m, sign * (1 - std::cos(psi)) * m};
  });
}

vessel::Shell::Result shell(const vessel::Shell::Input& in) { return solve<vessel::Shell>(in); }

}  // namespace

TEST_SUITE("vessel.shell") {
  TEST_CASE("points on a circle give the sphere exactly, from bottom to top and from top to bottom") {
    for (const double sign : {1.0, -1.0}) {
      for (const auto& a : shell(bowl(9, sign)).along) {
        CHECK(rel(in_si(a.rho_o), 1.0) < 1e-9);
        CHECK(rel(in_si(a.rho_M), 1.0) < 1e-9);
        CHECK(rel(in_si(a.sigma_o), 50e6) < 1e-9);
        CHECK(rel(in_si(a.sigma_M), 50e6) < 1e-9);
      }
    }
  }

  TEST_CASE("points on a line give the cone and the cylinder exactly, closed and open") {
    const auto cylinder = along(5, [](double t) { return vessel::Shell::Point{1.0 * m, t * m}; });
    for (const auto& a : shell(cylinder).along) {
      CHECK(rel(in_si(a.sigma_o), 100e6) < 1e-12);
      CHECK(rel(in_si(a.sigma_M), 50e6) < 1e-12);
      CHECK_FALSE(is_set(a.rho_M));
    }
    auto open = cylinder;
    open.start = vessel::Shell::Start::open;
    for (const auto& a : shell(open).along) CHECK(in_si(a.sigma_M) == 0.0);
    const auto cone = along(5, [](double t) { return vessel::Shell::Point{(0.2 + 0.8 * t) * m, (1 + 0.8 * t) * m}; });
    CHECK(rel(in_si(shell(cone).along.back().sigma_o), 1e6 / (0.01 * std::sqrt(0.5))) < 1e-12);
  }

  TEST_CASE("points on an ellipse come close to it, the closer the more they are") {
    double last = 1.0;
    for (const int n : {16, 32, 64}) {
      const auto in = along(n, [](double t) {
        return vessel::Shell::Point{std::sin(t * pi / 2) * m, -0.7 * std::cos(t * pi / 2) * m};
      });
      const double equator = in_si(shell(in).along[static_cast<std::size_t>(n) - 2].sigma_o);
      const double phi = (n - 2.0) / (n - 1.0) * pi / 2, w = std::hypot(std::cos(phi), 0.7 * std::sin(phi));
      const double rho_o = w / 0.7, rho_M = w * w * w / 0.7;
      const double error = rel(equator, 1e8 * rho_o * (1 - rho_o / (2 * rho_M)));
      CHECK(error < 0.5 * last);
      last = error;
    }
    CHECK(last < 0.02);
  }

  TEST_CASE(
      "a curvature that changes from point to point: none on an arc, ever less on an ellipse, a jump at a knuckle") {
    CHECK(shell(bowl(9, 1.0)).w_kappa < 1e-6);
    double last = 10.0;
    for (const int n : {16, 32, 64}) {
      const auto in = along(n, [](double t) {  // two to one, spaced by its slope
        const double e = std::atan2(2 * std::sin(t * pi / 2), std::cos(t * pi / 2));
        return vessel::Shell::Point{std::sin(e) * m, -0.5 * std::cos(e) * m};
      });
      const auto r = shell(in);
      CHECK(r.w_kappa < 0.6 * last);
      if (r.w_kappa < 0.2) CHECK(rel(in_si(r.along.back().sigma_o), -1e8) < 0.05);  // p a (1 - 2)/delta
      last = r.w_kappa;
    }
    CHECK(last < 0.2);
    const auto head = along(21, [](double t) {  // crown 1 m, knuckle 0.1 m, 1 m across
      const double begin = std::asin(0.4 / 0.9), psi = t < 0.5 ? 2 * t * begin : begin + (2 * t - 1) * (pi / 2 - begin);
      if (t <= 0.5) return vessel::Shell::Point{std::sin(psi) * m, -std::cos(psi) * m};
      return vessel::Shell::Point{(0.4 + 0.1 * std::sin(psi)) * m, -(0.9 * std::cos(begin) + 0.1 * std::cos(psi)) * m};
    });
    CHECK(shell(head).w_kappa > 4.0);  // about half of R/r - 1 = 9
    CHECK(rel(shell(head).w_b, 0.002 * 1.0 / 0.01) < 0.01);
    CHECK(shell(bowl(9, 1.0)).w_b == 0.0);
  }

  TEST_CASE("a hanging cone of points carries its liquid like the cone") {
    auto in = along(41, [](double t) { return vessel::Shell::Point{t * m, t * m}; });
    in.points[0].r = 1e-6 * m;
    in.p = 0.0 * MPa;
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = 1.0 * m;
    const double unit = 1000 * 9.80665 / (0.01 * std::sqrt(0.5));
    for (const auto& a : shell(in).along) {
      const double y = in_si(a.z);
      if (y < 0.01) continue;
      CHECK(std::abs(in_si(a.sigma_o) - unit * (1 - y) * y) < 1e-5 * unit);
      CHECK(std::abs(in_si(a.sigma_M) - unit / 2 * (1 - 2 * y / 3) * y) < 1e-5 * unit);
    }
  }

  TEST_CASE("an edge of the meridian is not covered, on both sides of 15 degrees between chords") {
    for (const auto& [n, covered] : {std::pair{8, true}, std::pair{6, false}}) {
      const auto r = shell(bowl(n, 1.0));
      CHECK(rel(r.psi_max, pi / 2 / (n - 1)) < 1e-9);
      CHECK((r.psi_max < 15 * pi / 180) == covered);
    }
  }

  TEST_CASE("the radius that is given moves the wall along its normal") {
    auto in = bowl(13, 1.0);
    in.measured = vessel::Measured::inner;
    CHECK(rel(in_si(shell(in).along[4].rho_o), 1.005) < 1e-6);
    in = bowl(13, -1.0);
    in.measured = vessel::Measured::outer;
    CHECK(rel(in_si(shell(in).along[4].rho_o), 0.995) < 1e-6);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.shell\"\nsigma_adm = \"140 MPa\"\np = \"1 MPa\"\npoints = ";
    CHECK(says(step + "[[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"]]\n", "at least three points"));
    CHECK(says(step + "[[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"], [\"1 mm\", \"1 mm\"]]\n",
               "neighbouring points of the meridian must differ"));
    CHECK(says(step + "[[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"], [\"0 mm\", \"2 mm\"]]\n", "split a shell"));
  }
}
