#include "calculators/section/built_up.hpp"

#include "calculators/section/polygon_moments.hpp"
#include "calculators/section/profile.hpp"
#include "calculators/section/properties/outline.hpp"
#include "calculators/section/shapes/angle.hpp"
#include "calculators/section/shapes/hollow.hpp"
#include "calculators/section/shapes/rectangle.hpp"
#include "calculators/section/shapes/tee.hpp"
#include "tests/calculators/section/sections.hpp"

using namespace loadpath;
using namespace loadpath::section;

namespace {

using Part = section::BuiltUp::Part;
using Shape = section::BuiltUp::Shape;

Part plate(double b, double h, double y, double z, double angle = 0.0) {
  Part p;
  p.shape = Shape::rectangle;
  p.b = b * mm, p.h = h * mm, p.y = y * mm, p.z = z * mm, p.angle = angle;
  return p;
}

Part rolled(const char* section, double y, double z, double angle = 0.0) {
  Part p;
  p.section = section;
  p.y = y * mm, p.z = z * mm, p.angle = angle;
  return p;
}

section::BuiltUp::Input of(std::initializer_list<Part> parts) {
  section::BuiltUp::Input in;
  for (const Part& p : parts) in.parts.push_back(p);
  return in;
}

FieldFault fault(const section::BuiltUp::Input& in) {
  for (const auto& rule : section::BuiltUp::rules) {
    if (rule.holds(in)) continue;
    return rule.particulars == nullptr ? FieldFault{"parts", say(rule.text), {}} : rule.particulars(in);
  }
  return {};
}

}  // namespace

