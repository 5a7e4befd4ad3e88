#include "calculators/machine/disc.hpp"

#include "tests/calculators/step_text.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using machine::Disc;

/// Steel, 500 mm in diameter, with a bore of 100 mm, at 6000 rpm.
Disc::Input steel(double d_i = 100.0) {
  Disc::Input in;
  in.n = 6000.0 * rpm, in.D = 500.0 * mm, in.d_i = d_i * mm, in.b = 40.0 * mm;
  in.rho = 7850.0 * kg_per_m3, in.nu = 0.3, in.E = 210.0 * GPa, in.R_e = 450.0 * MPa, in.S = 2.0;
  return in;
}

Disc::Result disc(const Disc::Input& in) {
  NoTrace off;
  return Disc::evaluate(in, off);
}

double rel(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }

}  // namespace

TEST_SUITE("machine.disc") {
  TEST_CASE("[Hearn-2], recalled: a ring of 450 mm shrunk on a disc of 300 mm comes loose at 3000 rpm by 0.045 mm") {
    Disc::Input ring = steel(300), core = steel(0);
    for (Disc::Input* in : {&ring, &core}) in->n = 3000.0 * rpm, in->rho = 7470.0 * kg_per_m3, in->E = 207.0 * GPa;
    ring.D = 450.0 * mm, core.D = 300.0 * mm;
    const double gap = 2.0 * in_si(disc(ring).w_i - disc(core).w_a);
    CHECK(std::abs(gap - 0.045e-3) < 0.5e-6);
    // the pressure that this interference makes at rest, of one material: 8.55 MPa
    CHECK(std::abs(gap / 0.3 * 207e9 * (1.0 - 1.0 / (1.5 * 1.5)) / 2.0 - 8.55e6) < 0.01e6);
  }

  TEST_CASE("[Shigley-3], recalled: a ring of 6 and 10 inches, 30 kpsi, yields at 13000 rpm") {
    Disc::Input in = steel();
    in.d_i = 152.4 * mm, in.D = 254.0 * mm, in.b = 38.1 * mm, in.nu = 0.292;
    in.rho = 7806.0 * kg_per_m3;  // 0.282 lbf/in^3
    in.R_e = 206.84 * MPa;
    const auto r = disc(in);
    CHECK(std::abs(in_si(r.n_F) - 1361.0) < 0.5);
    CHECK(std::abs(in_si(r.n_F) * 30.0 / pi - 13000.0) < 50.0);
  }

  TEST_CASE("stresses and growth of a finite difference solution") {
    // the equation of the radial displacement, 1200 intervals
    const auto hollow = disc(steel());
    CHECK(rel(in_si(hollow.sigma_ti), 161.1548e6) < 1e-4);
    CHECK(rel(in_si(hollow.sigma_ta), 40.28795e6) < 1e-4);
    CHECK(rel(in_si(hollow.sigma_rm), 51.1339e6) < 1e-4);
    CHECK(rel(in_si(hollow.w_i), 38.3702e-6) < 1e-4);
    CHECK(rel(in_si(hollow.w_a), 47.9618e-6) < 1e-4);
    const auto solid = disc(steel(0));
    CHECK(rel(in_si(solid.sigma_ti), 79.8974e6) < 1e-4);
    CHECK(rel(in_si(solid.sigma_ta), 33.8959e6) < 1e-4);
    CHECK(rel(in_si(solid.w_a), 40.3523e-6) < 1e-4);
    Disc::Input in = steel();
    in.form = Disc::Form::cylinder, in.b = 2.0 * m;
    const auto rotor = disc(in);
    CHECK(rel(in_si(rotor.sigma_ti), 167.133e6) < 1e-4);
    CHECK(rel(in_si(rotor.sigma_ta), 34.3113e6) < 1e-4);
    CHECK(rel(in_si(rotor.sigma_zm), 19.9241e6) < 1e-4);
    CHECK(rel(in_si(rotor.w_i), 38.3704e-6) < 1e-4);
    CHECK(rel(in_si(rotor.w_a), 47.9619e-6) < 1e-4);
  }

  TEST_CASE("the hoop stress balances the centrifugal force of half a body; full plasticity follows from it") {
    for (const auto form : {Disc::Form::disc, Disc::Form::cylinder}) {
      for (const double d_i : {0.0, 100.0, 400.0}) {
        constexpr int count = 2000;
        Disc::Input in = steel(d_i);
        in.form = form;
        const double low = 0.5e-3 * d_i, h = (0.25 - low) / count;
        double sum = 0.0;
        for (int i = 0; i <= count; ++i) {
          in.r = std::min(low + i * h, 0.25) * m;
          sum += (i == 0 || i == count ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * in_si(disc(in).sigma_tr) * h / 3.0;
        }
        const auto r = disc(in);
        const double q = 7850.0 * std::pow(200.0 * pi, 2);
        CHECK(rel(sum, q * (std::pow(0.25, 3) - std::pow(low, 3)) / 3.0) < 1e-6);
        CHECK(rel(450e6 * (0.25 - low), sum * std::pow(in_si(r.n_pl) / (200.0 * pi), 2)) < 1e-6);
        CHECK(r.n_pl > r.n_F);
      }
    }
  }

  TEST_CASE("a pinhole doubles the stress of a solid disc; a thin ring has that of its circumferential speed") {
    CHECK(rel(in_si(disc(steel(1e-3)).sigma_ti), 2.0 * in_si(disc(steel(0)).sigma_ti)) < 1e-9);
    const auto ring = disc(steel(499.9999));
    CHECK(rel(in_si(ring.sigma_ti), 7850.0 * std::pow(in_si(ring.v_a), 2)) < 1e-6);
    CHECK(rel(in_si(ring.sigma_ta), in_si(ring.sigma_ti)) < 1e-6);
  }

  TEST_CASE("the radial stress is largest at the mean radius and vanishes at both edges") {
    Disc::Input in = steel();
    in.r = std::sqrt(0.05 * 0.25) * m;
    CHECK(rel(in_si(disc(in).sigma_rr), in_si(disc(in).sigma_rm)) < 1e-12);
    in.r = 50.0 * mm;
    CHECK(std::abs(in_si(disc(in).sigma_rr)) < 1.0);
    CHECK(rel(in_si(disc(in).sigma_tr), in_si(disc(in).sigma_ti)) < 1e-12);
    in.r = 250.0 * mm;
    CHECK(std::abs(in_si(disc(in).sigma_rr)) < 1.0);
    CHECK(rel(in_si(disc(in).sigma_tr), in_si(disc(in).sigma_ta)) < 1e-12);
  }

  TEST_CASE("a thick disc is not in plane stress, and a speed is needed") {
    const test::ExampleStep thick("machine.disc", "b = \"200 mm\"");
    CHECK(thick.verdict("x_b") == account::State::not_covered);
    const test::ExampleStep rotor("machine.disc", "b = \"200 mm\"\nform = \"cylinder\"");
    CHECK(rotor.fault().empty());
    CHECK(!test::ExampleStep("machine.disc", "n = \"0 rpm\"").fault().empty());
  }
}
