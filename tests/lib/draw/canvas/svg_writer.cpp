#include "lib/draw/canvas/svg_writer.hpp"

#include "lib/draw/canvas/picture.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath::draw;

namespace {

/// A dimension: a line with an arrowhead at each end.
void add_dimension(Canvas& canvas, double y) {
  canvas.line("thin", {0.0, y}, {30.126, y});
  canvas.polygon("solid", {{0.0, y}, {7.0, y - 2.0}, {7.0, y + 2.0}});
  canvas.polygon("solid", {{30.126, y}, {23.126, y + 2.0}, {23.126, y - 2.0}});
}

std::size_t paths_in(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1)) ++count;
  return count;
}

Picture picture_of(Canvas canvas) {
  Picture picture;
  picture.canvas = std::move(canvas);
  return picture;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("a page has the lines of all dimensions in one path and their arrowheads in another") {
    Canvas canvas;
    add_dimension(canvas, 10.0);
    canvas.text("", {15.0, 8.0}, {});
    add_dimension(canvas, 20.0);
    const std::string page = svg_part(picture_of(canvas), "t");
    CHECK(paths_in(page) == 2);
    CHECK(page.find("d=\"M0 10h30.1M0 20h30.1\"") != std::string::npos);
    CHECK(paths_in(svg_file(picture_of(canvas), "t")) == 6);
  }

  TEST_CASE("lines below the objects that cover them are not moved above these, nor those of a group") {
    Canvas covered;
    add_dimension(covered, 10.0);
    covered.rectangle("plate", {0.0, 0.0, 30.0, 30.0});
    add_dimension(covered, 20.0);
    CHECK(paths_in(svg_part(picture_of(covered), "t")) == 4);
    Canvas moving;
    moving.begin_group({});
    add_dimension(moving, 10.0);
    moving.end_group();
    const std::string page = svg_part(picture_of(moving), "t");
    CHECK(paths_in(page) == 3);
    CHECK(page.find("l30.13 0") != std::string::npos);
  }
}
