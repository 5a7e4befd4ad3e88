#include "lib/draw/page.hpp"
#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <doctest/doctest.h>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;

TEST_SUITE("draw") {
  TEST_CASE("a shaft carries its diameters, bore, lengths and torques") {
    const std::string text = drawn(stepped_shaft());
    for (const char* label : {"Ø50", "Ø70", "Ø55", "bore Ø20", "300", "500", "200", "1000", "T1 = 900 N·m"}) {
      CHECK_MESSAGE(says(text, label), label);
    }
    CHECK(count(text, "<rect class=\"plate ") == 3);
    CHECK(count(text, "<path class=\"centre\"") == 1);
    CHECK(count(text, "<path class=\"thin dash\"") == 1);
  }

  TEST_CASE("a positive torque points out of the page above, a negative one below") {
    Shaft shaft = stepped_shaft();
    for (const double torque : {5.0, -5.0}) {
      shaft.torques = {{0.5, torque, "T"}};
      const std::string text = drawn(shaft);
      const auto circles = elements(text, "circle");
      REQUIRE(circles.size() == 3);
      const auto dot = std::find_if(circles.begin(), circles.end(),
                                    [](const Element& e) { return attribute(e.tag, "class") == "f1"; });
      REQUIRE(dot != circles.end());
      const double middle = 0.5 * (number(circles.front().tag, "cy") + number(circles.back().tag, "cy"));
      CHECK((number(dot->tag, "cy") < middle) == (torque > 0.0));
    }
  }

  TEST_CASE("a taper is drawn as a taper, with both of its diameters") {
    Shaft shaft = stepped_shaft();
    shaft.parts[1].right = 0.055;
    const std::string text = drawn(shaft);
    CHECK(count(text, "<rect class=\"plate ") == 2);
    CHECK(count(text, "class=\"plate outline\" d=\"") == 1);
    CHECK(says(text, "Ø70…55"));
    CHECK(has(text, "length 500 mm, diameter 70 mm to 55 mm, bore 20 mm"));
    CHECK(overlap(text) == "");
  }

  TEST_CASE("a slender shaft is drawn thicker, with a note") {
    CHECK(says(drawn(stepped_shaft()), "in mm; diameters not to the scale of the lengths"));
    Shaft stout;
    stout.parts = {{0.1, 0.04, 0.0}, {0.08, 0.03, 0.0}};
    CHECK(says(drawn(stout), "in mm"));
  }

  TEST_CASE("a found diameter is marked; those of short segments are above the shaft, clear of torques") {
    Shaft shaft;
    shaft.parts = {{0.06, 0.028}, {0.012, 0.0355, 0.0, 0.0, true}, {0.042, 0.044023}, {0.104, 0.038}};
    shaft.torques = {{0.03, 89.93, "coupling"}, {0.093, -89.93, "pinion", 1150.0}};
    const std::string text = drawn(shaft);
    for (const char* label : {"Ø28", "Ø35.5*", "Ø44.02", "Ø38"}) CHECK_MESSAGE(says(text, label), label);
    CHECK(says(text, "pinion: −89.93 N·m, 1150 N"));
    CHECK(!has(text, "rotate"));
    CHECK(overlap(text) == "");
  }

  TEST_CASE("neighbouring torques are written in rows") {
    Shaft shaft = stepped_shaft();
    shaft.torques = {{0.50, 1.5, "T_1"}, {0.52, -1.5, "T_2"}, {0.54, 2.5, "T_3"}};
    CHECK(overlap(drawn(shaft)) == "");
  }

  TEST_CASE("bearings are drawn under the shaft, the locating one on hatched ground") {
    Shaft shaft = stepped_shaft();
    shaft.bearings = {{0.1, true, "left"}, {0.9, false, "right"}};
    const std::string text = drawn(shaft);
    CHECK(count(text, "class=\"pin\"") == 2);
    CHECK(says(text, "left"));
    CHECK(has(text, "bearing right at 900 mm"));
    CHECK(overlap(text) == "");
    shaft.bearings[1].force = 3860.0;
    shaft.torques[0].force = 1150.0;
    const std::string loaded = drawn(shaft);
    CHECK(says(loaded, "3860 N"));
    CHECK(has(loaded, "N·m, 1150 N"));
    CHECK(has(loaded, "bearing right at 900 mm: 3860 N"));
    CHECK(overlap(loaded) == "");
  }

  TEST_CASE("known bearings are boxes with a cross and a name in place of a support, on the scale of the shaft") {
    Shaft shaft;
    shaft.parts = {{0.1, 0.04, 0.0}, {0.1, 0.05, 0.0}};
    shaft.bearings = {{0.02, true, "left", 3007.0, {2642.0, 0.0}, 1199.0, {0.02, 0.023, 0.09}, "6308"},
                      {0.18, false, "right"}};
    const std::string text = drawn(shaft);
    CHECK(says(text, "left: 6308, locating"));
    CHECK(says(text, "3007 N, axial 1199 N"));
    CHECK(count(text, "<rect class=\"pin\"") == 2);
    CHECK(count(text, "<path class=\"pin\"") == 1);  // the support of the other
    const auto rectangles = elements(text, "rect");
    const auto of_class = [&](const char* name) {
      return *std::find_if(rectangles.begin(), rectangles.end(),
                           [&](const Element& e) { return attribute(e.tag, "class") == name; });
    };
    const double of_shaft = number(of_class("plate outline").tag, "width") / 0.1;
    CHECK(number(of_class("pin").tag, "width") / 0.023 == doctest::Approx(of_shaft).epsilon(0.01));
    CHECK(number(of_class("pin").tag, "height") / 0.025 == doctest::Approx(of_shaft).epsilon(0.02));  // (D - d)/2
    CHECK(overlap(text) == "");
  }

  TEST_CASE("hubs are drawn up to their diameter, large ones up to a break line") {
    Shaft shaft;
    shaft.parts = {{0.2, 0.05, 0.0}};
    shaft.torques = {{0.05, 100.0, "pinion", 0.0, {}, 0.0, {0.05, 0.04, 0.07}}};
    CHECK(count(drawn(shaft), "<path class=\"image\"") == 2);
    const auto corners = [&] {
      const std::string text = drawn(shaft);
      const auto all = elements(text, "path");
      const auto hub =
          std::find_if(all.begin(), all.end(), [](const Element& e) { return attribute(e.tag, "class") == "image"; });
      REQUIRE(hub != all.end());
      return std::string(attribute(hub->tag, "d")).size();
    };
    const std::size_t closed = corners();
    shaft.torques[0].outline.diameter = 0.4;
    CHECK(corners() > 2 * closed);
    shaft.torques[0].outline.width = 0.0;
    CHECK(count(drawn(shaft), "class=\"image\"") == 0);
  }

  TEST_CASE("forces in two planes are drawn from the right end, in one plane not") {
    Shaft shaft;
    shaft.parts = {{0.2, 0.05, 0.0}};
    shaft.seen_from_end = true;
    shaft.torques = {{0.1, 0.0, "gear", 500.0, {300.0, 400.0}, -50.0}};
    shaft.bearings = {{0.0, true, "left", 250.0, {-150.0, -200.0}}, {0.2, false, "right", 250.0, {-150.0, -200.0}}};
    const std::string flat = drawn(shaft);
    CHECK(says(flat, "gear: 500 N, axial −50 N"));
    CHECK(!says(flat, "seen from the right end"));
    shaft.torques.push_back({0.15, 0.0, "pulley", 100.0, {100.0, 0.0}});
    const std::string text = drawn(shaft);
    CHECK(says(text, "seen from the right end"));
    CHECK(has(text, "viewBox=\"0 0 624 "));
    shaft.seen_from_end = false;
    CHECK(has(drawn(shaft), "viewBox=\"0 0 480 "));
    CHECK(overlap(text) == "");
  }

  TEST_CASE("short segments keep their dimensions apart") {
    Shaft shaft;
    for (int i = 0; i < 12; ++i) shaft.parts.push_back({i % 2 == 0 ? 0.1 : 0.004, i % 2 == 0 ? 0.05 : 0.07, 0.0});
    CHECK(overlap(drawn(shaft)) == "");
  }

  TEST_CASE("the diagrams of a shaft are below it on its scale, and a line goes through all at the governing section") {
    Shaft shaft = stepped_shaft();
    shaft.diagrams = {torque_plot(), torque_plot()};
    shaft.places = {{0.3, "yield: left"}, {0.35, "fatigue: groove"}};
    const std::string text = drawn(shaft);
    CHECK(overlap(text) == "");
    CHECK(says(text, "yield: left"));
    CHECK(says(text, "fatigue: groove"));
    CHECK(count(text, "<path class=\"light dash c1\"") == 4);  // on the shaft, and through its diagrams
    CHECK(count(text, "class=\"area f0\"") == 2);
    CHECK(has(text, "torque T in N·m over x in mm"));
    const auto plates = elements(text, "rect");
    const auto first = std::find_if(plates.begin(), plates.end(),
                                    [](const Element& e) { return attribute(e.tag, "class") == "plate outline"; });
    REQUIRE(first != plates.end());
    CHECK(has(text, "<path class=\"area f0\" d=\"M" + std::string(attribute(first->tag, "x"))));
  }

  TEST_CASE("above diagrams hubs and bearings of known size are drawn in a file, not in a page") {
    Shaft shaft = stepped_shaft();
    shaft.diagrams.push_back({{"z", "position along the shaft", "mm"}, {"T", "torque", "N*m"}});
    shaft.torques = {{0.5, 900.0, "wheel", 0.0, {}, 0.0, {0.5, 0.1, 0.2}}};
    shaft.bearings = {{0.1, true, "left"}, {0.9, false, "right"}};
    const std::string page = svg_in_page({"shaft", "A shaft", shaft});
    CHECK(count(page, "class=\"image\"") == 0);
    for (auto& bearing : shaft.bearings) bearing.outline = {bearing.x, 0.03, 0.12};
    const std::string file = drawn(shaft);
    CHECK(count(file, "<rect class=\"pin") == 4);  // above and below the axis
    CHECK(count(file, "class=\"image\"") == 2);
    CHECK(overlap(file) == "");
  }

  TEST_CASE("a shaft without segments states so") { CHECK(says(drawn(Shaft{}), "not available")); }
}
