// Misalignment of the teeth across a face: against the unit-load method with shear in an independent program, closed
// forms, and the formula of DIN 3990-11 for a pinion between its bearings.
#include "calculators/shaft/design/design.hpp"
#include "lib/quantity/fit_units.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using shaft::Design;
using shaft::Holds;
using shaft::Seated;
using test::rel;

constexpr double alpha = pi / 9.0;

/// 4 kN tangential on a pinion of a 60 mm working circle and a 40 mm face at `x`, on a shaft of 40 mm with bearings at
/// 20 mm and `right`; the coupling is on the left end, or on the right.
Design::Input pinion_shaft(double x, double right = 220.0, bool from_left = true) {
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa, in.R_e = 500.0 * MPa;
  in.pieces.push_back({{}, 240.0 * mm, 40.0 * mm});
  in.supports.push_back({{}, 20.0 * mm, Holds::both});
  in.supports.push_back({{}, right * mm});
  shaft::Seat pinion, coupling;
  pinion.x = x * mm, pinion.T = 120.0 * N_m, pinion.x_w = 30.0 * mm, pinion.b_r = 40.0 * mm;
  pinion.F_y = 4000.0 * N, pinion.F_x = -4000.0 * std::tan(alpha) * N, pinion.kind = Mounted::gear;
  coupling.x = (from_left ? 0.0 : 240.0) * mm, coupling.T = 120.0 * N_m, coupling.way = shaft::Way::drives;
  in.seats.push_back(pinion);
  in.seats.push_back(coupling);
  return in;
}

Seated pinion_of(const Design::Input& in) { return test::evaluated<Design>(in).seats[0]; }

void check(const Seated& s, double delta_b, double delta_t, double delta_s) {
  const double most = 1e-8 * (std::abs(delta_b) + std::abs(delta_t) + delta_s);
  CHECK(std::abs(s.delta_b / um - delta_b) < most);
  CHECK(std::abs(s.delta_t / um - delta_t) < most);
  CHECK(std::abs(s.delta_s / um - delta_s) < most);
  CHECK(std::abs(s.f_sh / um - (std::abs(delta_b + delta_t) + delta_s)) < most);
}

}  // namespace

