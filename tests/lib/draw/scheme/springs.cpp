// Springs, dampers, welds and hodographs as pictures.
#include "lib/draw/svg.hpp"
#include "lib/figure/figure.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

namespace {

using namespace loadpath::draw;
using namespace loadpath::figure;

std::string drawn(Scheme scheme) { return svg({"scheme", "A mechanism", std::move(scheme)}); }

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Scheme with_spring(bool pulls, bool damps) {
  Scheme scheme;
  scheme.bodies.push_back({"arm", {{0.0, 0.0}, {0.1, 0.0}}});
  scheme.springs.push_back({"s", {0.1, 0.0}, {0.2, 0.05}, pulls, damps});
  return scheme;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("a spring is a zigzag, a damper a cylinder with its piston, both side by side") {
    const std::string spring = drawn(with_spring(true, false)), damper = drawn(with_spring(false, true)),
                      both = drawn(with_spring(true, true));
    const std::string piston = "class=\"rail\"";
    CHECK(count_of(spring, piston) == 0);
    CHECK(count_of(damper, piston) == 1);
    CHECK(count_of(both, piston) == 1);
    CHECK(spring.find("spring s") != std::string::npos);
    CHECK(damper.find("damper s") != std::string::npos);
  }

  TEST_CASE("an element without a place is left out, and a spring without length draws no NaN") {
    Scheme scheme = with_spring(true, true);
    scheme.springs.push_back({"lost", {std::numeric_limits<double>::quiet_NaN(), 0.0}, {0.1, 0.0}});
    scheme.springs.push_back({"none", {0.1, 0.0}, {0.1, 0.0}});
    scheme.coils.push_back({"c", {0.0, std::numeric_limits<double>::infinity()}});
    const std::string picture = drawn(scheme);
    CHECK(picture.find("nan") == std::string::npos);
    CHECK(picture.find("inf") == std::string::npos);
    CHECK(picture.find("lost") == std::string::npos);
  }

  TEST_CASE("a weld is a filled corner and not a pin") {
    Scheme scheme;
    scheme.bodies.push_back({"a", {{0.0, 0.0}, {0.1, 0.0}}});
    scheme.bodies.push_back({"b", {{0.0, 0.0}, {0.0, 0.1}}});
    scheme.joints.push_back({"W", {0.0, 0.0}, Scheme::Pin::welded, false, 0.785});
    const std::string picture = drawn(scheme);
    CHECK(count_of(picture, "<circle") == 0);
    CHECK(count_of(picture, "class=\"solid\"") == 1);
    CHECK(picture.find("weld W") != std::string::npos);
  }

  TEST_CASE("a hodograph has its curve, its marks and its largest vector") {
    Plan plan;
    plan.unit = "N";
    plan.vectors.push_back({{}, {100.0, 0.0}, "R"});
    plan.traces.push_back({{{100.0, 0.0}, {0.0, 50.0}, {-100.0, 0.0}, {100.0, 0.0}},
                           {{{0.0, 50.0}, "30", false}, {{100.0, 0.0}, "0", true}}});
    const std::string picture = svg({"hodograph", "A hodograph", Plans{{plan}}});
    CHECK(count_of(picture, "curve c1") == 1);
    CHECK(picture.find(">30<") != std::string::npos);
    plan.traces[0].points[1].x = std::numeric_limits<double>::quiet_NaN();
    CHECK(svg({"hodograph", "A hodograph", Plans{{plan}}}).find("nan") == std::string::npos);
  }
}
