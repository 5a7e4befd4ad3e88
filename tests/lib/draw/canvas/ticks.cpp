#include "lib/draw/canvas/ticks.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath::draw;

namespace {

std::string tick_texts(const Axis& a) {
  std::string all;
  for (const double t : a.ticks) all += (all.empty() ? "" : " ") + a.text(t);
  return all;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("ticks are at multiples of 1, 2 and 5, of angles at 30, 45, 60 and 90") {
    struct Row {
      Range data;
      int most;
      Steps steps;
      const char* expected;
    };
    const Row rows[] = {
        {{-86, 32}, 6, Steps::decimal, "-100 -80 -60 -40 -20 0 20 40"},
        {{0, 1}, 6, Steps::decimal, "0 0.2 0.4 0.6 0.8 1"},
        {{0, 0.3}, 6, Steps::decimal, "0 0.05 0.1 0.15 0.2 0.25 0.3"},
        {{0, 47}, 5, Steps::decimal, "0 10 20 30 40 50"},
        {{0, 360}, 8, Steps::degrees, "0 45 90 135 180 225 270 315 360"},
        {{0, 360}, 6, Steps::degrees, "0 60 120 180 240 300 360"},
        {{0, 180}, 6, Steps::degrees, "0 30 60 90 120 150 180"},
        {{0, 720}, 8, Steps::degrees, "0 90 180 270 360 450 540 630 720"},
        {{0, 0.4}, 5, Steps::degrees, "0 0.1 0.2 0.3 0.4"},
        {{0, 36000}, 6, Steps::degrees, "0 7200 14400 21600 28800 36000"},
    };
    for (const Row& row : rows) CHECK(tick_texts(axis(row.data, row.most, row.steps, Ends::ticks)) == row.expected);
  }

  TEST_CASE("an axis that ends with its data includes a tick that is almost reached") {
    CHECK(axis({0, 359}, 8, Steps::degrees, Ends::data).range.high == doctest::Approx(360.0));
    CHECK(axis({0, 330}, 8, Steps::degrees, Ends::data).range.high == doctest::Approx(330.0));
  }

  TEST_CASE("a range of zero length is widened") {
    CHECK(tick_texts(axis({0, 0}, 4, Steps::decimal, Ends::ticks)) == "-1 -0.5 0 0.5 1");
    CHECK(tick_texts(axis({5, 5}, 5, Steps::decimal, Ends::ticks)) == "0 2 4 6 8 10");
    CHECK(tick_texts(axis({-5, -5}, 5, Steps::decimal, Ends::ticks)) == "-10 -8 -6 -4 -2 0");
  }

  TEST_CASE("large and small ticks are written in units of a power of ten") {
    const Axis large = axis({0, 3e12}, 3, Steps::decimal, Ends::ticks);
    CHECK(large.power == 12);
    CHECK(tick_texts(large) == "0 1 2 3");
    const Axis small = axis({0, 2e-12}, 4, Steps::decimal, Ends::ticks);
    CHECK(small.power == -12);
    CHECK(tick_texts(small) == "0 0.5 1 1.5 2");
    CHECK(axis({0, 90000}, 4, Steps::decimal, Ends::data).power == 0);
  }

  TEST_CASE("ticks far from zero keep the digits that distinguish them") {
    CHECK(tick_texts(axis({1000.0, 1000.4}, 4, Steps::decimal, Ends::ticks)) == "1000 1000.1 1000.2 1000.3 1000.4");
  }

  TEST_CASE("every range from 1e-12 to 1e12 has two to twelve ticks inside it") {
    for (int e = -12; e <= 12; ++e) {
      for (const double k : {1.0, 1.7, 3.14, 9.99}) {
        for (const double low : {0.0, -0.3, 0.999}) {
          const double size = k * std::pow(10.0, e);
          const Axis a = axis({low * size, size}, 6, Steps::decimal, Ends::ticks);
          CHECK(a.ticks.size() >= 2);
          CHECK(a.ticks.size() <= 12);
          CHECK(a.fraction(a.ticks.front()) >= -1e-9);
          CHECK(a.fraction(a.ticks.back()) <= 1.0 + 1e-9);
        }
      }
    }
  }

  TEST_CASE("a logarithmic axis has ticks at powers of ten, and between them where these are few") {
    const Axis cycles = logarithmic_axis({3e4, 4e7}, Ends::data);
    CHECK(cycles.ticks == std::vector<double>{1e5, 1e6, 1e7});
    CHECK(cycles.text(1e6) == "10⁶");
    CHECK(cycles.fraction(std::sqrt(3e4 * 4e7)) == doctest::Approx(0.5));
    const Axis stress = logarithmic_axis({210.0, 480.0}, Ends::ticks);
    CHECK(stress.range.low == 200.0);
    CHECK(stress.range.high == 500.0);
    CHECK(stress.ticks == std::vector<double>{200.0, 300.0, 400.0, 500.0});
    CHECK(stress.text(300.0) == "300");
    for (const double low : {1e-12, 3.0, 1e20}) {
      for (const double ratio : {1.0, 1.01, 1.3, 7.0, 1e3, 1e12}) {
        for (const Ends ends : {Ends::data, Ends::ticks}) {
          const Axis a = logarithmic_axis({low, low * ratio}, ends);
          CHECK(a.fraction(low) >= -1e-9);
          CHECK(a.fraction(low * ratio) <= 1.0 + 1e-9);
        }
      }
    }
  }

  TEST_CASE("a scale bar has a round length that fits") {
    CHECK(round_below(80.0) == doctest::Approx(50.0));
    CHECK(round_below(0.02) == doctest::Approx(0.02));
    CHECK(round_below(1999.0) == doctest::Approx(1000.0));
  }
}
