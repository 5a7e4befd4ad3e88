#include "calculators/section/torsion/solid_torsion.hpp"

#include "calculators/section/shapes/torsion.hpp"
#include "tests/calculators/section/sections.hpp"
#include "tests/found/modes.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::section;

namespace {

using Input = SolidTorsion::Input;
struct Point {
  double y, z;  // mm
};

Input section_of(const std::vector<Point>& points) {
  Input in;
  in.T = 10.0 * N_m, in.tau_adm = 50.0 * MPa;
  for (const auto& [y, z] : points) in.points.push_back({y * mm, z * mm});
  return in;
}

std::vector<Point> rectangle_of(double b, double h, double y = 0.0, double z = 0.0) {
  return {{y, z}, {y + b, z}, {y + b, z + h}, {y, z + h}};
}

/// I_t by finite differences on a grid of squares, an independent method: Gauss and Seidel on phi, zero where `solid`
/// is not; second order, extrapolated from two grids.
template <class Solid>
double by_differences(double width, double height, const Solid& solid, int n) {
  const double h = width / n;
  const int rows = static_cast<int>(std::lround(height / h));
  std::vector<double> phi((n + 1) * (rows + 1), 0.0);
  const double over = 2 / (1 + std::sin(pi / std::min(n, rows)));
  for (int round = 0; round < 8 * n; ++round) {
    for (int i = 1; i < n; ++i) {
      for (int j = 1; j < rows; ++j) {
        if (!solid(i * h, j * h)) continue;
        double& p = phi[i * (rows + 1) + j];
        const double around = phi[(i - 1) * (rows + 1) + j] + phi[(i + 1) * (rows + 1) + j] +
                              phi[i * (rows + 1) + j - 1] + phi[i * (rows + 1) + j + 1];
        p += over * ((around + 2 * h * h) / 4 - p);
      }
    }
  }
  double sum = 0.0;
  for (const double p : phi) sum += p;
  return 2 * sum * h * h;
}

}  // namespace

