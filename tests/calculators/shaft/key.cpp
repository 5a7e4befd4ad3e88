#include "calculators/shaft/key.hpp"

#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using shaft::Key;

constexpr auto solve = test::evaluated<Key>;

using test::rel;

/// 12x8x40 with straight ends on a shaft of 40 mm.
Key::Input key_12x8() {
  Key::Input in;
  in.T = 200.0 * N_m, in.d = 40.0 * mm, in.b = 12.0 * mm, in.h = 8.0 * mm, in.t_1 = 4.0 * mm, in.l = 40.0 * mm;
  in.form = Key::Form::B;
  return in;
}

/// Errors of a user are reported in these words.
void check_says(const std::string& lines, const std::string& words) {
  CHECK(test::says("[k]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\n" + lines, words));
}

double column(std::string_view name, std::string_view key) {
  const auto row = table::find_row("key", name);
  REQUIRE(row);
  const auto value = table::property(*row, key);
  REQUIRE(value);
  return value->si;
}

}  // namespace

TEST_SUITE("key") {
  TEST_CASE("[PrimeCalculator-key]: 10 kN, 62.5 MPa on half of the height, 20.8 MPa in shear") {
    const auto r = solve(key_12x8());
    CHECK(rel(in_si(r.F_t), 10e3) < 1e-12);
    CHECK(rel(in_si(r.p_1), 62.5e6) < 1e-12);
    CHECK(rel(in_si(r.p_2), 62.5e6) < 1e-12);
    CHECK(rel(in_si(r.tau), 20.8e6) < 0.002);
  }

  TEST_CASE("[Holooly-8.6]: 2.344 kN m shear a square key of 12.5 mm at 200 MPa") {
    Key::Input in = key_12x8();
    in.T = 2343.75 * N_m, in.d = 50.0 * mm, in.b = in.h = 12.5 * mm, in.t_1 = 6.25 * mm, in.l = 37.5 * mm;
    CHECK(rel(in_si(solve(in).tau), 200e6) < 1e-12);
  }

  TEST_CASE("[DIN6892] equation 35: the torque that method C allows is the one at which the utilisation is 1") {
    Key::Input in = key_12x8();
    in.d = 30.0 * mm, in.b = 8.0 * mm, in.h = 7.0 * mm, in.t_1 = 4.0 * mm, in.l = 35.0 * mm;
    in.i = 2, in.R_e_2 = 500.0 * MPa;
    in.T = 1063.125 * N_m;
    CHECK(rel(solve(in).u_2, 1.0) < 1e-12);
  }

  TEST_CASE("round ends carry with l - b, two keys with 1.5 of one, and each side has a strength of its own") {
    Key::Input in = key_12x8();
    in.t_1 = 5.0 * mm, in.p_adm_1 = 100.0 * MPa, in.p_adm_2 = 50.0 * MPa, in.p_adm_k = 200.0 * MPa;
    in.form = Key::Form::A;
    const auto one = solve(in);
    CHECK(rel(in_si(one.l_tr), 0.028) < 1e-12);
    CHECK(rel(one.u_1, 10e3 / (5.0 * 28.0) / 100.0) < 1e-12);
    CHECK(rel(one.u_2, 10e3 / (3.0 * 28.0) / 50.0) < 1e-12);
    CHECK(rel(one.u_k, 10e3 / (3.0 * 28.0) / 200.0) < 1e-12);
    CHECK(rel(one.u_tau, std::sqrt(3.0) * 10e3 / (12.0 * 28.0) / 200.0) < 1e-12);
    in.i = 2;
    CHECK(rel(in_si(one.p_2 / solve(in).p_2), 1.5) < 1e-12);
  }

  TEST_CASE("a torque counts by its magnitude, and a shock in full") {
    Key::Input in = key_12x8();
    in.T = -200.0 * N_m, in.K_A = 1.5;
    CHECK(rel(in_si(solve(in).T_eq), 300.0) < 1e-12);
    in.T_max = -350.0 * N_m;
    CHECK(rel(in_si(solve(in).T_eq), 350.0) < 1e-12);
    in.T_max = 250.0 * N_m;
    CHECK(rel(in_si(solve(in).T_eq), 300.0) < 1e-12);
  }

  TEST_CASE("the diameter ranges of the table have no gap, and the keys fit their keyways with clearance") {
    double last = 6e-3;
    for (const char* name : {"2x2",   "3x3",   "4x4",   "5x5",   "6x6",   "8x7",   "10x8",  "12x8",  "14x9",
                             "16x10", "18x11", "20x12", "22x14", "25x14", "28x16", "32x18", "36x20", "40x22",
                             "45x25", "50x28", "56x32", "63x32", "70x36", "80x40", "90x45", "100x50"}) {
      CAPTURE(name);
      CHECK(column(name, "d_over") == last);
      last = column(name, "d_to");
      CHECK(column(name, "h") < column(name, "t_1") + column(name, "t_2"));
      CHECK(column(name, "t_1") > 0.5 * column(name, "h"));
      CHECK(column(name, "b") < 0.42 * column(name, "d_over"));
    }
    CHECK(last == 0.5);
  }

  TEST_CASE("missing and contradictory inputs are reported") {
    check_says("d = \"50 mm\"\nl = \"70 mm\"\n", "give a key: key = \"14x9\", or b, h and t_1");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nkey = \"14x10\"\n", "no key '14x10' in the tables");
    check_says("d = \"50 mm\"\nl = \"12 mm\"\nkey = \"14x9\"\n", "key form A needs l > b");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nb = \"14 mm\"\nh = \"5 mm\"\nt_1 = \"5.5 mm\"\n",
               "must be less than key height h");
    check_says("d = \"10 mm\"\nl = \"70 mm\"\nkey = \"14x9\"\n", "must be less than d/2");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nkey = \"14x9\"\nT_max = \"-90 N*m\"\n",
               "the peak torque T_max must not be below T");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nkey = \"14x9\"\nR_e_2 = \"300 MPa\"\np_adm_2 = \"100 MPa\"\n",
               "not both");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nkey = \"14x9\"\ni = 3\n", "k.i: ");
    check_says("d = \"50 mm\"\nl = \"70 mm\"\nkey = \"14x9\"\nf_W = 0.5\n", "torque = \"reversing\"");
    check_says("d = \"50 mm\"\nl = \"200 mm\"\nkey = \"14x9\"\n",
               "the standard has no key of this section and length: l = 200 mm, and it is made from 36 mm to 160 mm");
  }

  TEST_CASE("a length that is found is a standard length of the section") {
    const auto p = test::solved_as_found(
        "[k]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\nd = \"50 mm\"\nkey = \"14x9\"\nl = \"?\"\nl_n = \"60 mm\"\n"
        "R_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nS_F = 1.5\ntorque = \"one_way\"\n");
    REQUIRE(p.value("k.l") != nullptr);
    CHECK(rel(p.value("k.l")->si[0], 0.036) < 1e-12);
  }
}
