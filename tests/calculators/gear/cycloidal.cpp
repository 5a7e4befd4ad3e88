#include "calculators/gear/cycloidal/cycloidal.hpp"

#include "calculators/catalogue.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/project/project.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace loadpath;
using Pinion = gear::Cycloidal::Pinion;

constexpr auto solve = test::evaluated<gear::Cycloidal>;

using std::numbers::pi;
using test::rel;

gear::Cycloidal::Input clock_pair(int leaves, double ratio) {
  gear::Cycloidal::Input in;
  in.m = 1.0 * mm;
  in.z_1 = leaves, in.z_2 = static_cast<int>(std::lround(leaves * ratio));
  return in;
}

gear::Cycloidal::Input lantern(int pins, int teeth, double module, double diameter) {
  gear::Cycloidal::Input in;
  in.pinion = Pinion::pins;
  in.m = module * mm;
  in.z_1 = pins, in.z_2 = teeth;
  in.d_p = diameter * mm;
  return in;
}

double in_mm(Length x) { return in_si(x) / 1e-3; }
double in_deg(double radians) { return radians * 180.0 / pi; }

std::string faults(const std::string& lines) {
  std::string all;
  for (const Issue& issue : test::told("[g]\ncalculator = \"gear.cycloidal\"\nm = \"2 mm\"\n" + lines).issues)
    all += issue.key + ": " + issue.message.text() + " | " + issue.hint.text() + "\n";
  return all;
}

}  // namespace