TEST_SUITE("section built up") {
  TEST_CASE("a girder of three plates: 1.98e-4 m^4 after Calculeaf") {
    const auto p = solve<section::BuiltUp>(of({plate(180, 16, 0, 8), plate(12, 300, 0, 166), plate(200, 20, 0, 326)}));
    CHECK(std::abs(in_si(p.z_S) - 7.23 * 0.0254) < 0.005 * 0.0254);
    CHECK(std::abs(in_si(p.I_y) - 1.98e-4) < 0.005e-4);
  }

  TEST_CASE("second moments about axes turned by 30 deg: tutorial ME102, by Mohr's circle") {
    // Ix = 68.96, Iy = 132.48, Ixy = -21.6 turned by 30 deg; a part turned by -30 deg has the same about fixed axes
    const double x = 68.96, y = 132.48, xy = -21.6, turn = pi / 6.0;
    const double expected = 0.5 * (x + y) + 0.5 * (x - y) * std::cos(2.0 * turn) - xy * std::sin(2.0 * turn);
    section::Angle::Input in{80.0 * mm, 60.0 * mm, 8.0 * mm};
    const auto own = solve<section::Angle>(in);
    Part part;
    part.shape = Shape::angle;
    part.h = in.h, part.b = in.b, part.t = in.t, part.angle = -turn;
    const auto turned = solve<section::BuiltUp>(of({part}));
    const double c = std::cos(2.0 * turn), s = std::sin(2.0 * turn);
    const auto by_circle = 0.5 * (own.I_y + own.I_z) + 0.5 * c * (own.I_y - own.I_z) - s * own.I_yz;
    CHECK(rel(turned.I_y, by_circle) < 1e-12);
    CHECK(std::abs(expected - 103.55) < 0.05);
  }

  TEST_CASE("an angle rotated and moved is the integral over its rotated contour") {
    Part part;
    part.shape = Shape::angle;
    part.h = 80.0 * mm, part.b = 60.0 * mm, part.t = 8.0 * mm, part.angle = 0.4, part.y = 30.0 * mm,
    part.z = -20.0 * mm;
    Outline contour;
    const double c = std::cos(0.4), s = std::sin(0.4);
    for (const section::Place& p : angle_outline(part.h, part.b, part.t))
      contour.push_back({part.y + c * p.y - s * p.z, part.z + s * p.y + c * p.z});
    NoTrace trace;
    const Properties expected = centroidal(polygon_moments(contour, contour[0]), contour[0], trace);
    const auto built = solve<section::BuiltUp>(of({part}));
    CHECK(rel(built.A, expected.A) < 1e-12);
    CHECK(rel(built.y_S, expected.y_S) < 1e-12);
    CHECK(rel(built.z_S, expected.z_S) < 1e-12);
    CHECK(rel(built.I_y, expected.I_y) < 1e-11);
    CHECK(rel(built.I_z, expected.I_z) < 1e-11);
    CHECK(rel(built.I_yz, expected.I_yz) < 1e-11);
    CHECK(rel(built.parts[0].I_yz, expected.I_yz) < 1e-11);
  }

  TEST_CASE("an I of three plates, a box of four, a T of two are the shapes themselves") {
    const auto box = solve<section::BuiltUp>(
        of({plate(60, 5, 0, 47.5), plate(60, 5, 0, -47.5), plate(5, 90, 27.5, 0), plate(5, 90, -27.5, 0)}));
    const auto hollow = solve<section::Hollow>({100.0 * mm, 60.0 * mm, 5.0 * mm});
    CHECK(rel(box.I_y, hollow.I_y) < 1e-12);
    CHECK(rel(box.I_z, hollow.I_z) < 1e-12);
    CHECK(rel(box.W_y_top, hollow.W_y_top) < 1e-12);
    CHECK(box.I_t < hollow.I_t);  // the closed cell is not seen
    const auto tee = solve<section::BuiltUp>(of({plate(60, 8, 0, -4), plate(6, 72, 0, -44)}));
    CHECK(rel(tee.I_y, solve<section::Tee>({80.0 * mm, 60.0 * mm, 6.0 * mm, 8.0 * mm}).I_y) < 1e-12);
  }

  TEST_CASE("a rectangle with a hole is a hollow rectangle") {
    Part hole = plate(50, 90, 0, 0);
    hole.as = section::BuiltUp::As::hole;
    const auto p = solve<section::BuiltUp>(of({plate(60, 100, 0, 0), hole}));
    CHECK(rel(p.I_z, solve<section::Hollow>({100.0 * mm, 60.0 * mm, 5.0 * mm}).I_z) < 1e-12);
    CHECK_FALSE(is_set(p.I_t));
  }

  TEST_CASE("two channels back to back: twice I_y, and I_z by the parallel-axis theorem") {
    const auto* upn = find_profile("UPN 200");
    REQUIRE(upn != nullptr);
    const auto p = solve<section::BuiltUp>(of({rolled("UPN 200", 5, 0), rolled("upn200", -5, 0, pi)}));
    CHECK(rel(p.I_y, 2.0 * upn->I_y) < 1e-12);
    const Length e = upn->e_z + 5.0 * mm;
    CHECK(rel(p.I_z, 2.0 * (upn->I_z + upn->A * e * e)) < 1e-12);
    CHECK(std::abs(in_si(p.y_S)) < 1e-12);
    CHECK(rel(p.W_z_left, p.I_z / (upn->b + 5.0 * mm)) < 1e-12);
    CHECK(in_si(p.I_yz) == 0.0);
    CHECK(rel(p.I_t, 2.0 * upn->I_t) < 1e-12);
  }

  TEST_CASE("a section rotated with its parts keeps its principal values; rotated by 90 deg it swaps I_y and I_z") {
    const auto p = solve<section::BuiltUp>(of({rolled("L 100x100x10", 0, 0), plate(20, 100, 40, 30)}));
    const double turn = 0.5 * pi;
    const auto q = solve<section::BuiltUp>(of({rolled("L 100x100x10", 0, 0, turn), plate(20, 100, -30, 40, turn)}));
    CHECK(rel(p.I_max, q.I_max) < 1e-12);
    CHECK(rel(p.I_y, q.I_z) < 1e-12);
    CHECK(rel(p.I_yz, -1.0 * q.I_yz) < 1e-12);
  }

  TEST_CASE("missing data of a part are reported at their place") {
    Part circle;
    circle.shape = Shape::circle;
    CHECK(fault(of({plate(1, 1, 0, 0), circle})).path == "parts[2].d");
    CHECK(fault(of({circle})).message.text() == "'d' is missing: the shape 'circle' needs it");
    CHECK(fault(of({rolled("IPE 205", 0, 0)})).path == "parts[1].section");
    CHECK(fault(of({rolled("IPE 205", 0, 0)})).message.text() == "no section 'IPE 205' in the tables");
    CHECK(fault(of({Part{}})).message.text() == "give its 'shape', or name a 'section' of the tables");
    Part both = plate(1, 1, 0, 0);
    both.section = "IPE 200";
    CHECK(fault(of({both})).message.text() == "a part has a 'shape' or a 'section', not both");
    Part wall;
    wall.shape = Shape::hollow;
    wall.h = wall.b = 20.0 * mm, wall.t = 10.0 * mm;
    CHECK(fault(of({wall})).message.text() == "the walls must be thinner than half the section");
    Part hole = plate(2, 2, 0, 0);
    hole.as = section::BuiltUp::As::hole;
    CHECK(fault(of({plate(1, 1, 0, 0), hole})).message.text() ==
          "the holes leave no section: they remove more than the material, or lie outside of it");
    Part slit = plate(1, 900, 0, 0);
    slit.as = section::BuiltUp::As::hole;
    CHECK(fault(of({plate(100, 10, 0, 0), slit})).message.text() ==
          "the holes leave no section: they remove more than the material, or lie outside of it");
  }
}