TEST_SUITE("solid sections in torsion") {
  TEST_CASE("rectangles: Saint-Venant's series to 1e-5, its largest stress to 2e-4, in the middle of the longer side") {
    for (const double a : {1.0, 1.3, 2.0, 5.0, 10.0}) {
      const auto [k_1, k_2] = rectangle_factors(a);
      const auto r = solve<SolidTorsion>(section_of(rectangle_of(10 * a, 10)));
      CAPTURE(a);
      CHECK(rel(r.I_t / mm4, k_1 * a * 1e4) < 1.2e-5);
      CHECK(rel(r.W_t / mm3, k_2 * a * 1e3) < 2e-4);
      CHECK(rel(r.I_t / mm4, k_1 * a * 1e4) < r.e_I);
      CHECK(rel(r.W_t / mm3, k_2 * a * 1e3) < std::max(r.e_W, 2e-5));
      if (a > 1.0) CHECK(std::abs(r.y_t / mm - 5 * a) < 0.6 * a);
    }
  }

  TEST_CASE("an equilateral triangle: sqrt(3) a^4/80 and a^3/20") {
    const auto r = solve<SolidTorsion>(section_of({{0, 0}, {30, 0}, {15, 15 * std::sqrt(3.0)}}));
    CHECK(rel(r.I_t / mm4, std::sqrt(3.0) * 810000 / 80) < 1e-6);
    CHECK(rel(r.W_t / mm3, 27000.0 / 20) < 2e-4);
  }

  TEST_CASE("[Anexa-BMOM] a hexagon: 1.04 a^4 and 0.977 a^3; a right isosceles triangle: 0.0261 a^4") {
    std::vector<Point> hexagon;
    for (int i = 0; i < 6; ++i) hexagon.push_back({10 * std::cos(i * pi / 3), 10 * std::sin(i * pi / 3)});
    const auto r = solve<SolidTorsion>(section_of(hexagon));
    CHECK(r.I_t / mm4 == doctest::Approx(10400).epsilon(0.005));
    CHECK(r.W_t / mm3 == doctest::Approx(977).epsilon(0.002));
    const auto half = solve<SolidTorsion>(section_of({{0, 0}, {10, 0}, {0, 10}}));
    CHECK(half.I_t / mm4 == doctest::Approx(261).epsilon(0.001));
  }

  TEST_CASE("an ellipse and a circle by 40 points: as close as the points allow") {
    std::vector<Point> ellipse;
    for (int i = 0; i < 40; ++i) ellipse.push_back({20 * std::cos(i * pi / 20), 10 * std::sin(i * pi / 20)});
    const double lacks = 1 - std::sin(pi / 20) / (pi / 20);  // share of the area
    const auto r = solve<SolidTorsion>(section_of(ellipse));
    CHECK(rel(r.I_t / mm4, pi * 8e6 / 500) < 2.2 * lacks);
    CHECK(rel(r.W_t / mm3, pi * 2000 / 2) < 0.025);
  }

  TEST_CASE("an angle and a square tube against finite differences") {
    const auto angle = section_of({{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 40}, {0, 40}});
    const auto in_angle = [](double y, double z) { return y < 20 - 1e-9 || z < 20 - 1e-9; };
    const double coarse = by_differences(60, 40, in_angle, 60), fine = by_differences(60, 40, in_angle, 120);
    const auto r = solve<SolidTorsion>(angle);
    CHECK(rel(r.I_t / mm4, fine + (fine - coarse) / 2) < 2e-3);  // between first and second order, by the inner corner
    CHECK(!is_set(r.W_t));
    auto tube = section_of(rectangle_of(12, 12));
    tube.holes.push_back({});
    for (const auto& [y, z] : rectangle_of(8, 8, 2, 2)) tube.holes.back().points.push_back({y * mm, z * mm});
    CHECK(solve<SolidTorsion>(tube).I_t / mm4 ==
          doctest::Approx(2231).epsilon(1e-3));  // differences, 80 per side: 2229
  }

  TEST_CASE("position, direction of the contour and first corner do not matter; size to the fourth power") {
    const auto r = solve<SolidTorsion>(section_of({{0, 0}, {30, 0}, {25, 12}, {5, 20}}));
    const auto turned = solve<SolidTorsion>(section_of({{5005, 20}, {5025, 12}, {5030, 0}, {5000, 0}}));
    CHECK(rel(turned.I_t, r.I_t) < 1e-9);
    CHECK(rel(turned.W_t, r.W_t) < 1e-7);
    const auto large = solve<SolidTorsion>(section_of({{0, 0}, {3e4, 0}, {2.5e4, 1.2e4}, {5e3, 2e4}}));
    CHECK(rel(large.I_t / mm4, 1e12 * (r.I_t / mm4)) < 1e-12);
  }

  TEST_CASE("a re-entrant corner: no section modulus, and the part does not pass") {
    const std::string angle =
        "points = [[\"0 mm\", \"0 mm\"], [\"60 mm\", \"0 mm\"], [\"60 mm\", \"20 mm\"], [\"20 mm\", \"20 mm\"], "
        "[\"20 mm\", \"40 mm\"], [\"0 mm\", \"40 mm\"]]\ntheta_adm = ";
    CHECK(test::mode_with("section.solid_torsion", "", "yield") == "pass");
    CHECK(test::mode_with("section.solid_torsion", "", "corner") == "none");
    CHECK(test::mode_with("section.solid_torsion", angle, "yield") == "not-judged");
    CHECK(test::mode_with("section.solid_torsion", angle, "corner") == "not-judged");
    CHECK(test::mode_with("section.solid_torsion", "T = \"-400 N*m\"", "yield") == "fail");
    CHECK(test::mode_with("section.solid_torsion",
                          "points = [[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"], [\"1 m\", \"5 mm\"], [\"0 m\", \"5 mm\"]]",
                          "yield") == "not-covered");
    CHECK(test::mode_with("section.solid_torsion", "tau_adm = \nsigma_adm = \"20 MPa\"\nbehaviour = \"brittle\"",
                          "fracture") == "fail");
  }
}
