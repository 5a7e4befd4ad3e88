// gear.rating under a load spectrum by ISO 6336-6: damage sums against the plain rating of every block on its own.
#include "calculators/gear/rating/rating.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/calculators/step_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using namespace loadpath::test;
using In = Rating::Input;

Rating::Result rated_under(const In& in) {
  for (const auto& rule : Rating::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  NoTrace trace;
  return Rating::evaluate(in, trace);
}

/// A case-hardened pinion with a through-hardened wheel.
In stage_for_years() {
  In in;
  in.standard = RatingStandard::iso6336, in.nu_40 = 220.0 * mm2_per_s, in.L_h = 20000.0 * hour;
  in.m_n = 4.0 * mm, in.z_1 = 21, in.z_2 = 80, in.x_1 = 0.3, in.x_2 = 0.1, in.beta = 12.0 * deg.one, in.b = 60.0 * mm;
  in.T_1 = 500.0 * N_m, in.n_1 = 900.0 * rpm, in.grade = 6, in.place = gear::Place::middle;
  in.R_z1 = in.R_z2 = 5.0 * um, in.S_Hmin = 1.0, in.S_Fmin = 1.2;
  in.material_1 = GearMaterial::case_hardened, in.sigma_Hlim_1 = 1500.0 * MPa, in.sigma_Flim_1 = 430.0 * MPa;
  in.material_2 = GearMaterial::through_alloy, in.sigma_Hlim_2 = 740.0 * MPa, in.sigma_Flim_2 = 295.0 * MPa;
  in.H_2 = 266;
  return in;
}

LoadBlock block_of(double q, double k, double n) { return {Name(), q, k, n * rpm}; }

In with_three_blocks() {
  In in = stage_for_years();
  in.blocks.push_back(block_of(0.01, 1.8, 300));
  in.blocks.push_back(block_of(0.29, 1.0, 900));
  in.blocks.push_back(block_of(0.7, 0.6, 1500));
  return in;
}

struct Safety {
  const char* name;
  double Rating::Result::*S;
};
const std::array safeties{Safety{"S_H1", &Rating::Result::S_H1}, Safety{"S_H2", &Rating::Result::S_H2},
                          Safety{"S_F1", &Rating::Result::S_F1}, Safety{"S_F2", &Rating::Result::S_F2}};

/// The hours that one block alone may run with this safety factor: none above the static limit, at most 1e7.
double hours_with(const In& in, const LoadBlock& block, double Rating::Result::*S, double safety) {
  In at = in;
  at.blocks.clear();
  at.T_1 = block.k * in.T_1, at.n_1 = block.n;
  const auto carries = [&](double hours) {
    at.L_h = hours * hour;
    return rated_under(at).*S >= safety;
  };
  double low = 1e-4, high = 1e7;
  if (carries(high)) return HUGE_VAL;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (carries(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_SUITE("gear rating under a load spectrum") {
  TEST_CASE("one block is the plain rating at its cycles, from a static load to endurance") {
    for (const double hours : {0.01, 1.0, 100.0, 5000.0, 50000.0, 3e6}) {
      In in = stage_for_years();
      in.L_h = hours * hour;
      const auto plain = rated_under(in);
      in.blocks.push_back({Name(), 1.0, 1.0, unset<AngularSpeed>});
      const auto r = rated_under(in);
      for (const Safety& s : safeties) CHECK_MESSAGE(rel(r.*s.S, plain.*s.S) < 1e-9, s.name);
      CHECK(rel(r.u_H1, plain.u_H1) < 1e-9);
      CHECK(rel(r.u_F2, plain.u_F2) < 1e-9);
      CHECK(rel(r.K_AH, 1.0) < 1e-12);
      CHECK(r.K_V == plain.K_V);
    }
  }

  TEST_CASE("the safety factor makes the sum of hours over the hours of each single block 1") {
    const In in = with_three_blocks();
    const auto r = rated_under(in);
    for (const Safety& s : safeties) {
      double sum = 0.0;
      for (const LoadBlock& b : in.blocks) sum += b.q * in_si(in.L_h) / 3600.0 / hours_with(in, b, s.S, r.*s.S);
      CHECK_MESSAGE(rel(sum, 1.0) < 1e-6, s.name);
    }
  }

  TEST_CASE("damage of every block at the required safety factor: its hours over its allowable hours") {
    const In in = with_three_blocks();
    const auto r = rated_under(in);
    double sum = 0.0;
    for (std::size_t i = 0; i < in.blocks.size(); ++i) {
      const LoadBlock& b = in.blocks[i];
      const double hours = hours_with(in, b, &Rating::Result::S_H2, in.S_Hmin);
      const double D = std::isinf(hours) ? 0.0 : b.q * in_si(in.L_h) / 3600.0 / hours;
      CHECK(std::abs(r.blocks[i].D_H2 - D) < 1e-6 * std::max(D, 1e-9));
      sum += r.blocks[i].D_H2;
    }
    CHECK(rel(r.D_H2, sum) < 1e-12);
    CHECK((r.D_H2 <= 1.0) == (r.u_H2 <= 1.0));
    CHECK((r.D_F1 <= 1.0) == (r.u_F1 <= 1.0));
  }

  TEST_CASE("neither the order of the blocks nor a division into equal ones matters") {
    In in = with_three_blocks();
    const auto r = rated_under(in);
    std::swap(in.blocks[0], in.blocks[2]);
    in.blocks[1].q /= 2.0;
    in.blocks.push_back(in.blocks[1]);
    const auto s = rated_under(in);
    for (const Safety& of : safeties) CHECK_MESSAGE(rel(r.*of.S, s.*of.S) < 1e-12, of.name);
    CHECK(rel(r.D_H2, s.D_H2) < 1e-12);
    CHECK(rel(in_si(r.T_F1), in_si(s.T_F1)) < 1e-12);
  }

  TEST_CASE("a peak above the static limits fails, however short, and no overload of a block is left unrated") {
    const auto overload =
        std::ranges::find_if(Rating::modes, [](const auto& m) { return std::string(m.id) == "overload"; });
    REQUIRE(overload != Rating::modes.end());
    In in = stage_for_years();
    in.blocks.push_back(block_of(1.0 - 1e-9, 1.0, 900));
    in.blocks.push_back(block_of(1e-9, 1.0, 900));  // about one turn
    CHECK(overload->applies(in) == Applies::unseen);
    const auto even = rated_under(in);
    in.blocks[1].k = 10.0;
    CHECK(overload->applies(in) == Applies::no);
    const auto peaked = rated_under(in);
    CHECK(even.S_F2 > in.S_Fmin);
    CHECK(peaked.S_F2 < in.S_Fmin);
    CHECK(peaked.D_F2 > 1.0);
  }

  TEST_CASE("more torque in any block, and more hours, never raise a safety factor") {
    const In in = with_three_blocks();
    const auto r = rated_under(in);
    for (std::size_t i = 0; i < in.blocks.size(); ++i) {
      In more = in;
      more.blocks[i].k *= 1.15;
      const auto s = rated_under(more);
      for (const Safety& of : safeties) CHECK_MESSAGE(s.*of.S <= r.*of.S * (1.0 + 1e-12), of.name);
      CHECK(s.D_H1 >= r.D_H1);
    }
    In longer = in;
    longer.L_h = 1.5 * in.L_h;
    for (const Safety& of : safeties) CHECK_MESSAGE(rated_under(longer).*of.S <= r.*of.S, of.name);
  }

  TEST_CASE("equivalent torque by the exponents of the chart: 6.611 and 8.738 for case-hardened teeth") {
    In in = stage_for_years();
    in.blocks.push_back(block_of(0.25, 1.0, 900));
    in.blocks.push_back(block_of(0.75, 0.8, 600));
    const auto r = rated_under(in);
    const auto of = [](double p) { return 500.0 * std::pow((225.0 + 450.0 * std::pow(0.8, p)) / 675.0, 1.0 / p); };
    CHECK(rel(r.T_H1 / N_m, of(6.611)) < 1e-5);
    CHECK(rel(r.T_H2 / N_m, of(6.611)) < 1e-5);
    CHECK(rel(r.T_F1 / N_m, of(8.738)) < 1e-5);
    CHECK(rel(r.T_F2 / N_m, of(6.225)) < 1e-5);
    CHECK(rel(r.K_AF, of(8.738) / 500.0) < 1e-5);
  }

  TEST_CASE("a block without torque does no damage, nor does a light one below the curve") {
    In in = with_three_blocks();
    const auto r = rated_under(in);
    in.blocks[2].q = 0.3;
    in.blocks.push_back(block_of(0.2, 0.0, 900)), in.blocks.push_back(block_of(0.2, 0.01, 900));
    const auto s = rated_under(in);
    CHECK(s.blocks[3].D_H1 == 0.0);
    CHECK(s.blocks[4].D_F2 == 0.0);
    CHECK(s.S_H1 >= r.S_H1);
  }

  TEST_CASE("without any torque there is no safety factor, as in the plain rating") {
    In in = stage_for_years();
    in.T_1 = 0.0 * N_m;
    in.blocks.push_back(block_of(1.0, 1.0, 900));
    const auto r = rated_under(in);
    for (const Safety& of : safeties) CHECK_MESSAGE(std::isnan(r.*of.S), of.name);
    CHECK(std::isnan(r.u_H1));
    CHECK(std::isnan(r.u_F2));
  }

  TEST_CASE("a spectrum needs a life, ISO 6336, fractions that sum to 1 and a block with T_1") {
    const std::string by_iso = "standard = \"iso6336\"\nnu_40 = \"150 mm^2/s\"\n", blocks = "blocks = [{ q = 1 }]";
    const auto says = [](const std::string& lines, const std::string& words) {
      const std::string answer = ExampleStep("gear.rating", lines).fault();
      CHECK_MESSAGE(answer.find(words) != std::string::npos, answer);
    };
    says(by_iso + blocks, "a load spectrum needs the required life L_h");
    says("L_h = \"9000 h\"\n" + blocks, "a load spectrum is rated by ISO 6336-6");
    says(by_iso + "L_h = \"9000 h\"\nblocks = [{ q = 0.4 }, { q = 0.5 }]", "the fractions q sum to 0.9, not to 1");
    says(by_iso + "L_h = \"9000 h\"\nblocks = [{ q = 1, k = 0.5 }]", "no block has the torque T_1");
  }
}
