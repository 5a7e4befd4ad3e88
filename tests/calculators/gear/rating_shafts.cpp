// The face load factor of gear.rating from the elastic lines of both shafts, in place of the formula of method C.
#include "calculators/gear/rating/rating.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using test::rel;
using In = Rating::Input;

constexpr auto rate = test::evaluated<Rating>;

In reducer_on_shafts(RatingStandard standard) {
  In in;
  in.standard = standard, in.m_n = 4.0 * mm, in.z_1 = 19, in.z_2 = 104, in.b = 48.0 * mm, in.K_A = 1.25;
  in.x_1 = 0.5, in.x_2 = 0.15, in.rho_fP = 0.25, in.T_1 = 400.0 * N_m, in.n_1 = 980.0 * rpm, in.grade = 6;
  in.R_z1 = in.R_z2 = 5.0 * um, in.nu_40 = 150.0 * mm2_per_s;
  in.material_1 = in.material_2 = GearMaterial::case_hardened;
  in.sigma_Hlim_1 = in.sigma_Hlim_2 = 1500.0 * MPa, in.sigma_Flim_1 = in.sigma_Flim_2 = 430.0 * MPa;
  return in;
}

In on_bearings(In in) {
  in.place = gear::Place::a, in.l = 200.0 * mm, in.s = 40.0 * mm, in.d_sh = 55.0 * mm;
  return in;
}

bool holds_all(const In& in) {
  return std::all_of(Rating::rules.begin(), Rating::rules.end(),
                     [&](const auto& rule) { return rule.only_warns || rule.holds(in); });
}

constexpr std::array both{RatingStandard::din3990, RatingStandard::iso6336};

}  // namespace

TEST_SUITE("gear rating") {
  TEST_CASE("the deflection of the shafts replaces the formula: with its value, all factors are those of the formula") {
    for (const RatingStandard standard : both) {
      In in = reducer_on_shafts(standard);
      const auto formula = rate(on_bearings(in));
      in.f_sh_1 = 0.75 * formula.f_sh / formula.K_V, in.f_sh_2 = 0.25 * formula.f_sh / formula.K_V;
      CHECK(holds_all(in));
      const auto shafts = rate(in);
      CHECK(rel(shafts.f_sh, formula.f_sh) < 1e-14);
      CHECK(rel(shafts.K_Hbeta, formula.K_Hbeta) < 1e-14);
      CHECK(rel(shafts.S_H1, formula.S_H1) < 1e-14);
      CHECK(rel(shafts.S_F2, formula.S_F2) < 1e-14);
    }
  }

  TEST_CASE("both deflections add up in magnitude, under the dynamic load; K_A is in them already") {
    for (const RatingStandard standard : both) {
      In in = reducer_on_shafts(standard);
      in.f_sh_1 = 7.0 * um, in.f_sh_2 = 3.0 * um;
      const auto r = rate(in);
      CHECK(rel(r.f_sh / um, 10.0 * r.K_V) < 1e-14);
      in.f_sh_2 = unset<Length>;
      CHECK(rel(rate(in).f_sh / um, 7.0 * r.K_V) < 1e-14);
      in.K_A = 1.5;
      const auto other = rate(in);
      CHECK(rel(other.f_sh / um, 7.0 * other.K_V) < 1e-14);
    }
  }

  TEST_CASE("on stiff shafts the face load factor is that of the manufacturing deviations") {
    In in = reducer_on_shafts(RatingStandard::din3990);
    in.f_sh_1 = in.f_sh_2 = 0.0 * um, in.f_ma = 12.0 * um;
    const auto r = rate(in);
    const double w_m = r.F_t / N * 1.25 * r.K_V / 48.0;
    CHECK(rel(r.K_Hbeta, 1 + 10 * 0.85 * 12 / w_m) < 1e-13);
    in.standard = RatingStandard::iso6336;
    const auto iso = rate(in);
    CHECK(rel(iso.F_betax / um, 12.0) < 1e-13);
    double last = HUGE_VAL;
    for (const double f_sh : {20.0, 5.0, 1.0, 1e-3, 1e-9}) {
      in.f_sh_1 = f_sh * um;
      const double K = rate(in).K_Hbeta;
      CHECK(K < last);
      CHECK(K > iso.K_Hbeta);
      last = K;
    }
    CHECK(rel(last, iso.K_Hbeta) < 1e-9);
  }

  TEST_CASE("crowned teeth follow the deflection with the share of the standard") {
    In in = reducer_on_shafts(RatingStandard::din3990);
    in.f_sh_1 = 10.0 * um, in.crowning = Crowning::crowned;
    const auto r = rate(in);
    CHECK(rel(r.f_sh / um, 0.012 / 0.023 * 10.0 * r.K_V) < 1e-14);
    in.crowning = Crowning::end_relief;
    CHECK(rel(rate(in).f_sh / um, 0.016 / 0.023 * 10.0 * r.K_V) < 1e-14);
    in = reducer_on_shafts(RatingStandard::iso6336);
    in.f_sh_1 = 10.0 * um, in.f_ma = 40.0 * um, in.crowning = Crowning::crowned;
    const auto iso = rate(in);
    CHECK(rel(iso.F_betax / um, 0.5 * (1.33 * 10.0 * iso.K_V + 40.0)) < 1e-13);
  }

  TEST_CASE("under a load spectrum the shafts deflect in proportion to the torque of each block") {
    In in = reducer_on_shafts(RatingStandard::iso6336);
    in.f_sh_1 = 12.0 * um, in.f_sh_2 = 4.0 * um, in.L_h = 5000.0 * hour;
    In half = in;
    half.T_1 *= 0.5, half.f_sh_1 *= 0.5, half.f_sh_2 *= 0.5;
    in.blocks.push_back({{}, 0.4});
    in.blocks.push_back({{}, 0.6, 0.5});
    const auto r = rate(in);
    CHECK(rel(r.blocks[0].K_Hbeta, r.K_Hbeta) < 1e-14);
    CHECK(rel(r.blocks[1].K_Hbeta, rate(half).K_Hbeta) < 1e-14);
  }

  TEST_CASE("a position and the deflection of the shafts exclude each other, and one of them is needed") {
    In in = reducer_on_shafts(RatingStandard::din3990);
    CHECK(!holds_all(in));
    in.f_sh_2 = 3.0 * um;
    CHECK(!holds_all(in));
    in.f_sh_1 = 7.0 * um;
    CHECK(holds_all(in));
    in.place = gear::Place::middle;
    CHECK(!holds_all(in));
    in.place = gear::Place::untold, in.l = 200.0 * mm;
    CHECK(!holds_all(in));
    in.l = unset<Length>, in.stiffening = Stiffening::pinion;
    CHECK(!holds_all(in));
  }

  TEST_CASE("a typed deflection below that of a pinion midway between its bearings needs a reason") {
    // 2 x 400 N m / 76 mm x 1.25 / 48 mm x 0.023 x (48/76)^2 = 2.51 um
    const std::string shafts = "place = \nf_sh_1 = \"";
    CHECK(test::mode_with("gear.rating", shafts + "2.6 um\"", "pitting_1") == "pass");
    CHECK(test::mode_with("gear.rating", shafts + "2.4 um\"", "pitting_1") == "not-judged");
    CHECK(test::mode_with("gear.rating", shafts + "2.4 um\"\nbecause.f_sh_1 = \"measured\"", "pitting_1") == "pass");
  }
}
