#include "lib/draw/dxf.hpp"

#include "tests/lib/draw/figures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace loadpath;

namespace {

/// An entity: its kind, and its values by their code.
struct Entity {
  std::string kind;
  std::map<int, std::string> values;
  [[nodiscard]] double number(int code) const { return std::stod(values.at(code)); }
};

std::vector<Entity> entities_of(const std::string& text) {
  std::vector<Entity> entities;
  std::istringstream lines(text);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    if (code == "0")
      entities.push_back({value, {}});
    else if (!entities.empty())
      entities.back().values[std::stoi(code)] = value;
  }
  return entities;
}

std::vector<Entity> on_layer(const std::string& text, const char* kind, const std::string& layer) {
  std::vector<Entity> found = entities_of(text);
  std::erase_if(found, [&](const Entity& e) { return e.kind != kind || e.values.at(8) != layer; });
  return found;
}

figure::Scheme slider_crank() {
  figure::Scheme scheme;
  scheme.bodies = {
      {"crank", {{0.0, 0.0}, {0.03, 0.04}}}, {"slider", {{0.2, 0.0}}}, {"plate", {{0.0, 0.0}, {0.1, 0.0}, {0.0, 0.1}}}};
  scheme.joints = {{"O", {0.0, 0.0}, figure::Scheme::Pin::revolute, true},
                   {"B", {0.2, 0.0}, figure::Scheme::Pin::slider}};
  scheme.guides = {{{0.1, 0.0}, {0.3, 0.0}, true}};
  return scheme;
}

}  // namespace

TEST_SUITE("dxf") {
  TEST_CASE("it is a complete R12 file: version, layers, entities, end") {
    const std::string text = draw::dxf_of(slider_crank());
    CHECK(text.starts_with("999\nlengths in mm\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"));
    CHECK(text.ends_with("0\nENDSEC\n0\nEOF\n"));
    std::string layers;
    for (const Entity& e : entities_of(text)) {
      if (e.kind == "LAYER") layers += e.values.at(2) + " ";
    }
    CHECK(layers == "pins guides crank slider plate ");
  }

  TEST_CASE("a bar is a line in mm, a plate its outline, a slider a block, a pin a circle") {
    const std::string text = draw::dxf_of(slider_crank());
    const auto crank = on_layer(text, "LINE", "crank");
    REQUIRE(crank.size() == 1);
    CHECK(crank[0].number(11) == doctest::Approx(30.0));
    CHECK(crank[0].number(21) == doctest::Approx(40.0));
    CHECK(on_layer(text, "LINE", "plate").size() == 3);
    CHECK(on_layer(text, "LINE", "slider").size() == 4);
    CHECK(on_layer(text, "CIRCLE", "pins").size() == 1);
    CHECK(on_layer(text, "CIRCLE", "pins")[0].number(40) == doctest::Approx(4.0));
    REQUIRE(on_layer(text, "LINE", "guides").size() == 1);
    CHECK(on_layer(text, "LINE", "guides")[0].number(10) == doctest::Approx(100.0));
  }

  TEST_CASE("an element without a place is left out, and every number is finite") {
    figure::Scheme scheme = slider_crank();
    scheme.bodies[0].points[1].x = std::nan("");
    scheme.guides[0].to.y = INFINITY;
    const std::string text = draw::dxf_of(scheme);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find("inf") == std::string::npos);
    CHECK(on_layer(text, "LINE", "guides").empty());
    CHECK(draw::dxf_of({}).ends_with("EOF\n"));
  }
}
