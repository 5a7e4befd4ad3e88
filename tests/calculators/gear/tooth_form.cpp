#include "calculators/gear/tooth_form.hpp"

#include "calculators/gear/involute.hpp"
#include "calculators/gear/lewis.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace {

using namespace loadpath::gear;
using std::numbers::pi;

constexpr Rack iso{pi / 9.0, 1.25, 0.38};

struct Factor {
  int z;
  double Y;
};

double lewis(int z) { return lewis_factor(iso, z, 0.0, 0.5 * z + 1.0); }

}  // namespace

TEST_SUITE("tooth form") {
  TEST_CASE("the inverse of the involute function returns the angle") {
    for (const double angle : {0.001, 0.05, 0.35, 0.7, 1.2, 1.5}) {
      CHECK(std::abs(angle_of_involute(involute(angle)) - angle) < 1e-12);
    }
    CHECK(std::isnan(angle_of_involute(0.0)));
    CHECK(std::isnan(angle_of_involute(-0.1)));
    CHECK(std::isnan(angle_of_involute(NAN)));
  }

  TEST_CASE("the fillet meets the flank where the straight flank of the rack ends") {
    for (const int z : {18, 25, 40, 100}) {
      const FormPoint p = fillet_point(iso, z, 0.0, 0.5 * pi - iso.alpha);
      const double r = form_radius(iso, z, 0.0);
      CHECK(std::abs(std::hypot(p.x, p.y) - r) < 1e-9);
      CHECK(std::abs(std::atan2(p.x, p.y) - half_angle(iso.alpha, z, 0.0, r)) < 1e-9);
      const FormPoint root = fillet_point(iso, z, 0.0, 0.0);
      CHECK(std::abs(std::hypot(root.x, root.y) - (0.5 * z - 1.25)) < 1e-12);
    }
  }

  TEST_CASE("Lewis factors of an independent search over the points of the fillet") {
    for (const Factor& row : {Factor{12, 0.2377}, {17, 0.2924}, {20, 0.3145}, {50, 0.4018}, {400, 0.4661}}) {
      CAPTURE(row.z);
      CHECK(std::abs(lewis(row.z) - row.Y) < 6e-5);
    }
  }

  TEST_CASE("Lewis factors are within 6 % of the table of [Shigley14]") {
    for (const Factor& row :
         {Factor{12, 0.245}, {16, 0.296}, {20, 0.322}, {30, 0.359}, {50, 0.409}, {100, 0.447}, {400, 0.480}}) {
      CAPTURE(row.z);
      CHECK(std::abs(lewis(row.z) / row.Y - 1.0) < 0.06);
    }
  }

  TEST_CASE("no section of the fillet is weaker than that of the Lewis factor") {
    for (const double shift : {-0.2, 0.0, 0.6, 1.0}) {
      for (const double z : {14.0, 17.3, 31.0, 150.0}) {
        CAPTURE(shift);
        CAPTURE(z);
        const double r_a = 0.5 * z + 1.0 + shift, base = 0.5 * z * std::cos(iso.alpha);
        const double load = base / std::cos(std::acos(base / r_a) - half_angle(iso.alpha, z, shift, r_a));
        double least = 1e9;
        constexpr int steps = 20000;
        for (int i = 0; i <= steps; ++i) {
          const FormPoint p = fillet_point(iso, z, shift, (0.5 * pi - iso.alpha) * i / steps);
          least = std::min(least, 2.0 * p.x * p.x / (3.0 * (load - p.y)));
        }
        const double Y = lewis_factor(iso, z, shift, r_a);
        CHECK(Y <= least * (1.0 + 1e-14));
        CHECK(Y >= least * (1.0 - 1e-7));
      }
    }
  }

  TEST_CASE("more teeth and a larger shift make a tooth stronger") {
    for (int z = 12; z < 200; ++z) CHECK(lewis(z + 1) > lewis(z));
    CHECK(lewis_factor(iso, 15, 0.5, 9.0) > lewis_factor(iso, 15, 0.0, 8.5));
  }
}
