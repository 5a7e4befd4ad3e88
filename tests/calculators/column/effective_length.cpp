#include "calculators/column/effective_length.hpp"

#include "calculators/column/member/length_factor.hpp"
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::Bar;
using column::held;

double beta(const Bar& bar) { return std::numbers::pi / column::buckling_parameter(bar); }

column::EffectiveLength::Result solve(const column::EffectiveLength::Input& in) {
  NoTrace trace;
  return column::EffectiveLength::evaluate(in, trace);
}

column::EffectiveLength::Input frame(double G_1, double G_2, column::EffectiveLength::Frame kind) {
  column::EffectiveLength::Input in;
  in.l = 4.0 * m;
  in.G_1 = G_1, in.G_2 = G_2;
  in.frame = kind;
  return in;
}

}  // namespace

TEST_SUITE("column effective length") {
  TEST_CASE("the cases of the ends: 1, 2, 0.69916, 0.5, and 1, 2 with sway") {
    using column::Ends;
    for (const Ends ends : {Ends::pinned_pinned, Ends::fixed_free, Ends::fixed_pinned, Ends::fixed_fixed,
                            Ends::fixed_guided, Ends::pinned_guided}) {
      CHECK(rel(beta(column::bar_of(ends)), column::length_factor(ends, column::Basis::exact)) < 1e-12);
    }
    CHECK(rel(column::length_factor(Ends::fixed_pinned, column::Basis::exact), 0.6991556596) < 1e-9);
  }

  TEST_CASE("supports and springs, against finite elements") {
    struct Row {
      Bar bar;
      double beta;
    };
    for (const Row& row :
         {Row{{{held, 0}, {held, 0}, {0.3}}, 0.557498}, Row{{{held, held}, {held, held}, {0.5}}, 0.349578},
          Row{{{held, held}, {held, 0}, {1 / 3., 2 / 3.}}, 0.312976}, Row{{{held, held}, {0, 0}, {0.5}}, 1.255050},
          Row{{{held, held}, {0, 0}, {0.7}}, 0.974723}, Row{{{held, 4}, {held, 0}, {}}, 0.820503},
          Row{{{held, 4}, {held, 9}, {}}, 0.642462}, Row{{{held, 3}, {5, 2}, {}}, 1.091782},
          Row{{{held, 2.5}, {held, held}, {0.2, 0.6}}, 0.304708}}) {
      CHECK(std::abs(beta(row.bar) - row.beta) < 1e-6);
    }
  }

  TEST_CASE("higher modes, against their closed forms") {
    constexpr double tan_u[] = {4.493409457909064, 7.725251836937707, 10.904121659428899};  // roots of tan u = u
    const column::End pin{held, 0.0}, clamp{held, held}, free{0.0, 0.0}, guide{0.0, held};
    for (int n = 1; n <= 20; ++n) {
      CHECK(rel(column::buckling_parameter({pin, pin, {}}, n), n * pi) < 1e-12);
      CHECK(rel(column::buckling_parameter({clamp, free, {}}, n), (n - 0.5) * pi) < 1e-12);
      CHECK(rel(column::buckling_parameter({clamp, guide, {}}, n), n * pi) < 1e-12);
      CHECK(rel(column::buckling_parameter({pin, guide, {}}, n), (n - 0.5) * pi) < 1e-12);
    }
    for (int n = 1; n <= 3; ++n) {
      CHECK(rel(column::buckling_parameter({clamp, pin, {}}, n), tan_u[n - 1]) < 1e-12);
      CHECK(rel(column::buckling_parameter({clamp, clamp, {}}, 2 * n - 1), 2 * n * pi) < 1e-12);    // symmetric
      CHECK(rel(column::buckling_parameter({clamp, clamp, {}}, 2 * n), 2 * tan_u[n - 1]) < 1e-12);  // antisymmetric
    }
    CHECK(rel(column::buckling_parameter({pin, pin, {0.5}}, 1), 2 * pi) < 1e-12);
    CHECK(rel(column::buckling_parameter({pin, pin, {0.5}}, 2), 2 * tan_u[0]) <
          1e-12);  // two bars clamped at the middle
    CHECK(rel(column::buckling_parameter({pin, pin, {0.5}}, 3), 4 * pi) < 1e-12);
  }

  TEST_CASE("the shape of a higher mode: n half waves between hinges") {
    const Bar bar{{held, 0}, {held, 0}, {}};
    for (int n = 2; n <= 5; ++n) {
      const column::Shape shape = column::buckled_shape(bar, column::buckling_parameter(bar, n));
      for (std::size_t i = 0; i < shape.x.size(); ++i)
        CHECK(std::abs(std::abs(shape.w[i]) - std::abs(std::sin(n * pi * shape.x[i]))) < 0.02);  // 48 points
    }
  }

  TEST_CASE("a higher mode is shown in addition to the first, which does not change") {
    column::EffectiveLength::Input in;
    in.l = 2.0 * m;
    in.E = 210.0 * GPa;
    in.I = from_si<SecondMoment>(1e-8);
    in.end_1 = in.end_2 = column::EffectiveLength::End::pinned;
    const auto first = solve(in);
    CHECK(std::isnan(first.beta_n));
    in.mode = 3;
    const auto third = solve(in);
    CHECK(third.beta == first.beta);
    CHECK(rel(in_si(third.N_cr_n), 9 * in_si(first.N_cr)) < 1e-12);
    CHECK(rel(third.beta_n, 1.0 / 3) < 1e-12);
  }

  TEST_CASE("the factor of a higher mode is refused where the column buckles in its first one") {
    const std::string text =
        "calculator = \"column.buckling\"\nP = \"4 kN\"\nl = \"1 m\"\nd = \"45 mm\"\nbeta_y = \"=rod.beta_n\"\n"
        "beta_z = 1\nE = \"210 GPa\"\nmethod = \"euler\"\nn_st = 3\nsigma_P = \"270 MPa\"\n\n[rod]\n"
        "calculator = \"column.effective_length\"\nl = \"1 m\"\nend_1 = \"fixed\"\nend_2 = \"pinned\"\nmode = 2\n";
    CHECK(complaints(text).find("effective length factor of a higher buckling mode") != std::string::npos);
  }

  TEST_CASE("equal spans between hinges: the effective length is the span") {
    CHECK(rel(beta({{held, 0}, {held, 0}, {0.25, 0.5, 0.75}}), 0.25) < 1e-12);
  }

  TEST_CASE("a cantilever with a spring across its end: tan u = u - u^3/mu") {
    for (const double mu : {0.5, 3.0, 10.0, 30.0, 1e3}) {
      const double u = column::buckling_parameter({{held, held}, {mu, 0}, {}});
      CHECK(std::abs(std::sin(u) - (u - u * u * u / mu) * std::cos(u)) < 1e-11 * u * u * u / mu + 1e-12);
    }
  }

  TEST_CASE("stiffer springs never lengthen the bar, and end in the rigid cases") {
    double before = 1e9;
    for (double kappa = 1e-3; kappa < 1e9; kappa *= 3.0) {
      const double now = beta({{held, kappa}, {0, 0}, {}});
      CHECK(now <= before);
      before = now;
    }
    CHECK(rel(before, 2.0) < 1e-8);
    CHECK(rel(beta({{held, 1e-9}, {held, 1e-9}, {}}), 1.0) < 1e-9);
    CHECK(rel(beta({{held, 1e10}, {held, 1e10}, {}}), 0.5) < 1e-9);
  }

  TEST_CASE("joints of frames, against the equations of the alignment charts") {
    struct Row {
      double G_1, G_2, braced, sway;
    };
    using Frame = column::EffectiveLength::Frame;
    for (const Row& row : {Row{1, 1, 0.7742650686, 1.3172751026}, Row{0.5, 2, 0.7646542639, 1.3667664809},
                           Row{1, 10, 0.8599218095, 1.9029690405}, Row{3, 0.2, 0.7245352909, 1.4099549066}}) {
      CHECK(rel(solve(frame(row.G_1, row.G_2, Frame::braced)).beta, row.braced) < 1e-9);
      CHECK(rel(solve(frame(row.G_1, row.G_2, Frame::sway)).beta, row.sway) < 1e-9);
    }
    CHECK(rel(solve(frame(0, 0, Frame::braced)).beta, 0.5) < 1e-12);
    CHECK(rel(solve(frame(0, 0, Frame::sway)).beta, 1.0) < 1e-12);
  }

  TEST_CASE("supports that leave a mechanism have no effective length") {
    column::EffectiveLength::Input in;
    in.l = 1.0 * m;
    in.end_1 = column::EffectiveLength::End::pinned;
    in.end_2 = column::EffectiveLength::End::free;
    CHECK(std::isnan(solve(in).beta));
    using End = column::EffectiveLength::End;
    for (const auto& [first, second] : {std::pair{End::guided, End::guided}, std::pair{End::free, End::guided},
                                        std::pair{End::guided, End::free}, std::pair{End::free, End::free}}) {
      in.end_1 = first, in.end_2 = second;
      CHECK(std::isnan(solve(in).beta));
    }
  }

  TEST_CASE("a bar that moves as a rigid body is refused, a supported one is not") {
    const auto refuses = [](const std::string& lines) {
      const std::string bar = "calculator = \"column.effective_length\"\nl = \"1 m\"\nE = \"210 GPa\"\n";
      return complaints(bar + "I = \"1 cm^4\"\n" + lines).find("this bar is a mechanism: hold an end") !=
             std::string::npos;
    };
    const auto ends = [](const std::string& first, const std::string& second) {
      return "end_1 = \"" + first + "\"\nend_2 = \"" + second + "\"\n";
    };
    for (const auto& [first, second] :
         {std::pair{"free", "pinned"}, std::pair{"pinned", "free"}, std::pair{"free", "free"},
          std::pair{"free", "guided"}, std::pair{"guided", "guided"}}) {
      CHECK(refuses(ends(first, second)));
    }
    CHECK(refuses(ends("elastic", "free") + "c_1 = \"0 N*m/rad\"\n"));
    CHECK(refuses(ends("elastic", "guided") + "k_1 = \"0 N/mm\"\n"));
    CHECK(refuses(ends("free", "free") + "supports = [[\"500 mm\"]]\n"));
    for (const auto& [first, second] : {std::pair{"fixed", "free"}, std::pair{"pinned", "guided"},
                                        std::pair{"pinned", "pinned"}, std::pair{"fixed", "guided"}})
      CHECK(!refuses(ends(first, second)));
    CHECK(!refuses(ends("elastic", "free") + "c_1 = \"1 kN*m/rad\"\n"));
    CHECK(!refuses(ends("pinned", "elastic") + "k_2 = \"1 N/mm\"\n"));
    CHECK(!refuses(ends("pinned", "free") + "supports = [[\"500 mm\"]]\n"));
    CHECK(!refuses(ends("guided", "guided") + "supports = [[\"500 mm\"]]\n"));
    CHECK(!refuses(ends("free", "free") + "supports = [[\"200 mm\"], [\"500 mm\"]]\n"));
  }

  TEST_CASE("springs need E (or a material) and I of the bar") {
    column::EffectiveLength::Input in;
    in.l = 2.0 * m;
    in.E = 200.0 * GPa;
    in.I = from_si<SecondMoment>(5e-8);
    in.end_1 = in.end_2 = column::EffectiveLength::End::elastic;
    in.c_1 = 20.0 * N_m_per_rad.one * 1e3;
    in.c_2 = 45.0 * N_m_per_rad.one * 1e3;
    const column::EffectiveLength::Result r = solve(in);
    CHECK(rel(r.kappa_1, 4.0) < 1e-12);
    CHECK(std::abs(r.beta - 0.642462) < 1e-6);
    CHECK(rel(in_si(r.N_cr), pi * pi * 200e9 * 5e-8 / std::pow(r.beta * 2.0, 2)) < 1e-12);
  }

  TEST_CASE("the buckled shape meets its supports and is 1 at most") {
    const Bar bar{{held, held}, {held, 0}, {0.25, 0.5}};
    const column::Shape shape = column::buckled_shape(bar, column::buckling_parameter(bar));
    double most = 0.0;
    for (std::size_t i = 0; i < shape.x.size(); ++i) {
      if (shape.x[i] == 0.0 || shape.x[i] == 0.25 || shape.x[i] == 0.5 || shape.x[i] == 1.0)
        CHECK(std::abs(shape.w[i]) < 1e-6);
      most = std::max(most, std::abs(shape.w[i]));
    }
    CHECK(most == 1.0);
  }

  TEST_CASE("a weak spring at the base of a free bar: u tan u = c, however small") {
    for (const double c : {0.02, 0.1, 0.2}) {
      const double u = column::buckling_parameter({{held, c}, {0.0, 0.0}, {}});
      CHECK(rel(u * std::tan(u), c) < 1e-11);
    }
  }

  TEST_CASE("the buckled shape of a cantilever is 1 - cos, whichever end is free") {
    const column::End fixed{held, held}, free{0.0, 0.0};
    const double u = 0.5 * std::numbers::pi;
    const auto from_foot = column::buckled_shape({fixed, free, {}}, u),
               from_tip = column::buckled_shape({free, fixed, {}}, u);
    for (std::size_t i = 0; i < from_foot.x.size(); ++i) {
      CHECK(std::abs(from_foot.w[i] - (1.0 - std::cos(u * from_foot.x[i]))) < 1e-6);
      CHECK(std::abs(from_tip.w[i] - (1.0 - std::cos(u * (1.0 - from_tip.x[i])))) < 1e-6);
    }
  }

  TEST_CASE("wrong ends, springs and supports are reported") {
    const std::string bar = "calculator = \"column.effective_length\"\nl = \"1 m\"\n";
    const auto says = [&](const std::string& lines, std::string_view words) {
      return complaints(bar + lines).find(words) != std::string::npos;
    };
    CHECK(says("end_1 = \"pinned\"\n", "give both end conditions"));
    CHECK(says("G_1 = 1\n", "give both end conditions"));
    CHECK(says("end_1 = \"pinned\"\nend_2 = \"pinned\"\nframe = \"sway\"\n", "a sway frame needs G_1 and G_2"));
    CHECK(says("end_1 = \"pinned\"\nend_2 = \"elastic\"\nE = \"210 GPa\"\nI = \"1 cm^4\"\n",
               "springs c and k belong to an elastic end, which needs at least one"));
    CHECK(says("end_1 = \"pinned\"\nend_2 = \"elastic\"\nc_2 = \"1 kN*m/rad\"\n",
               "springs need E (or a material) and I of the bar"));
    CHECK(
        says("end_1 = \"pinned\"\nend_2 = \"pinned\"\nsupports = [[\"2 m\"]]\n", "supports must lie between the ends"));
  }
}
