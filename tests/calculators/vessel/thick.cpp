#include "calculators/vessel/cylinder.hpp"
#include "calculators/vessel/thick/cylinder.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Hypothesis;
using vessel::Measured;
using vessel::Thick;
using Ends = Thick::Ends;

/// Radii of 30 and 50 mm.
Thick::Input tube(double p, double p_e) {
  Thick::Input in;
  in.p = p * MPa, in.p_e = p_e * MPa;
  in.R = 30.0 * mm, in.delta = 20.0 * mm, in.measured = Measured::inner;
  in.R_e = 355.0 * MPa, in.S = 1.5;
  in.E = 210.0 * GPa;
  return in;
}

Thick::Result thick(const Thick::Input& in) { return solve<Thick>(in); }

/// The integral of the hoop stress over the wall by Simpson's rule, N/m.
double hoop_force(Thick::Input in) {
  constexpr int count = 400;
  const double R_i = 0.030, h = 0.020 / count;
  double sum = 0.0;
  for (int i = 0; i <= count; ++i) {
    in.r = (R_i + i * h) * m;
    const double weight = i == 0 || i == count ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * in_si(thick(in).sigma_tr);
  }
  return sum * h / 3.0;
}

}  // namespace

TEST_SUITE("vessel.thick") {
  TEST_CASE("the hoop stress over the wall balances the pressures: p R_i - p_e R_a") {
    for (const auto& [p, p_e] : {std::pair{20.0, 0.0}, std::pair{20.0, 5.0}, std::pair{0.0, 30.0}})
      CHECK(rel(hoop_force(tube(p, p_e)), 1e6 * (p * 0.030 - p_e * 0.050)) < 1e-9);
  }

  TEST_CASE("internal and external pressure superpose") {
    const auto both = thick(tube(20, 5)), inner = thick(tube(20, 0)), outer = thick(tube(0, 5));
    for (const auto member : {&Thick::Result::sigma_ti, &Thick::Result::sigma_ta, &Thick::Result::sigma_z})
      CHECK(rel(in_si(both.*member), in_si(inner.*member) + in_si(outer.*member)) < 1e-12);
    CHECK(rel(in_si(both.w_i), in_si(inner.w_i) + in_si(outer.w_i)) < 1e-12);
  }

  TEST_CASE("the radial stress is that of the pressures at both surfaces") {
    Thick::Input in = tube(20, 5);
    in.r = in.R;
    CHECK(rel(in_si(thick(in).sigma_rr), -20e6) < 1e-12);
    in.r = 50.0 * mm;
    CHECK(rel(in_si(thick(in).sigma_rr), -5e6) < 1e-12);
    in.r = 51.0 * mm;
    CHECK(!is_set(thick(in).sigma_rr));  // not in the wall
  }

  TEST_CASE("axial stress: force on the ends, none, or no axial strain") {
    Thick::Input in = tube(20, 5);
    CHECK(rel(in_si(thick(in).sigma_z) * (0.05 * 0.05 - 0.03 * 0.03), 20e6 * 0.03 * 0.03 - 5e6 * 0.05 * 0.05) < 1e-12);
    in.ends = Ends::restrained;
    const auto held = thick(in);
    CHECK(rel(in_si(held.sigma_z), 0.3 * (in_si(held.sigma_ti) - 20e6)) < 1e-12);
    in.ends = Ends::open;
    CHECK(in_si(thick(in).sigma_z) == 0.0);
  }

  TEST_CASE("the minimum thickness just reaches the allowable stress, for all pressures, ends and failure theories") {
    for (const auto& [p, p_e] : {std::pair{40.0, 0.0}, std::pair{40.0, 12.0}, std::pair{3.0, 40.0}}) {
      for (const Ends ends : {Ends::closed, Ends::open, Ends::restrained}) {
        for (const Hypothesis hypothesis : {Hypothesis::tresca, Hypothesis::mises}) {
          Thick::Input in = tube(p, p_e);
          in.ends = ends, in.hypothesis = hypothesis, in.z_l = 0.85, in.z_c = 0.9, in.c = 1.0 * mm;
          in.delta = thick(in).delta_min;
          CAPTURE(in_si(in.p_e));
          CHECK(std::abs(thick(in).u_v - 1.0) < 1e-9);
        }
      }
    }
  }

  TEST_CASE("thick to thin: the stresses of vessel.cylinder within 1 % of its wall at R/t = 200") {
    Thick::Input in = tube(1, 0);
    in.R = 600.0 * mm, in.delta = 3.0 * mm, in.measured = Measured::mean;
    vessel::Cylinder::Input thin;
    thin.p = in.p, thin.R = in.R, thin.delta = in.delta, thin.sigma_adm = 200.0 * MPa;
    const auto a = thick(in);
    const auto b = solve<vessel::Cylinder>(thin);
    CHECK(rel(in_si(a.sigma_v), in_si(b.sigma_v)) < 1e-4);
    CHECK(rel(in_si(a.sigma_v), in_si(b.sigma_L)) < 1e-12);
    CHECK(rel(in_si(a.delta_min), in_si(b.delta_L) * 200.0 / (355.0 / 1.5)) < 0.01);
  }

  TEST_CASE("elastic to plastic: between first yield and full plasticity lies 1/2 (1 - 1/k^2) to ln k, by Tresca") {
    for (const double ratio : {1.05, 1.5, 2.0, 3.0}) {
      Thick::Input in = tube(10, 0);
      in.delta = (ratio - 1.0) * in.R;
      const auto r = thick(in);
      CHECK(rel(10.0 * r.S_F, 355.0 * 0.5 * (1.0 - 1.0 / (ratio * ratio))) < 1e-12);
      CHECK(rel(in_si(r.p_pl), 355e6 * std::log(ratio)) < 1e-12);
      CHECK(r.S_pl > r.S_F);
      in.hypothesis = Hypothesis::mises;  // closed ends: 2/sqrt(3) of Tresca in both
      CHECK(rel(thick(in).S_F, r.S_F * 2.0 / std::sqrt(3.0)) < 1e-12);
      CHECK(rel(thick(in).S_pl, r.S_pl * 2.0 / std::sqrt(3.0)) < 1e-12);
    }
  }

  TEST_CASE("open ends: no plastic limit where the axial stress would not be the middle one") {
    Thick::Input in = tube(20, 0);
    in.ends = Ends::open;
    CHECK(is_set(thick(in).p_pl));
    in.p_e = 5.0 * MPa;
    CHECK(!is_set(thick(in).p_pl));
    in.p_e = 0.0 * MPa, in.delta = 100.0 * mm;
    CHECK(!is_set(thick(in).p_pl));
  }

  TEST_CASE("wrong input is refused") {
    const std::string step = "calculator = \"vessel.thick\"\nR = \"30 mm\"\nsigma_adm = \"100 MPa\"\n";
    CHECK(says(step + "p = \"0 MPa\"", "give an internal pressure p or an external pressure p_e"));
    CHECK(says(step + "p = \"9 MPa\"\nhypothesis = \"membrane\"", "a thick wall needs a radial stress"));
    CHECK(says(step + "p = \"9 MPa\"\nmeasured = \"outer\"\ndelta = \"30 mm\"", "thinner than the radius"));
    CHECK(messages(step + "p = \"9 MPa\"").empty());
  }
}
