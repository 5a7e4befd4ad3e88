// Eccentric and bowed bars under their force: deflection, stress, safety, and what passes of them.
#include "tests/calculators/column/models.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::Ends;

/// A bar of 40 mm by 60 mm, bent about y, its weaker axis.
column::Buckling::Input offset_bar(double e, double e_0, double P) {
  column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
  in.b = 60.0 * mm, in.h = 40.0 * mm;
  in.method = column::Method::secant;
  in.e_y = e * mm, in.e_0y = e_0 * mm;
  in.P = P * kN;
  return in;
}

/// Deflection of a hinged bar at mid-length: the series of the exact solution in sine waves; an eccentric force is
/// the moment of an even offset 4/(pi k) of every odd wave.
double deflection_by_waves(double e, double e_0, double x) {
  double w = e_0 * x / (1.0 - x);
  double sign = 1.0;
  for (int wave = 1; wave < 200001; wave += 2, sign = -sign) {
    const double k = wave;
    w += sign * e * 4.0 / (k * pi) * x / (k * k - x);
  }
  return w;
}

std::string rod(const std::string& lines) {
  return "[rod]\ncalculator = \"column.buckling\"\nP = \"20 kN\"\nl = \"900 mm\"\nd = \"45 mm\"\nends = "
         "\"fixed_free\"\nE = \"210 GPa\"\nR_e = \"340 MPa\"\nn_st = 3\n" +
         lines;
}

std::string eccentric_of(const std::string& lines) {
  return test::mode_of(test::solved_as_found(rod(lines)), "rod", "eccentric");
}

}  // namespace

TEST_SUITE("column eccentric") {
  TEST_CASE("the deflection is the sum of the sine waves of the exact solution") {
    for (const double P : {1.0, 20.0, 100.0, 180.0}) {
      const column::Buckling::Result r = solve(offset_bar(4.0, 3.0, P));
      const column::AxisResult& y = r.axes[0];
      CHECK(rel(in_si(y.w), deflection_by_waves(4e-3, 3e-3, P * 1e3 / in_si(y.N_cr))) < 1e-9);
      const double M = P * 1e3 * (7e-3 + in_si(y.w)), W = 0.06 * 0.04 * 0.04 / 6.0;
      CHECK(rel(in_si(y.sigma_max), P * 1e3 / 2.4e-3 + M / W) < 1e-12);
      CHECK(r.sigma_max == y.sigma_max);
    }
  }

  TEST_CASE("deflections of eccentricity and bow add up, and without either there is none") {
    const auto w = [](double e, double e_0) { return in_si(solve(offset_bar(e, e_0, 60.0)).w); };
    CHECK(rel(w(4.0, 3.0), w(4.0, 0.0) + w(0.0, 3.0)) < 1e-12);
    CHECK(rel(w(8.0, 0.0), 2.0 * w(4.0, 0.0)) < 1e-12);
    CHECK(w(0.0, 0.0) == 0.0);
    CHECK(rel(in_si(solve(offset_bar(0.0, 0.0, 60.0)).sigma_max), 60e3 / 2.4e-3) < 1e-12);
  }

  TEST_CASE("at the force times the safety factor the extreme fibre yields, and the secant method allows no more") {
    for (const double e_0 : {0.0, 3.0}) {
      const column::Buckling::Result r = solve(offset_bar(4.0, e_0, 30.0));
      const column::Buckling::Result at_yield = solve(offset_bar(4.0, e_0, 30.0 * r.n_e));
      CHECK(rel(in_si(at_yield.axes[0].sigma_max), 235e6) < 1e-9);
      CHECK(rel(at_yield.n_e, 1.0) < 1e-9);
      CHECK(rel(r.u_e, 2.0 / r.n_e) < 1e-12);
    }
  }

  TEST_CASE("an initial bow alone is Perry's equation") {
    const column::Buckling::Result r = solve(offset_bar(0.0, 5.0, 30.0));
    const column::AxisResult& y = r.axes[0];
    const double euler = in_si(y.N_cr) / 2.4e-3, yield = 235e6, sum = yield + (1.0 + y.eta_0) * euler;
    CHECK(rel(in_si(y.sigma_s), 0.5 * (sum - std::sqrt(sum * sum - 4.0 * yield * euler))) < 1e-9);
  }

  TEST_CASE("deflection and stress only increase with the force, and end at the critical force of either axis") {
    double before = 0.0;
    const double critical = in_si(solve(offset_bar(4.0, 3.0, 1.0)).N_cr) / 1e3;
    for (const double x : {0.01, 0.3, 0.6, 0.9, 0.999}) {
      const column::Buckling::Result r = solve(offset_bar(4.0, 3.0, x * critical));
      CHECK(in_si(r.w) > before);
      before = in_si(r.w);
    }
    for (const double x : {1.0, 1.5, 3.0}) {
      const column::Buckling::Result r = solve(offset_bar(4.0, 3.0, x * critical));
      CHECK(!is_set(r.w));
      CHECK(!is_set(r.sigma_max));
      CHECK(r.n_e < 1.0);
      CHECK(r.u > 1.0);
    }
  }

  TEST_CASE("in tension, and without a force, there is neither this stress nor this safety factor") {
    column::Buckling::Input in = offset_bar(4.0, 3.0, 1.0);
    in.P = unset<Force>;
    CHECK(!is_set(solve(in).sigma_max));
    in.N = 10.0 * kN;
    CHECK(!is_set(solve(in).sigma_max));
    CHECK(!is_set(solve(in).n_e));
  }

  TEST_CASE("a bow is assessed by the secant formula only, and about one axis") {
    CHECK(eccentric_of("e_0y = \"3 mm\"\nmethod = \"johnson\"\n") == "not-judged");
    CHECK(eccentric_of("e_0y = \"3 mm\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\nkind = \"solid\"\n") ==
          "not-judged");
    CHECK(eccentric_of("e_0y = \"3 mm\"\nmethod = \"secant\"\n") == "pass");
    CHECK(eccentric_of("e_0y = \"120 mm\"\nmethod = \"secant\"\n") == "fail");
    CHECK(eccentric_of("e_0y = \"0 mm\"\nmethod = \"johnson\"\n") == "none");
    CHECK(test::first_error_of(rod("e_0y = \"3 mm\"\ne_z = \"1 mm\"\nmethod = \"secant\"\n"))
              .find("about one axis only") != std::string::npos);
  }
}
