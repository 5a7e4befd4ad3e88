#include "calculators/fatigue/combined.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using C = fatigue::Combined;
using test::rel;

constexpr auto safety = test::evaluated<C>;

/// The bar of problems 6-12 to 6-15 of [Shigley-SM6-8], in MPa.
C::Input bar(double sigma_a, double tau_m, double tau_a) {
  C::Input in;
  in.sigma_m = 0.0 * MPa, in.sigma_a = sigma_a * MPa, in.tau_m = tau_m * MPa, in.tau_a = tau_a * MPa;
  in.sigma_D = 276.0 * MPa, in.R_m = 551.0 * MPa, in.R_e = 413.0 * MPa;
  in.S_D = 1.0, in.S_F = 1.0, in.rule = C::Criterion::goodman;
  return in;
}

bool says(const std::string& lines, const std::string& words) {
  return test::says(
      "[c]\ncalculator = \"fatigue.combined\"\nS_D = 1.5\nsigma_m = \"0 MPa\"\nsigma_a = \"60 MPa\"\n"
      "tau_m = \"40 MPa\"\ntau_a = \"10 MPa\"\nsigma_D = \"180 MPa\"\n" +
          lines,
      words);
}

}  // namespace

TEST_SUITE("fatigue.combined") {
  TEST_CASE("solutions of Shigley 6-12 to 6-15") {
    struct Row {
      double sigma_a, tau_m, tau_a, n_y, goodman, gerber, elliptic;
    };
    for (const Row row : {Row{172, 103, 0, 1.67, 1.06, 1.31, 1.32}, Row{69, 138, 0, 1.66, 1.46, 1.73, 1.59},
                          Row{83, 103, 69, 1.34, 1.18, 1.47, 1.47}, Row{0, 0, 207, 1.15, 0.77, 0.77, 0.77}}) {
      const auto r = safety(bar(row.sigma_a, row.tau_m, row.tau_a));
      CHECK(std::abs(r.n_y - row.n_y) < 5e-3);
      CHECK(std::abs(r.n_Goodman - row.goodman) < 5e-3);
      CHECK(std::abs(r.n_Gerber - row.gerber) < 5e-3);
      CHECK(std::abs(r.n_elliptic - row.elliptic) < 5e-3);
    }
  }

  TEST_CASE("psi defaults to that of steels, half of it in shear; Gough and Pollard compare mean shear with 0.67 R_m") {
    C::Input in;
    in.sigma_m = 20.0 * MPa, in.sigma_a = 60.0 * MPa, in.tau_m = -40.0 * MPa, in.tau_a = 10.0 * MPa;
    in.sigma_D = 180.0 * MPa, in.tau_D = 110.0 * MPa, in.K_sigma = 1.7, in.K_tau = 1.5, in.R_m = 690.0 * MPa;
    in.S_D = 1.0, in.rule = C::Criterion::gough;
    const auto r = safety(in);
    // psi is 0.02 + 0.0002 690 = 0.158
    CHECK(rel(r.n_Serensen, 1 / std::hypot((60 + 0.158 / 1.7 * 20) / 180, (10 + 0.079 / 1.5 * 40) / 110)) < 1e-12);
    CHECK(rel(r.n_Gough, 1 / std::hypot(60 / 180.0 + 20 / 690.0, 10 / 110.0 + 40 / (0.67 * 690))) < 1e-12);
    CHECK(r.n == r.n_Gough);
  }

  TEST_CASE("Serensen's form: n_sigma n_tau over the root of their squares; K_D does not act on the mean stress") {
    C::Input in = bar(60, 40, 10);
    in.sigma_m = 20.0 * MPa, in.tau_D = 150.0 * MPa, in.K_sigma = 2.0, in.K_tau = 1.5;
    in.psi_sigma = 0.2, in.psi_tau = 0.1, in.rule = C::Criterion::serensen;
    const auto r = safety(in);
    const double sigma_m1 = 276 * 2.0, tau_m1 = 150 * 1.5;
    const double n_s = sigma_m1 / (2.0 * 60 + 0.2 * 20), n_t = tau_m1 / (1.5 * 10 + 0.1 * 40);
    CHECK(rel(r.n_sigma, n_s) < 1e-12);
    CHECK(rel(r.n_tau, n_t) < 1e-12);
    CHECK(rel(r.n_Serensen, n_s * n_t / std::hypot(n_s, n_t)) < 1e-12);
    CHECK(rel(r.u_D, 1.0 / r.n_Serensen) < 1e-12);
    in.tau_a = in.tau_m = 0.0 * MPa;
    CHECK(rel(safety(in).n_Serensen, n_s) < 1e-12);
    CHECK_FALSE(is_set(safety(in).n_tau));
    in.sigma_m = -200.0 * MPa;  // compression has no benefit
    CHECK(rel(safety(in).n_Serensen, 276.0 / 60) < 1e-12);
  }

  TEST_CASE("where tau_D is that of von Mises, fully reversed stresses have one safety factor by all schools") {
    C::Input in = bar(100, 0, 50);
    in.tau_D = 276.0 / std::sqrt(3.0) * MPa;
    const auto r = safety(in);
    const double n = 276.0 / std::sqrt(100.0 * 100 + 3 * 50 * 50);
    for (const double one : {r.n_Serensen, r.n_Goodman, r.n_Soderberg, r.n_Gerber, r.n_elliptic, r.n_Gough})
      CHECK(rel(one, n) < 1e-12);
    CHECK(rel(r.x_v, 1.0) < 1e-12);
  }

  TEST_CASE("a fatigue limit in shear below that of von Mises is not covered by this school") {
    C::Input in = bar(100, 0, 50);
    in.tau_D = 120.0 * MPa;
    CHECK(safety(in).x_v > 1.3);
    in.rule = C::Criterion::gough;
    CHECK_FALSE(is_set(safety(in).x_v));
  }

  TEST_CASE("wrong input is reported") {
    const std::string R_m = "R_m = \"690 MPa\"\n", tau_D = "tau_D = \"110 MPa\"\n";
    CHECK(says(R_m, "its own fatigue limit"));
    CHECK(says(tau_D, "needs the tensile strength"));
    CHECK(says(R_m + "rule = \"elliptic\"\n", "needs the yield strength"));
    CHECK(says(R_m + "tau_D = \"200 MPa\"\n", "the fatigue limit in shear must not exceed that in normal stress"));
    CHECK(says(tau_D + "R_m = \"170 MPa\"\n", "below the tensile strength"));
    CHECK(says(tau_D + R_m + "R_e = \"700 MPa\"\n", "the yield strength R_e must not exceed the tensile strength R_m"));
    CHECK(says(tau_D + R_m + "S_F = 1.5\n", "needs the yield strength R_e"));
  }
}
