#include "calculators/chain/inverted_tooth.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace {

using namespace loadpath;

constexpr auto solve = test::evaluated<chain::InvertedTooth>;

using test::rel;

chain::InvertedTooth::Input blower() {
  chain::InvertedTooth::Input in;
  in.p = 12.7 * mm, in.b = 50.0 * mm;
  in.z_1 = 25, in.z_2 = 75;
  in.a = 500.0 * mm;
  in.n_1 = 1000.0 * rpm, in.P = 15.0 * kW, in.K_A = 1.4;
  in.P_b = 5.0 * kW;
  in.q = 2.5 * kg_per_m, in.F_u = 54.0 * kN, in.S_min = 8.0;
  return in;
}

std::string said(const std::string& lines) {
  std::string all;
  const std::string text =
      "[g]\ncalculator = \"chain.inverted_tooth\"\np = \"12.7 mm\"\nb = \"50 mm\"\nz_1 = 25\nz_2 = 75\n"
      "n_1 = \"1000 rpm\"\nP = \"15 kW\"\n";
  for (const Issue& i : loadpath::test::told(text + lines).issues)
    all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  return all;
}

bool says(const std::string& lines, const std::string& part) {
  const std::string all = said(lines);
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("inverted-tooth chain") {
  TEST_CASE("pitch diameters of a manufacturer's list, 1 inch pitch, [PEER-80]") {
    chain::InvertedTooth::Input in = blower();
    in.p = 25.4 * mm, in.a = 1500.0 * mm;
    for (const auto& row : {std::pair{20, 6.392}, {21, 6.710}, {25, 7.979}, {30, 9.567}, {35, 11.156}}) {
      CAPTURE(row.first);
      in.z_1 = row.first;
      CHECK(std::abs(in_si(solve(in).d_1) / 0.0254 - row.second) < 0.0008);
    }
  }

  TEST_CASE("the chain length is that of a manufacturer's formula, [Ramsey], but for its series") {
    for (const auto& [C, z_1, z_2] : {std::tuple{40.0, 21, 42}, {40.0, 21, 57}, {60.0, 25, 100}}) {
      chain::InvertedTooth::Input in = blower();
      in.z_1 = z_1, in.z_2 = z_2, in.a = C * in.p;
      const double S = (z_2 - z_1) / (2.0 * pi);
      CHECK(std::abs(solve(in).X_0 - (2.0 * C + 0.5 * (z_1 + z_2) + S * S / C)) < 0.01);
    }
  }

  TEST_CASE("the width is the design power over the rated power per width, and 25 % more with a hunting link") {
    const auto r = solve(blower());
    CHECK(rel(in_si(r.P_c), 21e3) < 1e-12);
    CHECK(rel(in_si(r.b_min), 0.042) < 1e-12);
    CHECK(rel(r.u_b, 0.84) < 1e-12);
    chain::InvertedTooth::Input in = blower();
    in.a = unset<Length>, in.X = 131;
    CHECK(rel(in_si(solve(in).b_min), 1.25 * 0.042) < 1e-12);
    CHECK(solve(in).odd == 1.0);
    in = blower();
    in.P_b = 2.0 * kW, in.b_R = 25.4 * mm;  // per inch
    CHECK(rel(in_si(solve(in).b_min), 10.5 * 0.0254) < 1e-12);
  }

  TEST_CASE("forces and safety factor by an independent computation") {
    const auto r = solve(blower());
    CHECK(r.X == 130.0);
    CHECK(rel(in_si(r.a), 0.497703358096724) < 1e-10);
    CHECK(rel(in_si(r.F_t), 2834.6456692913384) < 1e-12);
    CHECK(rel(in_si(r.F_c), 70.00434027777779) < 1e-12);
    CHECK(rel(in_si(r.F_f), 73.23704914393294) < 1e-10);
    CHECK(rel(in_si(r.F), 4111.745326429585) < 1e-10);
    CHECK(rel(in_si(r.F_W), 4114.97803529574) < 1e-10);
    CHECK(rel(r.u_S, 0.6091474557673459) < 1e-10);
    CHECK(rel(in_si(r.F_t * r.v), 15e3) < 1e-12);
    CHECK(rel(in_si(r.shaft_1.T), 1.4 * 143.2394487827058) < 1e-12);
    CHECK(r.shaft_2.F_x == r.F_W);
  }

  TEST_CASE("without mass, breaking load and rating, only geometry, pull and speeds result") {
    chain::InvertedTooth::Input in = blower();
    in.q = unset<LineDensity>, in.F_u = unset<Force>, in.S_min = unset<double>, in.P_b = unset<Power>;
    const auto r = solve(in);
    CHECK(in_si(r.F_f) == 0.0);
    CHECK(rel(in_si(r.F), 1.4 * 2834.6456692913384) < 1e-12);
    CHECK(!is_set(r.u_b));
    CHECK(!is_set(r.u_F));
    CHECK(!is_set(r.v_share));
    in.P = 0.0 * kW;
    CHECK(in_si(solve(in).F) == 0.0);
  }

  TEST_CASE("wrong inputs are refused with the remedy") {
    says("", "either the centre distance a or the number of links X");
    says("a = \"1 m\"\nX = 120\n", "either the centre distance a or the number of links X");
    says("a = \"150 mm\"\n", "the sprockets touch each other");
    says("X = 60\n", "do not reach around");
    says("a = \"1 m\"\nS_min = 8\n", "needs the breaking load F_u");
    says("X = 131\n", "a chain wider by 25 %");
    CHECK(said("a = \"500 mm\"\nP_b = \"5 kW\"\n").find("error") == std::string::npos);
  }
}
