#include "calculators/column/stepped/stepped.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using column::Stepped;
using Foot = Stepped::Foot;
using Top = Stepped::Top;
using test::rel;

struct Round {
  double l, d, P, q;  // m, m, kN, N/mm
};

Stepped::Input column_of(Foot foot, Top top, const std::vector<Round>& parts) {
  Stepped::Input in;
  in.foot = foot, in.top = top, in.E = 210.0 * GPa, in.rho = from_si<Density>(7850.0);
  for (const Round& round : parts) {
    Stepped::Part part;
    part.l = from_si<Length>(round.l), part.d = from_si<Length>(round.d);
    part.P = round.P * kN, part.q = round.q * N_per_mm;
    in.parts.push_back(part);
  }
  return in;
}

/// A part of E I = stiffness by E = 1 Pa; the area does not matter.
Stepped::Part part_of(double l, double stiffness, double P, double q) {
  Stepped::Part part;
  part.l = from_si<Length>(l), part.A = from_si<Area>(1.0), part.I = from_si<SecondMoment>(stiffness);
  part.P = from_si<Force>(P), part.q = from_si<Stiffness>(q);
  return part;
}

double factor_of(Foot foot, Top top, const std::vector<Stepped::Part>& parts) {
  Stepped::Input in;
  in.foot = foot, in.top = top, in.E = from_si<Stress>(1.0);
  in.parts.assign(parts.begin(), parts.end());
  return test::evaluated<Stepped>(in).alpha_cr;
}

constexpr double tau = 4.493409457909064;  // tan x = x

}  // namespace

