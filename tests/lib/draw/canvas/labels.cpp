#include "lib/draw/canvas/labels.hpp"

#include <doctest/doctest.h>

using namespace loadpath::draw;
using namespace loadpath::figure;

TEST_SUITE("draw") {
  TEST_CASE("a label takes the cheapest place that is free") {
    Labels labels({0, 0, 100, 100});
    const std::vector<Candidate> places{{{10, 10, 30, 20}, 0.0}, {{10, 40, 30, 50}, 1.0}, {{10, 70, 30, 80}, 2.0}};
    CHECK(labels.place(places).top == 10.0);
    CHECK(labels.place(places).top == 40.0);
    labels.keep_off({{0, 75}, {100, 75}});
    CHECK_FALSE(labels.place_free(places).has_value());
  }

  TEST_CASE("a line that only passes by does not block a place, one that ends inside does") {
    const std::vector<Candidate> place{{{40, 40, 60, 60}, 0.0}};
    struct Row {
      Point from, to;
      bool free;
    };
    const Row rows[] = {{{0, 20}, {100, 20}, true}, {{0, 0}, {100, 100}, false}, {{50, 50}, {51, 50}, false},
                        {{0, 95}, {95, 0}, false},  {{50, 0}, {50, 30}, true},   {{0, 61.5}, {100, 61.5}, false},
                        {{0, 70}, {30, 100}, true}};
    for (const Row& row : rows) {
      Labels labels({0, 0, 100, 100});
      labels.keep_off({row.from, row.to}, 2.0);
      CHECK(labels.place_free(place).has_value() == row.free);
    }
  }

  TEST_CASE("a place outside the area is the last choice") {
    Labels labels({0, 0, 100, 100});
    labels.keep_off(Box{0, 0, 50, 50});
    CHECK(labels.place({{{90, 10, 110, 20}, 0.0}, {{10, 10, 30, 20}, 5.0}}).left == 10.0);
  }

  TEST_CASE("places around a point are clear of its circle") {
    for (const Candidate& c : around({50, 50}, 8.0, 40.0)) {
      const double dx = std::max({c.box.left - 50.0, 0.0, 50.0 - c.box.right});
      const double dy = std::max({c.box.top - 50.0, 0.0, 50.0 - c.box.bottom});
      CHECK(std::hypot(dx, dy) >= 8.0 - 1e-9);
    }
  }

  TEST_CASE("places next to a line do not touch it") {
    for (const Point to : {Point{90, 50}, Point{50, 90}, Point{80, 20}, Point{10, 30}}) {
      for (const Candidate& c : along_segment({50, 50}, to, 3.0, 40.0)) {
        Labels labels({-1e3, -1e3, 1e3, 1e3});
        labels.keep_off({{50, 50}, to}, 1.0);
        CHECK(labels.place_free({c}).has_value());
      }
    }
  }
}
