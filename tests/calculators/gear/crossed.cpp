#include "calculators/gear/crossed/crossed.hpp"

#include "calculators/catalogue.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/project/solving/read_project.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace loadpath;
using gear::Crossed;
using test::rel;

constexpr auto solve = test::evaluated<Crossed>;

Crossed::Input gears(int z_1, int z_2, double module, double beta_1, double beta_2) {
  Crossed::Input in;
  in.z_1 = z_1, in.z_2 = z_2;
  in.m_n = module * mm, in.beta_1 = beta_1 * pi / 180, in.beta_2 = beta_2 * pi / 180;
  in.b_1 = in.b_2 = 20.0 * mm;
  in.mu = 0.06, in.T_1 = 10.0 * N_m, in.n_1 = 1000.0 * rpm;
  return in;
}

/// By vectors at the pitch point: shares of the normal force along y and z of each shaft, efficiencies, path of
/// contact.
struct Apart {
  int z_1, z_2;
  double module, beta_1, beta_2;
  double F_y1, F_z1, F_y2, F_z2, eta, eta_b, g_a1, g_a2, slides;
};

bool says(const std::string& lines, const std::string& part) {
  std::vector<Issue> issues;
  project::read_project(
      "[g]\ncalculator = \"gear.crossed\"\nz_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nb_1 = \"20 mm\"\nb_2 = "
      "\"20 mm\"\n" +
          lines,
      "g.toml", catalogue(), issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("gear crossed") {
  TEST_CASE("forces, efficiencies, sliding and path of contact, computed independently by vectors") {
    const Apart all[] = {
        {20, 40, 2, 45, 45, -0.7068894312598676, 0.6220366175174818, -0.6220366175174818, 0.7068894312598676,
         0.8799631031529852, 0.8799631031529855, 5.256699647564629, 5.5124090560097425, 1.4142135623730951},
        {20, 40, 2, -45, -45, -0.7068894312598676, -0.6220366175174818, -0.6220366175174818, -0.7068894312598676,
         0.8799631031529852, 0.8799631031529855, 5.256699647564629, 5.5124090560097425, 1.4142135623730951},
        {15, 24, 3, 20, 30, -0.9035434301590292, 0.2650122475961152, -0.7837976813493739, 0.5218078346200203,
         0.9412611346815128, 0.9420329668747905, 6.793889088170076, 7.532881280375234, 0.8845519308919176},
        {20, 30, 2, 60, 30, -0.5218078346200207, 0.7837976813493737, -0.7837976813493737, 0.5218078346200207,
         0.8672269220464919, 0.8577858144761673, 5.605896653365621, 5.145678358305899, 1.1547005383792515}};
    for (const Apart& row : all) {
      const auto r = solve(gears(row.z_1, row.z_2, row.module, row.beta_1, row.beta_2));
      CHECK(rel(r.F_y1 / r.F_n, row.F_y1) < 1e-12);
      CHECK(rel(r.F_z1 / r.F_n, row.F_z1) < 1e-12);
      CHECK(rel(r.F_y2 / r.F_n, row.F_y2) < 1e-12);
      CHECK(rel(r.F_z2 / r.F_n, row.F_z2) < 1e-12);
      CHECK(rel(r.eta, row.eta) < 1e-12);
      CHECK(rel(r.eta_b, row.eta_b) < 1e-12);
      CHECK(rel(in_si(r.g_a1) * 1e3, row.g_a1) < 1e-9);
      CHECK(rel(in_si(r.g_a2) * 1e3, row.g_a2) < 1e-9);
      CHECK(rel(r.v_s / r.v_1, row.slides) < 1e-12);
      CHECK(rel(r.P_2 / r.P_1, r.eta) < 1e-12);
      CHECK(rel(in_si(r.T_2), in_si(r.T_1) * r.i * r.eta) < 1e-12);
    }
  }

  TEST_CASE("forces on both gears are opposite in space, for all hands and directions") {
    for (const double beta_1 : {45.0, -45.0, 60.0, -20.0, 20.0}) {
      for (const double beta_2 : {30.0, -30.0, 70.0, -70.0}) {
        for (const auto turns : {gear::Turns::ccw, gear::Turns::cw}) {
          auto in = gears(20, 40, 2, beta_1, beta_2);
          in.turns = turns, in.K_A = 1.25;
          const auto r = solve(in);
          const double c = std::cos(r.Sigma), s = std::sin(r.Sigma);
          // y and z of gear 2, seen from gear 1: (-cos, sin) and (sin, cos) of Sigma along y and z.
          const double F_y1 = in_si(r.gear_1.F_y), F_z1 = in_si(r.gear_1.F_z);
          CHECK(std::abs(in_si(r.gear_2.F_y) - (F_y1 * c - F_z1 * s)) < 1e-9 * in_si(r.F_n));
          CHECK(std::abs(in_si(r.gear_2.F_z) + (F_y1 * s + F_z1 * c)) < 1e-9 * in_si(r.F_n));
          CHECK(rel(in_si(r.gear_1.F_x), in_si(r.gear_2.F_x)) < 1e-12);
          CHECK(in_si(r.gear_1.F_x) < 0.0);
          CHECK(in_si(r.gear_1.F_y) * in_si(r.gear_1.n) < 0.0);  // against its rotation
          CHECK(in_si(r.gear_2.F_y) * in_si(r.gear_2.n) > 0.0);  // with it
          CHECK(rel(in_si(r.gear_1.T), 12.5) < 1e-12);
        }
      }
    }
  }

  TEST_CASE("the maximum efficiency of [Spiral-gears] and its neighbours") {
    const double rho = 6 * pi / 180, Sigma = 60 * pi / 180;
    const auto eta = [&](double beta_1) {
      auto in = gears(20, 60, 2, beta_1, 60 - beta_1);
      in.mu = std::tan(rho) * std::cos(pi / 9);
      return solve(in).eta;
    };
    CHECK(rel(eta(33), (std::cos(Sigma + rho) + 1) / (std::cos(Sigma - rho) + 1)) < 1e-12);
    CHECK(eta(32) < eta(33));
    CHECK(eta(34) < eta(33));
  }

  TEST_CASE("diameters, load value and effective face width, by hand") {
    auto in = gears(20, 40, 2, 45, 45);
    in.K_A = 1.25, in.C_adm = 2.0 * MPa, in.x_1 = 0.2;
    const auto r = solve(in);
    const double root = std::sqrt(2.0);
    CHECK(rel(in_si(r.a) * 1e3, 60 * root) < 1e-12);
    CHECK(rel(in_si(r.d_a1) * 1e3, 40 * root + 4.8) < 1e-12);
    CHECK(rel(in_si(r.d_f1) * 1e3, 40 * root - 4.2) < 1e-12);
    CHECK(rel(in_si(r.d_a2) * 1e3, 80 * root + 3.2) < 1e-12);
    CHECK(rel(in_si(r.d_f2) * 1e3, 80 * root - 5.8) < 1e-12);
    const double C = 1.25 * (10 / (0.02 * root)) / (0.02 * pi * 0.002);
    CHECK(rel(in_si(r.C), C) < 1e-12);
    CHECK(rel(r.u_C, C / 2e6) < 1e-12);
    in.b_1 = in.b_2 = 50.0 * mm;
    CHECK(rel(in_si(solve(in).C), C) < 1e-12);  // 10 modules count
    in.b_2 = 10.0 * mm;
    CHECK(rel(in_si(solve(in).C), 2 * C) < 1e-12);
  }

  TEST_CASE("gears lock where the reverse efficiency is zero or less") {
    auto in = gears(20, 40, 2, 75, 15);
    in.locking = Crossed::Locking::required;
    in.mu = std::cos(pi / 9) / std::tan(75 * pi / 180);
    const auto r = solve(in);
    CHECK(std::abs(r.eta_b) < 1e-12);
    CHECK(rel(r.x_L, 1.0) < 1e-12);
    CHECK(r.eta > 0.0);
  }

  TEST_CASE("wrong crossed helical gears are reported with their remedy") {
    const std::string right = "beta_1 = \"45 deg\"\nbeta_2 = \"45 deg\"\nmu = 0.06\n";
    says("beta_1 = \"20 deg\"\nbeta_2 = \"-20 deg\"\nmu = 0.06\n", "use gear.pair for parallel shafts");
    says("beta_1 = \"5 deg\"\nbeta_2 = \"75 deg\"\nmu = 0.3\n", "gear 1 cannot drive gear 2");
    says(right + "T_1 = \"5 N*m\"\nT_2 = \"8 N*m\"\n", "give the load once");
    says(right + "P = \"1 kW\"\n", "a power needs the speed n_1");
    says(right + "C_adm = \"2 MPa\"\n", "the allowable load value C_adm needs a load");
    says(right + "h_fP = 0.9\n", "the dedendum must exceed the addendum");
  }

  TEST_CASE("the figure shows both gears with their dimensions") {
    const auto in = gears(15, 30, 2.0, 35.0, 25.0);
    const auto r = solve(in);
    const std::vector<figure::Figure> figures = Crossed::figures(in, r);
    REQUIRE(figures.size() == 1);
    const figure::Drawing& drawing = *std::get<figure::Drawn>(figures[0].content);
    REQUIRE(drawing.views.size() == 2);
    const auto& lengths = drawing.views[0].lengths;
    REQUIRE(lengths.size() == 3);
    CHECK(rel(lengths[0].to.x - lengths[0].from.x, in_si(r.a)) < 1e-12);
    CHECK(rel(lengths[1].to.y - lengths[1].from.y, in_si(r.d_1)) < 1e-12);
    CHECK(rel(lengths[2].to.x - lengths[2].from.x, in_si(r.d_2)) < 1e-12);
    CHECK(drawing.views[0].forces.size() == 2);
    CHECK(drawing.views[1].angles.at(0).value.si == r.Sigma);
    for (const auto& view : drawing.views) {
      for (const auto& path : view.paths) {
        for (const figure::Point point : path.points) CHECK(std::isfinite(point.x + point.y));
      }
    }
  }
}
