// The sections of vessels: walls as thick as given, surfaces where the radii say, whatever the shape.
#include "calculators/vessel/section.hpp"

#include "calculators/vessel/cone.hpp"
#include "calculators/vessel/cylinder.hpp"
#include "calculators/vessel/ellipsoid.hpp"
#include "calculators/vessel/shell.hpp"
#include "calculators/vessel/sphere.hpp"
#include "calculators/vessel/torus.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using figure::Point;
using tests::solve;
using vessel::Measured;

namespace {

template <class C>
figure::Figure section_of(const typename C::Input& in) {
  const auto figures = C::figures(in, solve<C>(in));
  REQUIRE(!figures.empty());
  REQUIRE(figures[0].id == "section");
  check_drawn(figures[0]);
  return figures[0];
}

const Drawing::Area& wall_of(const figure::Figure& figure) {
  for (const auto& area : drawing_of(figure).views[0].areas) {
    if (area.kind == Drawing::Kind::cut) return area;
  }
  FAIL("no wall");
  return drawing_of(figure).views[0].areas[0];
}

template <class Input>
Input loaded(double p_mpa) {
  Input in;
  in.p = p_mpa * MPa, in.sigma_adm = 140.0 * MPa;
  return in;
}

}  // namespace

TEST_SUITE("vessel section") {
  TEST_CASE("the walls of a sphere are as thick as ordered, from the surface that the radius belongs to") {
    for (const Measured measured : {Measured::inner, Measured::mean, Measured::outer}) {
      auto in = loaded<vessel::Sphere::Input>(4.0);
      in.R = 600.0 * mm, in.delta = 20.0 * mm, in.c = 2.0 * mm, in.measured = measured;
      const figure::Figure figure = section_of<vessel::Sphere>(in);
      const Drawing::Area& wall = wall_of(figure);
      REQUIRE(!wall.hole.empty());
      const double inside = measured == Measured::inner ? 0.6 : measured == Measured::outer ? 0.58 : 0.59;
      // The axis of the drawing runs through the lowest place of the middle of the carrying wall.
      const double R_m = in_si(solve<vessel::Sphere>(in).R_m);
      for (const Point p : wall.hole) CHECK(std::hypot(p.x, p.y - R_m) == doctest::Approx(inside).epsilon(2e-4));
      for (const Point p : wall.outline)
        CHECK(std::hypot(p.x, p.y - R_m) == doctest::Approx(inside + 0.02).epsilon(2e-4));
    }
  }

  TEST_CASE("an ellipsoid and a shell of points have a constant thickness") {
    auto in = loaded<vessel::Ellipsoid::Input>(2.0);
    in.a = 600.0 * mm, in.b = 300.0 * mm, in.delta = 15.0 * mm;
    const Drawing::Area wall = wall_of(section_of<vessel::Ellipsoid>(in));
    const std::size_t half = wall.outline.size() / 2;
    const std::vector<Point> outer(wall.outline.begin(), wall.outline.begin() + static_cast<std::ptrdiff_t>(half));
    for (std::size_t i = half + 2; i + 2 < wall.outline.size(); ++i) {
      double least = 1e300;
      for (std::size_t k = 1; k < outer.size(); ++k)
        least = std::min(least, distance_to_segment(wall.outline[i], outer[k - 1], outer[k]));
      CHECK(least == doctest::Approx(0.015).epsilon(0.01));
    }
  }

  TEST_CASE("the enlarged wall is labelled with its parts: ordered, corrosion, mill tolerance, load-carrying") {
    auto in = loaded<vessel::Cylinder::Input>(1.6);
    in.R = 600.0 * mm, in.c = 1.0 * mm, in.c_t = 0.3 * mm;
    for (const Measured measured : {Measured::inner, Measured::mean, Measured::outer}) {
      in.measured = measured;
      const auto r = solve<vessel::Cylinder>(in);
      const figure::Figure figure = section_of<vessel::Cylinder>(in);
      const auto& view = drawing_of(figure).views[1];
      std::string symbols;
      for (const auto& l : view.lengths) symbols += l.value.symbol + " ";
      CHECK(symbols == "delta delta_c c c_t ");
      double sum = 0.0;
      for (const auto& l : view.lengths) sum += l.value.symbol == "delta" ? 0.0 : l.value.si;
      CHECK(sum == doctest::Approx(in_si(r.delta)));
      // The middle of what carries lies as far from the given surface as the calculator has it.
      const auto carries = view.lengths[1];
      const double measured_at = paths_of(view, Drawing::Line::centre)[0][0].x;
      CHECK(0.5 * (carries.from.x + carries.to.x) - measured_at == doctest::Approx(in_si(r.R_m) - 0.6).epsilon(1e-6));
    }
  }

  TEST_CASE("a liquid fills the inside up to its height") {
    auto in = loaded<vessel::Sphere::Input>(0.05);
    in.R = 600.0 * mm, in.rho = 1000.0 * vessel::kg_per_m3;
    for (const double h_mm : {1.0, 300.0, 600.0, 1199.0}) {
      in.h_l = h_mm * mm;
      const auto figure = section_of<vessel::Sphere>(in);
      const auto& view = drawing_of(figure).views[0];
      REQUIRE(view.surfaces.size() == 1);
      CHECK(view.surfaces[0].from.y == doctest::Approx(1e-3 * h_mm));
      for (const auto& area : view.areas) {
        if (area.kind != Drawing::Kind::liquid) continue;
        for (const Point p : area.outline) CHECK(p.y <= 1e-3 * h_mm + 1e-12);
      }
    }
    in.h_l = 0.0 * mm;
    CHECK(drawing_of(section_of<vessel::Sphere>(in)).views[0].surfaces.empty());
  }

  TEST_CASE("the pressure acts on the inside, outwards") {
    auto in = loaded<vessel::Sphere::Input>(4.0);
    in.R = 600.0 * mm;
    const auto figure = section_of<vessel::Sphere>(in);
    const auto& pressure = drawing_of(figure).views[0].pressures.at(0);
    CHECK(pressure.value.si == doctest::Approx(4e6));
    CHECK(pressure.arrows.size() == 14);
    for (const auto& a : pressure.arrows) {
      const Point from_centre = a.foot - Point{0.0, in_si(solve<vessel::Sphere>(in).R_m)};
      CHECK(figure::dot(unit(from_centre), unit(a.direction)) > 0.999);
    }
  }

  TEST_CASE("unusual vessels: a film, a thick pipe, tall and flat, a torus that almost closes, rings around") {
    auto pipe = loaded<vessel::Cylinder::Input>(60.0);
    pipe.R = 50.0 * mm, pipe.f_t = 0.125, pipe.ends = vessel::Cylinder::Ends::open;
    section_of<vessel::Cylinder>(pipe);
    auto film = loaded<vessel::Cylinder::Input>(0.001);
    film.R = 10000.0 * mm;
    section_of<vessel::Cylinder>(film);
    auto tall = loaded<vessel::Cylinder::Input>(0.0);
    tall.R = 300.0 * mm, tall.rho = 1000.0 * vessel::kg_per_m3, tall.h_l = 40.0 * m;
    section_of<vessel::Cylinder>(tall);
    tall.h_l = 5.0 * mm;
    section_of<vessel::Cylinder>(tall);
    tall.ends = vessel::Cylinder::Ends::ringed, tall.h_l = 2.0 * m;
    tall.A_r = 400.0 * mm2, tall.l_r = 200.0 * mm;
    section_of<vessel::Cylinder>(tall);
    auto cone = loaded<vessel::Cone::Input>(0.5);
    for (const double degrees : {1.0, 30.0, 80.0}) {
      cone.R = 800.0 * mm, cone.alpha = degrees * deg.one;
      section_of<vessel::Cone>(cone);
    }
    auto head = loaded<vessel::Ellipsoid::Input>(0.5);
    for (const double b_mm : {125.0, 600.0, 2900.0}) {
      head.a = 600.0 * mm, head.b = b_mm * mm;
      section_of<vessel::Ellipsoid>(head);
    }
    auto ring = loaded<vessel::Torus::Input>(2.0);
    ring.r = 200.0 * mm;
    for (const double R_0_mm : {215.0, 1000.0, 40000.0}) {
      ring.R_0 = R_0_mm * mm;
      section_of<vessel::Torus>(ring);
    }
    auto shell = loaded<vessel::Shell::Input>(0.5);
    shell.points.push_back({300.0 * mm, 0.0 * mm});
    shell.points.push_back({400.0 * mm, 200.0 * mm});
    shell.points.push_back({500.0 * mm, 400.0 * mm});
    section_of<vessel::Shell>(shell);
  }
}
