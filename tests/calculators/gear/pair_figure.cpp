// Gears as drawn: flanks touch on the line of action, the path of contact ends on the tip circles.
#include "calculators/gear/pair.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using figure::Point;
using gear::Mesh;
using gear::Turns;

namespace {

using Input = gear::Pair::Input;

constexpr auto solve = test::evaluated<gear::Pair>;

Input pair_of(int z_1, int z_2, Mesh mesh = Mesh::external) {
  Input in;
  in.z_1 = z_1, in.z_2 = z_2, in.m_n = 2.5 * mm, in.mesh = mesh;
  return in;
}

figure::Figure figure_of(const Input& in) {
  const auto figures = gear::Pair::figures(in, solve(in));
  REQUIRE(figures.size() == 1);
  check_drawn(figures[0]);
  return figures[0];
}

/// The path of contact in the view of the mesh, from where it begins to where it ends.
std::vector<Point> contact_of(const figure::Figure& figure) {
  return paths_of(drawing_of(figure).views.at(1), Drawing::Line::contact).at(0);
}

Point axis_2(const Input& in) {
  const double a = in_si(solve(in).a_w);
  return {in.mesh == Mesh::internal ? -a : a, 0.0};
}

/// Where the outline crosses the path.
std::vector<Point> crossings(const std::vector<Point>& outline, Point from, Point to) {
  std::vector<Point> found;
  const Point e = to - from;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point p = outline[i], q = outline[(i + 1) % outline.size()];
    const double a = figure::cross(e, p - from), b = figure::cross(e, q - from);
    if ((a < 0.0) == (b < 0.0)) continue;
    const Point x = p + a / (a - b) * (q - p);
    const double t = figure::dot(x - from, e) / figure::dot(e, e);
    if (t > 0.0 && t < 1.0) found.push_back(x);
  }
  return found;
}

}  // namespace

TEST_SUITE("gear pair figure") {
  TEST_CASE("the path of contact begins at the tip of gear 2 and ends at that of gear 1") {
    for (const Mesh mesh : {Mesh::external, Mesh::internal}) {
      for (const Turns turns : {Turns::ccw, Turns::cw}) {
        Input in = pair_of(20, 57, mesh);
        in.turns = turns, in.x_1 = 0.2;
        const auto r = solve(in);
        const auto contact = contact_of(figure_of(in));
        CHECK(figure::length(contact[0] - axis_2(in)) == doctest::Approx(in_si(r.d_a2) / 2.0).epsilon(1e-6));
        CHECK(figure::length(contact[1]) == doctest::Approx(in_si(r.d_a1) / 2.0).epsilon(1e-6));
        CHECK(figure::length(contact[1] - contact[0]) == doctest::Approx(in_si(r.g_alpha)));
        CHECK((contact[1].y > 0.0) == (turns == Turns::ccw));  // the contact moves as the flanks do
      }
    }
  }

  TEST_CASE("the driving flanks touch on the path of contact, with backlash too") {
    for (const double beta : {0.0, 15.0}) {
      for (const Turns turns : {Turns::ccw, Turns::cw}) {
        for (Input in : {pair_of(20, 57), pair_of(20, 20), pair_of(20, 21), pair_of(20, 57, Mesh::internal),
                         pair_of(25, 0, Mesh::rack)}) {
          in.beta = beta * deg.one, in.turns = turns, in.A_s1 = -0.15 * mm;
          CAPTURE(in.z_2);
          const auto figure = figure_of(in);
          const auto contact = contact_of(figure);
          std::vector<std::vector<Point>> outlines;
          for (const auto& path : drawing_of(figure).views[1].paths) {
            if (path.closed && path.line == Drawing::Line::outline) outlines.push_back(path.points);
          }
          REQUIRE(outlines.size() == 2);
          int touching = 0;
          for (const Point p : crossings(outlines[0], contact[0], contact[1]))
            touching += distance_to(p, outlines[1]) < 0.006e-3 ? 1 : 0;
          CHECK(touching >= 1);  // the contact ratio is above one
        }
      }
    }
  }

  TEST_CASE("the working circles meet in the pitch point, and the angle there is the working pressure angle") {
    Input in = pair_of(20, 57);
    in.x_1 = -0.2, in.x_2 = -0.3;
    const auto r = solve(in);
    const auto figure = figure_of(in);
    const auto& view = drawing_of(figure).views[1];
    const Point C = view.names.at(0).at;
    CHECK(C.x == doctest::Approx(in_si(r.d_w1) / 2.0));
    CHECK(C.x + in_si(r.d_w2) / 2.0 == doctest::Approx(in_si(r.a_w)));
    CHECK(std::fabs(view.angles.at(0).sweep) == doctest::Approx(r.alpha_wt));
    const auto contact = contact_of(figure);
    const Point e = unit(contact[1] - contact[0]);
    CHECK(std::fabs(std::asin(e.x)) == doctest::Approx(r.alpha_wt));
    // It is a tangent of both base circles.
    CHECK(std::fabs(figure::cross(e, C)) == doctest::Approx(in_si(r.d_b1) / 2.0));
    CHECK(std::fabs(figure::cross(e, C - axis_2(in))) == doctest::Approx(in_si(r.d_b2) / 2.0));
  }

  TEST_CASE("the force of the flanks on gear 1 points along the line of action, against the motion of the contact") {
    for (const Turns turns : {Turns::ccw, Turns::cw}) {
      for (const Mesh mesh : {Mesh::external, Mesh::internal}) {
        Input in = pair_of(20, 57, mesh);
        in.turns = turns, in.T_1 = 60.0 * N_m, in.b = 28.0 * mm;
        const auto figure = figure_of(in);
        Point sum;
        for (const auto& f : drawing_of(figure).views[0].forces) sum = sum + f.force;
        const auto contact = contact_of(figure);
        CHECK(figure::dot(unit(sum), unit(contact[1] - contact[0])) == doctest::Approx(-1.0));
      }
    }
  }

  TEST_CASE("external gears turn in opposite directions, a pinion in a ring gear in the same") {
    const auto turns = [](const Input& in) {
      const auto t = drawing_of(figure_of(in)).views[0].turns;
      return t.at(0).counter_clockwise == t.at(1).counter_clockwise;
    };
    CHECK_FALSE(turns(pair_of(20, 57)));
    CHECK(turns(pair_of(20, 57, Mesh::internal)));
  }

  TEST_CASE("unusual pairs: equal, one tooth more, a close ring gear, very fine, with a rack") {
    for (Input in : {pair_of(20, 20), pair_of(20, 21), pair_of(40, 50, Mesh::internal), pair_of(20, 1500),
                     pair_of(60, 0, Mesh::rack), pair_of(8, 200)}) {
      if (in.z_1 == 8) in.x_1 = 0.5;
      figure_of(in);
    }
  }
}