TEST_SUITE("gear cycloidal") {
  TEST_CASE("addendum and radius factors of the table of BS 978-2, for 6 to 16 leaves") {
    struct Factors {
      int leaves;
      double ratio, addendum, radius;
    };
    const Factors rows[] = {{6, 3, 1.259, 1.855},   {6, 5, 1.293, 1.906},    {6, 12, 1.328, 1.957},
                            {7, 4, 1.359, 2.003},   {8, 3, 1.403, 2.068},    {8, 7.5, 1.471, 2.169},
                            {8, 8, 1.475, 2.173},   {9, 6, 1.526, 2.249},    {10, 3, 1.523, 2.244},
                            {10, 10, 1.618, 2.385}, {12, 4, 1.661, 2.448},   {14, 5, 1.782, 2.626},
                            {15, 8, 1.869, 2.755},  {16, 6.5, 1.897, 2.795}, {16, 12, 1.940, 2.859}};
    constexpr double last_digit = 0.0011;  // of the table, whose numbers are rounded twice
    for (const Factors& row : rows) {
      CAPTURE(row.leaves);
      CAPTURE(row.ratio);
      const auto r = solve(clock_pair(row.leaves, row.ratio));
      CHECK(std::abs(in_mm(r.h_a2) - row.addendum) < last_digit);
      CHECK(std::abs(in_mm(r.r_f2) - row.radius) < last_digit);
      CHECK(rel(in_mm(r.h_f1), in_mm(r.h_a2) + 0.4) < 1e-12);
    }
  }

  TEST_CASE("a lantern as its flanks from differences along the path of a pin: independent computation") {
    const auto r = solve(lantern(10, 60, 2.0, 3.0));
    CHECK(rel(r.f, 1.96466376) < 1e-7);
    CHECK(rel(in_mm(r.d_a2), 127.465722) < 1e-8);
    CHECK(rel(in_deg(r.phi_a), 53.5226793) < 1e-7);
    CHECK(rel(r.eps_pins, 1.35028079) < 1e-7);
    auto in = lantern(8, 40, 1.0, 1.2);
    in.j = 0.05 * mm, in.k_a = 0.9;
    const auto loose = solve(in);
    CHECK(rel(loose.f, 1.97490924) < 1e-7);
    CHECK(rel(in_deg(loose.phi_a), 57.9729397) < 1e-7);
    CHECK(rel(loose.eps_pins, 1.17684351) < 1e-7);
    CHECK(rel(in_mm(loose.s_2), pi - 1.25) < 1e-12);
  }

  TEST_CASE("the end of contact of radial flanks: the tip circle cuts the rolling circle") {
    const auto r = solve(clock_pair(8, 8));
    const double a = in_mm(r.d_2) / 2 + in_mm(r.d_1) / 4, rho = in_mm(r.d_1) / 4, tip = in_mm(r.d_a2) / 2;
    const double theta = std::acos((a * a + rho * rho - tip * tip) / (2 * a * rho));
    CHECK(rel(r.phi_a, theta / 2) < 1e-9);
    CHECK(rel(r.alpha_a, theta / 2) < 1e-9);
    CHECK(rel(r.phi_e + r.phi_a, 2 * pi / 8) < 1e-12);
    CHECK(std::isnan(r.eps_pins));
    CHECK(rel(in_mm(r.s_1), 1.05) < 1e-12);
    CHECK(rel(in_mm(solve(clock_pair(11, 4)).s_1), 1.25) < 1e-12);
  }

  TEST_CASE("thin pins stay in contact longer, thick ones leave low teeth") {
    double last = 10.0;
    for (const double diameter : {0.01, 1.0, 2.0, 3.0, 4.0, 5.0}) {
      const auto r = solve(lantern(10, 60, 2.0, diameter));
      CHECK(r.eps_pins < last);
      last = r.eps_pins;
    }
  }

  TEST_CASE("pins that leave no teeth, and a diameter without pins, are refused") {
    const auto says = [](const std::string& lines, const std::string& part) {
      CAPTURE(faults(lines));
      CHECK(faults(lines).find(part) != std::string::npos);
    };
    says("pinion = \"pins\"\nz_1 = 10\nz_2 = 60\n", "needs the diameter d_p");
    says("z_1 = 10\nz_2 = 60\nd_p = \"3 mm\"\n", "d_p applies to pins only");
    says("pinion = \"pins\"\nz_1 = 10\nz_2 = 60\nd_p = \"6.3 mm\"\n", "must leave teeth");
    says("pinion = \"pins\"\nz_1 = 10\nz_2 = 60\nd_p = \"3 mm\"\nj = \"3.3 mm\"\n", "must leave teeth");
    says("z_1 = 10\nz_2 = 60\nj = \"3.2 mm\"\n", "must leave teeth");
  }

  TEST_CASE("every pair of numbers has finite results, or is refused") {
    for (const int z_1 : {3, 4, 7, 20, 200}) {
      for (const int z_2 : {6, 11, 60, 2000}) {
        for (const double diameter : {0.001, 0.8, 1.5, 2.2, 3.0}) {
          const auto in = lantern(z_1, z_2, 1.0, diameter);
          if (!gear::Cycloidal::has_teeth(in)) continue;
          const auto r = solve(in);
          CAPTURE(z_1);
          CAPTURE(z_2);
          CAPTURE(diameter);
          CHECK(std::isfinite(r.f + r.eps + r.K_g + in_mm(r.d_a2)));
          CHECK(r.f > 0.0);
          CHECK(r.phi_a > 0.0);
        }
      }
    }
  }

  TEST_CASE("the figure shows the mesh: contact ends at the tip of the wheel, and the dimensions are the results") {
    for (const auto& in : {clock_pair(10, 6.4), lantern(10, 60, 2.0, 3.0)}) {
      const auto r = solve(in);
      const std::vector<figure::Figure> figures = gear::Cycloidal::figures(in, r);
      REQUIRE(figures.size() == 1);
      const figure::Drawing& drawing = *std::get<figure::Drawn>(figures[0].content);
      REQUIRE(drawing.views.size() == 2);
      CHECK(drawing.views[0].lengths[0].value.si == in_si(r.a));
      CHECK(drawing.views[0].lengths[3].value.si == in_si(r.d_a2));
      const auto& names = drawing.views[1].names;
      const auto end = std::ranges::find(names, std::string("E"), &figure::Drawing::Name::words);
      REQUIRE(end != names.end());
      CHECK(rel(2.0 * std::hypot(end->at.x - in_si(r.a), end->at.y), in_si(r.d_a2)) < 1e-9);
      for (const auto& path : drawing.views[1].paths) {
        for (const figure::Point point : path.points) CHECK(std::isfinite(point.x + point.y));
      }
    }
  }
}
