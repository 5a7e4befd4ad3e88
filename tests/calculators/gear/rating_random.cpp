// gear.rating over 20 000 random pairs: laws that hold for every pair, in parts that together take less than a second.
#include "calculators/gear/rating/rating.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using namespace loadpath::test;
using In = Rating::Input;
using Out = Rating::Result;

class Pairs {
 public:
  explicit Pairs(unsigned seed) : random_(seed) {}
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }

  /// A pair that keeps the rules, loaded by more than 100 N/mm (below, factors leap), of any material.
  In next() {
    In in;
    const double m = between(1.5, 10);
    in.m_n = m * mm, in.z_1 = 18 + static_cast<int>(between(0, 25)), in.z_2 = 40 + static_cast<int>(between(0, 80));
    in.beta = between(0, 1) < 0.4 ? 0.0 : between(5, 25) * deg.one, in.b = m * between(6, 14) * mm;
    in.x_1 = between(0, 0.4), in.x_2 = between(-0.2, 0.2), in.shortening = Shortening::none;
    in.T_1 = between(120, 600) * (in.b / mm) * m * static_cast<double>(in.z_1) / 2000.0 * N_m;
    in.n_1 = between(50, 600) * rpm, in.K_A = between(1, 2), in.grade = 6 + static_cast<int>(between(0, 4));
    in.place = gear::Place::middle, in.finish = Finish::ground, in.R_z1 = in.R_z2 = between(2, 10) * um;
    in.nu_40 = between(50, 400) * mm2_per_s;
    give_material(in);
    if (between(0, 1) < 0.5) in.L_h = std::pow(10.0, between(-1, 5)) * hour;
    if (between(0, 1) < 0.5) in.standard = RatingStandard::iso6336;
    return in;
  }

 private:
  void give_material(In& in) {
    const StrengthLine& line =
        strength_lines[static_cast<std::size_t>(between(0, static_cast<double>(strength_lines.size()) - 1e-9))];
    in.material_1 = in.material_2 = line.material, in.quality_1 = in.quality_2 = line.quality;
    in.H_1 = in.H_2 = between(line.low, line.high);
  }
  std::mt19937_64 random_;
};

Out result_of(const In& in) {
  NoTrace quiet;
  return Rating::evaluate(in, quiet);
}

std::array<double, 4> safeties_of(const Out& r) { return {r.S_H1, r.S_H2, r.S_F1, r.S_F2}; }

/// How many of the four safety factors of `worse` exceed those of `r`.
int rises(const Out& worse, const Out& r) {
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) count += safeties_of(worse)[i] > safeties_of(r)[i] * (1.0 + 1e-9) ? 1 : 0;
  return count;
}

}  // namespace

