#include "calculators/vessel/ends/flat.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/draw/drawing/drawings.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::draw::test;
using figure::Drawing;
using Flat = vessel::FlatEnd;

TEST_SUITE("flat end figure") {
  TEST_CASE("a flat end is drawn to scale with its thickness, its corrosion and the diameter under pressure") {
    for (const auto attachment : {Flat::Attachment::welded, Flat::Attachment::integral, Flat::Attachment::bolted}) {
      for (const double c : {0.0, 2.0}) {
        CAPTURE(c);
        Flat::Input in;
        in.p = 1.0 * MPa, in.D_i = 600.0 * mm, in.delta = 30.0 * mm, in.c = c * mm;
        in.R_e = 265.0 * MPa, in.R_m = 410.0 * MPa, in.attachment = attachment;
        const auto figure = Flat::figures(in, test::evaluated<Flat>(in)).at(0);
        check_drawn(figure);
        const auto& view = drawing_of(figure).views[0];
        CHECK(view.lengths.size() == (c > 0.0 ? 3 : 2));
        CHECK(view.lengths[0].value.si == doctest::Approx(0.6));
        CHECK(view.lengths[1].value.si == doctest::Approx(0.03));
        for (const auto& arrow : view.pressures[0].arrows) {
          CHECK(arrow.foot.y == 0.0);  // on the inside of the end
          CHECK(arrow.direction.y > 0.0);
        }
      }
    }
  }
}
