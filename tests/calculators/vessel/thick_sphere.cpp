#include "calculators/vessel/sphere.hpp"
#include "calculators/vessel/thick/sphere.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Hypothesis;
using vessel::Measured;
using vessel::ThickWalledSphere;

/// Radii of 100 and 150 mm.
ThickWalledSphere::Input ball(double p, double p_e) {
  ThickWalledSphere::Input in;
  in.p = p * MPa, in.p_e = p_e * MPa;
  in.R = 100.0 * mm, in.delta = 50.0 * mm, in.measured = Measured::inner;
  in.R_e = 355.0 * MPa, in.S = 1.5, in.E = 210.0 * GPa;
  return in;
}

ThickWalledSphere::Result sphere(const ThickWalledSphere::Input& in) { return solve<ThickWalledSphere>(in); }

}  // namespace

TEST_SUITE("vessel.thick_sphere") {
  TEST_CASE("stresses and displacements of a finite difference solution") {
    // the equation of the radial displacement, 1200 intervals over the wall, nu = 0.3
    const auto inner = sphere(ball(120, 0));
    CHECK(rel(in_si(inner.sigma_ti), 135.7895e6) < 5e-6);
    CHECK(rel(in_si(inner.sigma_ta), 75.78949e6) < 5e-6);
    CHECK(rel(in_si(inner.w_i), 62.4060e-6) < 5e-6);
    CHECK(rel(in_si(inner.w_a), 37.8948e-6) < 5e-6);
    const auto both = sphere(ball(120, 30));
    CHECK(rel(in_si(both.sigma_ti), 71.8422e6) < 5e-6);
    CHECK(rel(in_si(both.w_a), 19.84966e-6) < 5e-6);
  }

  TEST_CASE("the stress in the wall balances the pressures over a great circle") {
    for (const auto& [p, p_e] : {std::pair{120.0, 0.0}, std::pair{120.0, 30.0}, std::pair{0.0, 50.0}}) {
      constexpr int count = 400;
      auto in = ball(p, p_e);
      double sum = 0.0;
      for (int i = 0; i <= count; ++i) {
        const double r = std::min(0.1 + 0.05 * i / count, 0.15), weight = i == 0 || i == count ? 1.0
                                                                          : i % 2 == 1         ? 4.0
                                                                                               : 2.0;
        in.r = r * m;
        sum += weight * 2.0 * pi * r * in_si(sphere(in).sigma_tr);
      }
      CHECK(rel(sum * 0.05 / count / 3.0, pi * 1e6 * (p * 0.01 - p_e * 0.0225)) < 1e-9);
    }
  }

  TEST_CASE("the radial stress is that of the pressures at both surfaces") {
    auto in = ball(120, 30);
    in.r = 100.0 * mm;
    CHECK(rel(in_si(sphere(in).sigma_rr), -120e6) < 1e-12);
    in.r = 150.0 * mm;
    CHECK(rel(in_si(sphere(in).sigma_rr), -30e6) < 1e-12);
    in.r = 151.0 * mm;
    CHECK(!is_set(sphere(in).sigma_rr));
  }

  TEST_CASE("the minimum thickness just reaches the allowable stress, for all pressures, seams and failure theories") {
    for (const auto& [p, p_e] : {std::pair{120.0, 0.0}, std::pair{120.0, 40.0}, std::pair{3.0, 60.0}}) {
      for (const Hypothesis hypothesis : {Hypothesis::tresca, Hypothesis::mises}) {
        auto in = ball(p, p_e);
        in.hypothesis = hypothesis, in.z_l = 0.85, in.z_c = 0.9, in.c = 1.0 * mm;
        in.delta = sphere(in).delta_min;
        CHECK(std::abs(sphere(in).u_v - 1.0) < 1e-9);
      }
    }
  }

  TEST_CASE("Tresca and von Mises agree in a seamless wall; first yield before full plasticity") {
    auto in = ball(120, 0);
    const auto tresca = sphere(in);
    CHECK(rel(120.0 * tresca.S_F, 355.0 * 2.0 / 3.0 * (1.0 - 1.0 / (1.5 * 1.5 * 1.5))) < 1e-12);
    CHECK(rel(in_si(tresca.p_pl), 2.0 * 355e6 * std::log(1.5)) < 1e-12);
    CHECK(tresca.S_pl > tresca.S_F);
    in.hypothesis = Hypothesis::mises;
    CHECK(rel(in_si(sphere(in).sigma_v), in_si(tresca.sigma_v)) < 1e-12);
  }

  TEST_CASE("thick to thin: the stresses of vessel.sphere") {
    auto in = ball(1, 0);
    in.R = 600.0 * mm, in.delta = 3.0 * mm, in.measured = Measured::mean;
    vessel::Sphere::Input thin;
    thin.p = in.p, thin.R = in.R, thin.delta = in.delta, thin.sigma_adm = 200.0 * MPa;
    const auto a = sphere(in);
    const auto b = solve<vessel::Sphere>(thin);
    CHECK(rel(in_si(a.sigma_v), in_si(b.sigma_v)) < 3e-3);  // a quarter of the pressure
    CHECK(rel(in_si(a.sigma_v), in_si(b.sigma_L)) < 1e-12);
  }

  TEST_CASE("wrong input is refused") {
    const std::string step = "calculator = \"vessel.thick_sphere\"\nR = \"30 mm\"\nsigma_adm = \"100 MPa\"\n";
    CHECK(says(step + "p = \"0 MPa\"", "give an internal pressure p or an external pressure p_e"));
    CHECK(says(step + "p = \"9 MPa\"\nhypothesis = \"membrane\"", "a thick wall needs a radial stress"));
    CHECK(messages(step + "p = \"9 MPa\"").empty());
  }
}
