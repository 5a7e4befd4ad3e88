// Module and face width that gear.rating finds, against all combinations of the stocks.
#include "calculators/gear/rating/rating.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::gear;

const std::vector<double> modules{1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20};
const std::vector<double> r20{1,    1.12, 1.25, 1.4, 1.6, 1.8, 2,   2.24, 2.5, 2.8,
                              3.15, 3.55, 4,    4.5, 5,   5.6, 6.3, 7.1,  8,   9};

/// The example of the calculator, in millimetres.
Rating::Input reducer_with(double m, double b) {
  Rating::Input in;
  in.z_1 = 19, in.z_2 = 104, in.m_n = m * mm, in.x_1 = 0.5, in.x_2 = 0.15, in.rho_fP = 0.25, in.b = b * mm;
  in.T_1 = 400.0 * N_m, in.n_1 = 980.0 * rpm, in.K_A = 1.25, in.grade = 6, in.finish = Finish::ground;
  in.R_z1 = in.R_z2 = 5.0 * um, in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.quality_1 = in.quality_2 = Quality::MQ, in.H_1 = in.H_2 = 720, in.place = gear::Place::middle;
  in.S_Hmin = 1.1, in.S_Fmin = 1.4;
  return in;
}

bool carries_with(double m, double b) {
  NoTrace quiet;
  const Rating::Result r = Rating::evaluate(reducer_with(m, b), quiet);
  return r.u_H1 <= 1.0 && r.u_H2 <= 1.0 && r.u_F1 <= 1.0 && r.u_F2 <= 1.0 && r.x_v <= 10.0;
}

std::vector<double> widths() {
  std::vector<double> all;
  for (const double decade : {1.0, 10.0, 100.0}) {
    for (const double number : r20) all.push_back(decade * number);
  }
  return all;
}

/// The example with other lines for module and width, solved: m_n and b in millimetres.
struct Sized {
  double m = 0.0, b = 0.0;
};
Sized sized_with(const std::string& m_n, const std::string& b) {
  std::string text = Rating::example;
  const auto replace = [&](const std::string& line, const std::string& by) {
    const std::size_t at = text.find(line);
    REQUIRE(at != std::string::npos);
    text.replace(at, line.size(), by);
  };
  replace("m_n = \"4 mm\"", "m_n = \"" + m_n + "\"");
  replace("b = \"48 mm\"", "b = \"" + b + "\"");
  const project::Project project = test::solved_as_found(text);
  return {project.value("teeth.m_n")->si[0] * 1e3, project.value("teeth.b")->si[0] * 1e3};
}

}  // namespace

TEST_SUITE("gear rating sizing") {
  TEST_CASE("a module or a width is the smallest of its stock that passes") {
    const double m = sized_with("?", "48 mm").m, b = sized_with("4 mm", "?").b;
    for (const double smaller : modules) {
      if (smaller < m) CHECK(!carries_with(smaller, 48));
    }
    for (const double smaller : widths()) {
      if (smaller < b * (1.0 - 1e-9)) CHECK(!carries_with(4, smaller));
    }
    CHECK(carries_with(m, 48));
    CHECK(carries_with(4, b));
  }

  TEST_CASE("together they give the pair of least volume in proportion, 6 modules to 1.2 d_1") {
    double least = HUGE_VAL;
    for (const double m : modules) {
      for (const double b : widths()) {
        const bool is_usual = b >= 6.0 * m && b <= 1.2 * 19.0 * m;
        if (is_usual && m * m * b < least && carries_with(m, b)) least = m * m * b;
      }
    }
    const Sized found = sized_with("?", "?");
    CHECK(found.m * found.m * found.b == doctest::Approx(least).epsilon(1e-9));
    CHECK(carries_with(found.m, found.b));
  }
}