TEST_SUITE("gear rating of random pairs") {
  TEST_CASE("every pair has finite factors of at least 1, stresses and safety factors above 0") {
    Pairs pairs(61);
    int faults = 0;
    for (int i = 0; i < 8000; ++i) {
      const Out r = result_of(pairs.next());
      for (const double K : {r.K_V, r.K_Hbeta, r.K_Fbeta1, r.K_Fbeta2, r.K_Halpha, r.K_Falpha})
        faults += std::isfinite(K) && K >= 1.0 - 1e-12 ? 0 : 1;
      for (const double S : safeties_of(r)) faults += std::isfinite(S) && S > 0.0 ? 0 : 1;
      faults +=
          r.sigma_H1 >= r.sigma_H0 && r.sigma_F1 >= r.sigma_F01 && r.K_Fbeta1 <= r.K_Hbeta * (1.0 + 1e-12) ? 0 : 1;
    }
    CHECK(faults == 0);
  }

  TEST_CASE("more torque and a longer life raise no safety factor") {
    Pairs pairs(62);
    int faults = 0;
    for (int i = 0; i < 4000; ++i) {
      const In in = pairs.next();
      const Out r = result_of(in);
      In more = in, longer = in;
      more.T_1 = pairs.between(1.05, 2) * in.T_1;
      longer.L_h = 2.0 * in.L_h;
      faults += rises(result_of(more), r) + rises(result_of(longer), r);
    }
    CHECK(faults == 0);
  }

  TEST_CASE("harder flanks raise the limits of contact; a better quality lowers no limit") {
    Pairs pairs(63);
    int faults = 0;
    for (int i = 0; i < 2000; ++i) {
      In in = pairs.next();
      in.L_h = unset<Time>, in.standard = RatingStandard::din3990;
      const StrengthLine* const line = strength_line(in.material_1, in.quality_1, in.H_1);
      REQUIRE(line != nullptr);
      const Out r = result_of(in);
      In harder = in;
      harder.H_1 = harder.H_2 = line->high;
      const Out s = result_of(harder);
      faults += s.sigma_HG1 >= r.sigma_HG1 && s.sigma_FG1 >= r.sigma_FG1 ? 0 : 1;
      In better = in;
      better.quality_1 = better.quality_2 = Quality::ME;
      if (strength_line(in.material_1, Quality::ME, in.H_1) == nullptr) continue;
      faults += result_of(better).sigma_HG1 >= r.sigma_HG1 ? 0 : 1;
    }
    CHECK(faults == 0);
  }

  TEST_CASE("a coarser grade lowers no load factor of DIN 3990-11, and raises no safety factor") {
    Pairs pairs(64);
    int faults = 0;
    for (int i = 0; i < 2000; ++i) {
      In in = pairs.next();
      in.standard = RatingStandard::din3990;
      const Out r = result_of(in);
      In coarser = in;
      coarser.grade = static_cast<int>(in.grade) + 1;
      const Out s = result_of(coarser);
      faults += rises(s, r) + (s.K_V >= r.K_V && s.K_Hbeta >= r.K_Hbeta && s.K_Halpha >= r.K_Halpha ? 0 : 1);
    }
    CHECK(faults == 0);
  }

  TEST_CASE("a wider pair with the same load has lower nominal stresses, by the width at the root and at the flank") {
    Pairs pairs(65);
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
      In in = pairs.next();
      in.beta = 0.0;  // the overlap of helical teeth changes factors too
      In wider = in;
      wider.b = 1.44 * in.b;
      const Out r = result_of(in), s = result_of(wider);
      worst = std::max({worst, rel(s.sigma_H0 * 1.2, r.sigma_H0), rel(s.sigma_F01 * 1.44, r.sigma_F01)});
    }
    CHECK(worst < 1e-12);
  }

  TEST_CASE("equal gears have the same stresses and safety factors") {
    Pairs pairs(66);
    double worst = 0.0;
    for (int i = 0; i < 1500; ++i) {
      In in = pairs.next();
      in.z_2 = in.z_1, in.x_2 = in.x_1;
      const Out r = result_of(in);
      worst = std::max(
          {worst, rel(r.S_H1, r.S_H2), rel(r.S_F1, r.S_F2), rel(r.sigma_H1, r.sigma_H2), rel(r.sigma_F1, r.sigma_F2)});
    }
    CHECK(worst < 1e-9);
  }

  TEST_CASE("a stiff pinion with perfect helices is loaded evenly: K_Hbeta tends to 1 as the width tends to 0") {
    Pairs pairs(67);
    for (int i = 0; i < 500; ++i) {
      In in = pairs.next();
      in.standard = RatingStandard::din3990, in.f_ma = 0.0 * um, in.L_h = unset<Time>;
      double before = HUGE_VAL;
      for (const double share : {1.0, 0.1, 0.01}) {  // of the width, at the same line load
        In at = in;
        at.b = share * in.b, at.T_1 = share * in.T_1;
        const double K = result_of(at).K_Hbeta;
        CHECK(K <= before);
        before = K;
      }
      CHECK(before - 1.0 < 1e-4);
    }
  }
}