TEST_SUITE("column stepped") {
  TEST_CASE("one part with a load at its top is Euler's column") {
    struct Row {
      Foot foot;
      Top top;
      double N_cr;
    };
    for (const Row& row : {Row{Foot::fixed, Top::free, pi * pi / 4.0}, Row{Foot::pinned, Top::pinned, pi * pi},
                           Row{Foot::fixed, Top::pinned, tau * tau}, Row{Foot::pinned, Top::fixed, tau * tau},
                           Row{Foot::fixed, Top::fixed, 4.0 * pi * pi}, Row{Foot::fixed, Top::guided, pi * pi},
                           Row{Foot::pinned, Top::guided, pi * pi / 4.0}}) {
      CHECK(rel(factor_of(row.foot, row.top, {part_of(1.0, 1.0, 1.0, 0.0)}), row.N_cr) < 1e-11);
      // in equal parts, of any length and stiffness, it is the same column
      CHECK(rel(factor_of(row.foot, row.top,
                          {part_of(0.6, 5.0, 0.0, 0.0), part_of(1.3, 5.0, 0.0, 0.0), part_of(0.1, 5.0, 1.0, 0.0)}),
                row.N_cr * 5.0 / 4.0) < 1e-9);
    }
  }

  TEST_CASE("under its own weight: the published coefficients of q L^3/(E I), and those of finite elements") {
    struct Row {
      Foot foot;
      Top top;
      double published, computed;
    };
    // published: Timoshenko and Gere; computed: cubic finite elements with numpy, extrapolated from 24 and 48 elements
    for (const Row& row :
         {Row{Foot::fixed, Top::free, 7.837, 7.837347439}, Row{Foot::pinned, Top::pinned, 18.57, 18.56872484},
          Row{Foot::pinned, Top::fixed, 30.01, 30.00942113}, Row{Foot::fixed, Top::pinned, 52.50, 52.50066314},
          Row{Foot::fixed, Top::fixed, 74.63, 74.62856896}, Row{Foot::fixed, Top::guided, 18.96, 18.95626559},
          Row{Foot::pinned, Top::guided, 3.4766, 3.476619008}}) {
      const double alpha = factor_of(row.foot, row.top, {part_of(1.0, 1.0, 0.0, 1.0)});
      CHECK(rel(alpha, row.published) < 4e-4);
      CHECK(rel(alpha, row.computed) < 1e-7);
      const double parted = factor_of(row.foot, row.top, {part_of(0.3, 1.0, 0.0, 1.0), part_of(0.7, 1.0, 0.0, 1.0)});
      CHECK(rel(parted, alpha) < 1e-9);
    }
    // the root of the Bessel function of order -1/3 that Greenhill gives for the free column
    CHECK(rel(factor_of(Foot::fixed, Top::free, {part_of(1.0, 1.0, 0.0, 1.0)}), 9.0 / 4.0 * 1.8663508 * 1.8663508) <
          1e-6);
  }

  TEST_CASE("a stepped cantilever: tan(k_1 l_1) tan(k_2 l_2) = k_2/k_1") {
    CHECK(rel(factor_of(Foot::fixed, Top::free, {part_of(0.5, 2.0, 0.0, 0.0), part_of(0.5, 1.0, 1.0, 0.0)}), 4.13447) <
          2e-6);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(0.2, 3.0);
    for (int i = 0; i < 20; ++i) {
      const double l_1 = some(random), l_2 = some(random), EI_1 = some(random), EI_2 = some(random);
      const double P = factor_of(Foot::fixed, Top::free, {part_of(l_1, EI_1, 0.0, 0.0), part_of(l_2, EI_2, 1.0, 0.0)});
      const double k_1 = std::sqrt(P / EI_1), k_2 = std::sqrt(P / EI_2);
      CHECK(k_1 * l_1 < pi / 2.0);
      CHECK(std::abs(std::sin(k_1 * l_1) * std::sin(k_2 * l_2) * k_1 -
                     k_2 * std::cos(k_1 * l_1) * std::cos(k_2 * l_2)) < 1e-9);
    }
  }

  TEST_CASE("a hinged column with a stiffer middle: the table of Timoshenko and Gere") {
    struct Row {
      double a;
      std::vector<double> m;
    };
    const std::vector<double> ratios{0.01, 0.1, 0.2, 0.4, 0.6, 0.8};
    for (const Row& row :
         {Row{0.2, {0.15, 1.47, 2.80, 5.09, 6.98, 8.55}}, Row{0.4, {0.27, 2.40, 4.22, 6.68, 8.19, 9.18}},
          Row{0.6, {0.60, 4.50, 6.69, 8.51, 9.24, 9.63}}, Row{0.8, {2.26, 8.59, 9.33, 9.67, 9.78, 9.84}}}) {
      for (std::size_t i = 0; i < ratios.size(); ++i) {
        const double end = 0.5 * (1.0 - row.a);
        const double m = factor_of(
            Foot::pinned, Top::pinned,
            {part_of(end, ratios[i], 0.0, 0.0), part_of(row.a, 1.0, 0.0, 0.0), part_of(end, ratios[i], 1.0, 0.0)});
        CAPTURE(row.a);
        CAPTURE(ratios[i]);
        CHECK(std::abs(m - row.m[i]) < 0.0101);
      }
    }
  }

  TEST_CASE("random columns: cubic finite elements with numpy, extrapolated from 12 and 24 elements in each part") {
    struct Row {
      Foot foot;
      Top top;
      std::vector<Round> parts;
      double alpha;
    };
    const std::vector<Row> rows{
        {Foot::pinned, Top::fixed, {{4.623, 0.144, 0, 0}, {6.595, 0.171, 0, 0.26}}, 64.0293758},
        {Foot::fixed, Top::free, {{4.776, 0.176, 8.16, 3.66}, {5.194, 0.053, 0, 3.81}}, 1.11676536},
        {Foot::fixed, Top::pinned, {{7.606, 0.1, 77.79, 3.87}}, 4.00896005},
        {Foot::pinned, Top::guided, {{2.415, 0.076, 70.09, 0}, {2.589, 0.194, 77.21, 0.11}}, 0.897953385},
        {Foot::fixed,
         Top::pinned,
         {{11.262, 0.067, 65.39, 0}, {7.354, 0.147, 28.43, 3.48}, {2.625, 0.105, 20.49, 0}},
         0.153791428},
        {Foot::pinned, Top::guided, {{5.149, 0.119, 30.11, 0}, {5.707, 0.147, 76.35, 1.23}}, 0.690622956},
        {Foot::fixed,
         Top::fixed,
         {{6.394, 0.181, 37.03, 0}, {9.481, 0.086, 34.64, 0}, {2.898, 0.112, 11.86, 3.51}},
         2.99693646},
        {Foot::fixed, Top::fixed, {{8.389, 0.075, 0, 0}}, 121.187491},
        {Foot::fixed, Top::guided, {{2.358, 0.029, 0, 0}, {5.168, 0.063, 66.1, 0}}, 0.133852952},
        {Foot::fixed,
         Top::pinned,
         {{1.141, 0.185, 39.49, 0}, {2.002, 0.152, 0, 0}, {9.562, 0.039, 11.94, 0}},
         0.42878872},
        {Foot::fixed, Top::pinned, {{5.711, 0.2, 0, 0}, {5.716, 0.108, 0, 0}}, 178.018489},
        {Foot::fixed, Top::guided, {{5.144, 0.046, 79.07, 0}, {7.71, 0.11, 7.13, 3.91}}, 0.128089454}};
    for (const Row& row : rows)
      CHECK(rel(test::evaluated<Stepped>(column_of(row.foot, row.top, row.parts)).alpha_cr, row.alpha) < 5e-7);
  }

  TEST_CASE("the weight tends to zero: Euler is approached from below, and twice all loads is half the factor") {
    Stepped::Input in = column_of(Foot::fixed, Top::free, {{3.0, 0.16, 100.0, 0.0}, {2.0, 0.125, 60.0, 0.0}});
    const double with_weight = test::evaluated<Stepped>(in).alpha_cr;
    in.orientation = Stepped::Orientation::horizontal;
    const double level = test::evaluated<Stepped>(in).alpha_cr;
    in.orientation = Stepped::Orientation::vertical;
    in.rho = from_si<Density>(1e-6);
    const double light = test::evaluated<Stepped>(in).alpha_cr;
    CHECK(with_weight < level);
    CHECK(rel(light, level) < 1e-9);
    in.parts[0].P *= 2.0, in.parts[1].P *= 2.0;
    CHECK(rel(test::evaluated<Stepped>(in).alpha_cr, 0.5 * level) < 1e-8);
  }

  TEST_CASE("more load anywhere, or a thinner part, never raises the critical load") {
    const std::vector<Round> base{{3.0, 0.1, 20.0, 0.0}, {2.0, 0.08, 10.0, 0.0}, {1.0, 0.06, 5.0, 0.0}};
    for (const Top top : {Top::free, Top::pinned, Top::fixed, Top::guided}) {
      const double before = test::evaluated<Stepped>(column_of(Foot::fixed, top, base)).alpha_cr;
      for (std::size_t i = 0; i < base.size(); ++i) {
        std::vector<Round> heavier = base, thinner = base;
        heavier[i].P *= 1.5, thinner[i].d *= 0.9;
        CHECK(test::evaluated<Stepped>(column_of(Foot::fixed, top, heavier)).alpha_cr < before);
        CHECK(test::evaluated<Stepped>(column_of(Foot::fixed, top, thinner)).alpha_cr < before);
      }
    }
  }

  TEST_CASE("the effective lengths of the parts give the same critical load") {
    const Stepped::Input in = column_of(Foot::fixed, Top::pinned, {{3.0, 0.1, 20.0, 0.0}, {2.0, 0.08, 10.0, 0.0}});
    const Stepped::Result r = test::evaluated<Stepped>(in);
    for (const auto& of : r.members)
      CHECK(rel(pi * pi * 210e9 * in_si(of.I) / (in_si(of.s) * in_si(of.s)), r.alpha_cr * in_si(of.N_l)) < 1e-12);
    CHECK(rel(in_si(r.F_cr), r.alpha_cr * in_si(r.F)) < 1e-15);
  }

  TEST_CASE("a part without compression does not govern, and a column without a load is not assessed") {
    Stepped::Input in = column_of(Foot::fixed, Top::free, {{3.0, 0.1, 20.0, 0.0}, {2.0, 0.05, 0.0, 0.0}});
    in.rho = unset<Density>, in.n_st = 3.0, in.R_e = 235.0 * MPa;
    const Stepped::Result r = test::evaluated<Stepped>(in);
    CHECK(r.members[1].u == 0.0);
    CHECK(rel(r.alpha_cr, pi * pi / 4.0 * 210e9 * in_si(r.members[0].I) / 9.0 / 20e3) < 1e-9);
    in.parts[0].P = 0.0 * kN;
    CHECK(test::evaluated<Stepped>(in).u == 0.0);
    CHECK(!is_set(test::evaluated<Stepped>(in).alpha_cr));
  }

  TEST_CASE("unsafe columns do not pass, safe ones do") {
    const auto of = [](const std::string& lines, const char* mode) {
      return test::mode_with("column.stepped", lines, mode);
    };
    CHECK(of("", "buckling") == "pass");
    CHECK(of("n_st = 10", "buckling") == "fail");
    CHECK(of("n_st = ", "buckling") == "not-judged");
    CHECK(of("R_e = \nsigma_P = \"10 MPa\"", "buckling") == "not-covered");
    CHECK(of("", "local") == "none");
    const std::string plates = "parts = [{ l = \"3 m\", A = \"100 cm^2\", I = \"5000 cm^4\", P = \"100 kN\" }]";
    CHECK(of(plates, "local") == "not-judged");
    CHECK(of(plates, "torsional") == "not-judged");
    CHECK(of("n_st = 1", "buckling") == "not-judged");  // below common practice
    CHECK_FALSE(test::ExampleStep("column.stepped", "foot = \"pinned\"").fault().empty());
    CHECK_FALSE(test::ExampleStep("column.stepped", "R_e = ").fault().empty());
    CHECK_FALSE(test::ExampleStep("column.stepped", "parts = [{ l = \"3 m\", P = \"1 kN\" }]").fault().empty());
    CHECK_FALSE(
        test::ExampleStep("column.stepped", "parts = [{ l = \"3 m\", d = \"50 mm\", P = \"-1 kN\" }]").fault().empty());
    CHECK_FALSE(
        test::ExampleStep("column.stepped", "parts = [{ l = \"3 m\", d = \"50 mm\", A = \"1 cm^2\", P = \"1 kN\" }]")
            .fault()
            .empty());
  }
}
