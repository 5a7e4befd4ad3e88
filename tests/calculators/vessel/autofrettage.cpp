#include "calculators/vessel/thick/autofrettage.hpp"

#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Autofrettage;
using vessel::Hypothesis;

Autofrettage::Input cylinder(double p, double r_p) {
  Autofrettage::Input in;
  in.p = p * MPa, in.R_i = 50.0 * mm, in.R_a = 100.0 * mm, in.r_p = r_p * mm;
  in.R_e = 850.0 * MPa, in.S = 1.5, in.f_B = 0.7;
  return in;
}

Autofrettage::Result overstrained(const Autofrettage::Input& in) { return solve<Autofrettage>(in); }

/// Hoop and radial stress at the autofrettage pressure by the balance of the wall, integrated from the bore: the
/// plastic zone has a constant difference Y, the elastic ring one that falls with the square of the radius.
double pressure_by_balance(double Y, double R_i, double R_a, double r_p) {
  constexpr int count = 20000;
  double sum = 0.0;
  const double h = (R_a - R_i) / count;
  for (int i = 0; i < count; ++i) {
    const double r = R_i + (i + 0.5) * h;
    sum += (r < r_p ? Y : Y * r_p * r_p / (r * r)) / r * h;
  }
  return sum;
}

}  // namespace

TEST_SUITE("vessel.autofrettage") {
  TEST_CASE("[Hearn-2], recalled: press cylinder of 62.5 and 190 mm, 580 MPa, yield at 850 MPa") {
    Autofrettage::Input in = cylinder(240, 0);
    in.R_i = 62.5 * mm, in.R_a = 190.0 * mm, in.r_p = unset<Length>, in.p_A = 580.0 * MPa;
    const auto r = overstrained(in);
    CHECK(std::abs(in_si(r.sigma_ri) + 451e6) < 0.5e6);
    CHECK(std::abs(in_si(r.sigma_ti) + 152.7e6) < 0.5e6);
  }

  TEST_CASE("von Mises: residual stresses of an elastic-plastic finite element model") {
    // plane strain, nu = 0.49, 160 elements over the wall, radial return, loaded to 580.5273 MPa and unloaded
    Autofrettage::Input in = cylinder(300, 70);
    in.hypothesis = Hypothesis::mises;
    const auto r = overstrained(in);
    CHECK(rel(in_si(r.p_A), 580.5273e6) < 1e-6);
    CHECK(rel(in_si(r.sigma_ri), -566.578e6) < 2e-4);  // extrapolated from the elements next to it
    CHECK(rel(in_si(r.sigma_rp), 142.77e6) < 2e-3);
    CHECK(rel(in_si(r.sigma_ra), 93.913e6) < 2e-4);
  }

  TEST_CASE("the autofrettage pressure balances the stresses of the wall") {
    for (const double r_p : {55.0, 70.0, 90.0, 100.0}) {
      const auto r = overstrained(cylinder(300, r_p));
      CHECK(rel(in_si(r.p_A), pressure_by_balance(850e6, 50.0, 100.0, r_p)) < 1e-4);
    }
  }

  TEST_CASE("pressure and radius are inverse to each other") {
    for (const double r_p : {51.0, 70.0, 99.0}) {
      Autofrettage::Input in = cylinder(300, r_p);
      const auto by_radius = overstrained(in);
      in.r_p = unset<Length>, in.p_A = by_radius.p_A;
      CHECK(rel(in_si(overstrained(in).r_p), r_p * 1e-3) < 1e-9);
      in.p_A = unset<Stress>, in.w = by_radius.w;
      CHECK(rel(in_si(overstrained(in).p_A), in_si(by_radius.p_A)) < 1e-12);
    }
  }

  TEST_CASE("from first yield to full plasticity, and no residual stress at first yield") {
    const auto least = overstrained(cylinder(300, 50.0 * (1.0 + 1e-9)));
    CHECK(rel(in_si(least.p_A), 850e6 * 0.375) < 1e-8);
    CHECK(std::abs(in_si(least.sigma_ri)) < 10.0);
    const auto full = overstrained(cylinder(300, 100));
    CHECK(rel(in_si(full.p_A), 850e6 * std::log(2.0)) < 1e-12);
    CHECK(full.w == 1.0);
  }

  TEST_CASE("at the autofrettage pressure the plastic zone yields again") {
    auto in = cylinder(0, 70);
    in.p = overstrained(cylinder(300, 70)).p_A;
    const auto r = overstrained(in);
    CHECK(rel(in_si(r.sigma_v), 850e6) < 1e-12);
    CHECK(rel(in_si(r.sigma_ti), 850e6 - in_si(in.p)) < 1e-12);
    in.p = 1.01 * in.p;
    CHECK(!is_set(overstrained(in).sigma_v));
    CHECK(overstrained(in).u_p > 1.0);
  }

  TEST_CASE("r_opt has the smallest equivalent stress in service") {
    const auto best = overstrained(cylinder(300, 70));
    const double r_opt = in_si(best.r_opt) * 1e3;
    const auto at = [](double r_p) { return in_si(overstrained(cylinder(300, r_p)).sigma_v); };
    CHECK(at(r_opt) < at(r_opt * 0.97));
    CHECK(at(r_opt) < at(r_opt * 1.03));
  }

  TEST_CASE("reverse yielding begins at twice the pressure of first yield, without a Bauschinger effect") {
    Autofrettage::Input in = cylinder(300, 0);
    in.R_a = 200.0 * mm, in.r_p = unset<Length>, in.f_B = 1.0;
    in.p_A = 2.0 * 850.0 * MPa * 0.5 * (1.0 - 1.0 / 16.0);
    CHECK(rel(overstrained(in).u_B, 1.0) < 1e-12);
    in.hypothesis = Hypothesis::mises, in.p_A *= 2.0 / std::sqrt(3.0);
    CHECK(rel(overstrained(in).u_B, 1.0) < 1e-12);
  }

  TEST_CASE("wrong input is refused") {
    const std::string step =
        "calculator = \"vessel.autofrettage\"\np = \"300 MPa\"\nR_i = \"50 mm\"\nR_a = \"100 mm\"\nR_e = \"850 MPa\"\n";
    CHECK(says(step, "give one of the autofrettage pressure"));
    CHECK(says(step + "p_A = \"318 MPa\"", "first yield is at"));
    CHECK(says(step + "p_A = \"590 MPa\"", "full plasticity at"));
    CHECK(says(step + "p_A = \"=590 MPa\"", "full plasticity at"));
    CHECK(says(step + "r_p = \"101 mm\"", "at most R_a"));
    CHECK(says(step + "r_p = \"60 mm\"\nw = 0.3", "give one of"));
    CHECK(says(step + "r_p = \"60 mm\"\nends = \"open\"\nhypothesis = \"mises\"", "von Mises is for closed ends"));
    CHECK(messages(step + "r_p = \"60 mm\"\nends = \"open\"").empty());
  }
}