TEST_SUITE("shaft design") {
  TEST_CASE("misalignment of a pinion: bending and twist add where the torque enters at the near end") {
    check(pinion_of(pinion_shaft(80.0)), 7.51795915, 3.323482791, 1.719380677);
    check(pinion_of(pinion_shaft(80.0, 220.0, false)), 7.51795915, -3.323482791, 1.719380677);
    check(pinion_of(pinion_shaft(160.0)), -7.51795915, 3.323482791, 1.719380677);
  }

  TEST_CASE("midway between its bearings a pinion is not tilted by bending; overhung it is, most of all") {
    check(pinion_of(pinion_shaft(120.0)), 0.0, 3.323482791, 1.977467005);
    check(pinion_of(pinion_shaft(200.0, 150.0)), 23.49982634, 3.323482791, 0.364427454);
  }

  TEST_CASE("a face across a shoulder follows both segments") {
    Design::Input in = pinion_shaft(80.0);
    in.pieces.clear();
    in.pieces.push_back({{}, 90.0 * mm, 36.0 * mm});
    in.pieces.push_back({{}, 150.0 * mm, 44.0 * mm});
    check(pinion_of(in), 5.552775176, 5.06551256, 2.326143056);
  }

  TEST_CASE("bending turns the face of a thin shaft by F a c (c - a) / (3 E I l), twist by F r_b b / (2 G I_p)") {
    Design::Input in = pinion_shaft(80.0);
    in.seats[0].b_r = 0.1 * mm;  // a face so narrow that the slope is even along it, and shear alike on both sides
    const double F = 4000.0 / std::cos(alpha), a = 60.0, c = 140.0, I = pi * std::pow(40.0, 4) / 64.0;
    const double slope = F * a * c * (c - a) / (3.0 * 210e3 * I * 200.0);
    const double shear = F * (c - a) / 200.0 / 2.0 / (81e3 * pi * 400.0 * 6 * (1 + 0.2962963) / (7 + 6 * 0.2962963));
    CHECK(rel(pinion_of(in).delta_b / mm, 0.1 * (slope + shear)) < 1e-5);
    const double r_b = 30.0 * std::cos(alpha);
    CHECK(rel(pinion_of(in).delta_t / mm, r_b * 120e3 * 0.1 / (2.0 * 81e3 * 2.0 * I)) < 1e-9);
  }

  TEST_CASE("near the middle bending and twist are those of the formula of method C") {
    constexpr double l = 200.0, b = 30.0, d_1 = 60.0;
    Design::Input in = pinion_shaft(110.0);  // 10 mm from the middle
    in.seats[0].b_r = b * mm;
    const double w_m = 4000.0 / b, K_p = 0.8;
    const double bending = 0.023 * w_m * K_p * l * 10.0 / (d_1 * d_1) * std::pow(d_1 / 40.0, 4) * b * b / (d_1 * d_1);
    CHECK(pinion_of(in).delta_b / um < bending);
    CHECK(pinion_of(in).delta_b / um > 0.9 * bending);
    in.pieces[0].d = d_1 * mm;  // of the formula 0.7: the torsion of a solid pinion
    const double twist = 0.7 * 0.023 * w_m * b * b / (d_1 * d_1);
    CHECK(rel(pinion_of(in).delta_t / um, twist) < 0.1);
  }

  TEST_CASE("a stiff shaft keeps the teeth aligned") {
    Design::Input in = pinion_shaft(80.0);
    const double soft = pinion_of(in).f_sh / um;
    in.E *= 1e6, in.G *= 1e6;
    CHECK(rel(pinion_of(in).f_sh / um, 1e-6 * soft) < 1e-6);
    in = pinion_shaft(80.0);
    in.pieces[0].d = 400.0 * mm;
    CHECK(pinion_of(in).f_sh / um < 0.02 * soft);
  }

  TEST_CASE("misalignment does not depend on the direction of the mate, and includes K_A once") {
    Design::Input in = pinion_shaft(80.0);
    for (const double angle : {0.4, 2.0, 3.7, 5.5}) {
      in.seats[0].angle = angle;
      check(pinion_of(in), 7.51795915, 3.323482791, 1.719380677);
    }
    in.K_A = 1.75;
    check(pinion_of(in), 1.75 * 7.51795915, 1.75 * 3.323482791, 1.75 * 1.719380677);
  }

  TEST_CASE("a gear that drives its shaft is misaligned like one that is driven, with the twist from the other end") {
    Design::Input in = pinion_shaft(80.0, 220.0, false);
    in.seats[0].way = shaft::Way::drives, in.seats[1].way = shaft::Way::takes;
    check(pinion_of(in), 7.51795915, -3.323482791, 1.719380677);
  }

  TEST_CASE("teeth twist with the body of their gear, not with the thinner shaft in its hub") {
    Design::Input in = pinion_shaft(80.0);
    in.seats[0].d_f = 52.5 * mm;
    check(pinion_of(in), 7.51795915, 3.323482791 * std::pow(40.0 / 52.5, 4), 1.719380677);
    in.seats[0].d_f = 36.0 * mm;  // no gear is softer than the shaft
    check(pinion_of(in), 7.51795915, 3.323482791, 1.719380677);
  }

  TEST_CASE("only the face width of a gear counts: not that of its hub, nor pulleys") {
    Design::Input in = pinion_shaft(80.0);
    in.seats[0].b = 60.0 * mm;
    check(pinion_of(in), 7.51795915, 3.323482791, 1.719380677);
    in.seats[0].b_r = unset<Length>;
    CHECK(!is_set(pinion_of(in).f_sh));
    in = pinion_shaft(80.0);
    in.seats[0].kind = Mounted::pulley;
    CHECK(!is_set(pinion_of(in).f_sh));
    in = pinion_shaft(80.0);
    in.seats[0].F_x = in.seats[0].F_y = 0.0 * N;
    CHECK(!is_set(pinion_of(in).f_sh));
  }

  TEST_CASE("beyond the end of the shaft a face is straight") {
    Design::Input in = pinion_shaft(230.0, 180.0);
    const Seated wide = pinion_of(in);  // from 210 mm to 250 mm, the shaft ends at 240 mm
    in.pieces[0].l = 300.0 * mm;
    const Seated within = pinion_of(in);
    CHECK(std::isfinite(wide.f_sh / um));
    CHECK(rel(wide.delta_b, within.delta_b) < 1e-3);
  }
}
