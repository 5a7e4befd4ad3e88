// Bars as drawn: the signs of their ends, the shape that touches its supports, the section to scale.
#include "calculators/column/buckling.hpp"
#include "lib/draw/dxf.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::draw::test;
using column::Ends;
using figure::Drawing;
using figure::Point;
using Sign = Drawing::Support::Kind;

namespace {

using Input = column::Buckling::Input;

Input rod(Ends ends) {
  Input in;
  in.P = 40.0 * kN, in.l = 900.0 * mm, in.d = 45.0 * mm, in.ends = ends;
  in.E = 210.0 * GPa, in.R_e = 340.0 * MPa, in.sigma_P = 270.0 * MPa;
  in.method = column::Method::euler, in.n_st = 3.0;
  return in;
}

figure::Figure figure_of(const Input& in) {
  const auto figures = column::Buckling::figures(in, test::evaluated<column::Buckling>(in));
  REQUIRE(!figures.empty());
  REQUIRE(figures[0].id == "bar");
  check_drawn(figures[0]);
  return figures[0];
}

/// Twice the area of a closed outline.
double area_of(const std::vector<Point>& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice += figure::cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * std::fabs(twice);
}

}  // namespace

TEST_SUITE("column bar figure") {
  TEST_CASE("every end condition has its symbols, and the upper end lets the load move down") {
    const struct {
      Ends ends;
      std::vector<Sign> signs;
    } cases[] = {{Ends::pinned_pinned, {Sign::hinge, Sign::roller}}, {Ends::fixed_free, {Sign::clamp}},
                 {Ends::fixed_pinned, {Sign::clamp, Sign::roller}},  {Ends::fixed_fixed, {Sign::clamp, Sign::sleeve}},
                 {Ends::fixed_guided, {Sign::clamp, Sign::plate}},   {Ends::pinned_guided, {Sign::hinge, Sign::plate}}};
    for (const auto& c : cases) {
      const auto figure = figure_of(rod(c.ends));
      const auto& view = drawing_of(figure).views[0];
      std::vector<Sign> signs;
      for (const auto& support : view.supports) signs.push_back(support.kind);
      CHECK(signs == c.signs);
      CHECK(view.forces.at(0).force.y == doctest::Approx(-40e3));
      CHECK(view.names.at(0).value->si ==
            doctest::Approx(in_si(test::evaluated<column::Buckling>(rod(c.ends)).axes[0].s)));
    }
  }

  TEST_CASE("the buckled shape starts and ends at its supports, and passes through those between") {
    Input in = rod(Ends::pinned_pinned);
    in.supports_y.push_back({300.0 * mm});
    const auto figure = figure_of(in);
    const auto& view = drawing_of(figure).views[0];
    const auto line = paths_of(view, Drawing::Line::belt).at(0);
    for (const auto& support : view.supports) {
      double least = 1e300;
      for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distance_to_segment(support.at, line[i - 1], line[i]));
      CHECK(least < 1e-4);
    }
    CHECK(drawing_of(figure).views[1].supports.size() == 2);  // about z it is free between its ends
  }

  TEST_CASE("the section is drawn with the area that it is computed with") {
    Input in = rod(Ends::pinned_pinned);
    in.d_bore = 25.0 * mm;
    const auto area = [](const Input& input) {
      const auto figure = figure_of(input);
      const auto& a = drawing_of(figure).views.back().areas.at(0);
      return area_of(a.outline) - (a.hole.empty() ? 0.0 : area_of(a.hole));
    };
    CHECK(area(in) == doctest::Approx(in_si(test::evaluated<column::Buckling>(in).A)).epsilon(1e-3));
    in.d = in.d_bore = unset<Length>, in.h = 60.0 * mm, in.b = 20.0 * mm;
    CHECK(area(in) == doctest::Approx(1.2e-3));
    in.h = 200.0 * mm, in.b = 100.0 * mm, in.t_f = 8.5 * mm, in.t_w = 5.6 * mm, in.r = 12.0 * mm;  // IPE 200
    in.kind = SectionKind::rolled_I, in.A = 2850.0 * mm2;
    in.I_y = 19.43e6 * mm4, in.I_z = 1.42e6 * mm4;
    CHECK(area(in) == doctest::Approx(2.85e-3).epsilon(2e-3));
    CHECK(draw::is_to_scale(figure_of(in)));
    in.kind = SectionKind::channel;  // its centre is not known
    CHECK(drawing_of(figure_of(in)).views.back().areas.empty());
    CHECK_FALSE(draw::is_to_scale(figure_of(in)));
  }

  TEST_CASE("no buckled shape is drawn where a factor replaces the ends") {
    Input in = rod(Ends::unsaid);
    in.beta_y = 0.7, in.beta_z = 1.3;
    for (const auto& figure : column::Buckling::figures(in, test::evaluated<column::Buckling>(in)))
      CHECK(figure.id != "bar");
  }
}
