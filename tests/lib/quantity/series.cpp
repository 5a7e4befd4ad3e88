#include "lib/quantity/series.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace loadpath;
using std::numbers::pi;

namespace {

Axis cycle(std::size_t positions, double period = 2.0 * pi, double start = 0.0) {
  Axis axis{"crank", "angle", "deg", {}, {}, period};
  const auto n = static_cast<double>(positions);
  for (std::size_t i = 0; i < positions; ++i) axis.at.add(start + static_cast<double>(i) * period / n);
  axis.share.assign(positions, 1.0 / n);
  return axis;
}

Axis open(double from, double to, std::size_t positions) {
  Axis axis{"column", "height", "m", {}, {}, 0.0};
  for (std::size_t i = 0; i < positions; ++i) {
    axis.at.add(from + (to - from) * static_cast<double>(i) / static_cast<double>(positions - 1));
  }
  return axis;
}

Value over(const Axis& axis, const std::function<double(double)>& f) {
  Value series{{{}, &axis}, {}};
  for (const double at : axis.at.numbers()) series.si.push_back(f(at));
  return series;
}

Value listed(const Axis& axis, std::vector<double> si) { return {{{}, &axis}, std::move(si)}; }

double relative(double value, double exact) { return std::abs(value - exact) / std::abs(exact); }

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("a cosine's extremes are found between 360 positions") {
    const Axis axis = cycle(360);
    for (const double phase : {0.0, 0.004, 0.0087, 1.0, 3.14, -0.003}) {
      CAPTURE(phase);
      const Value series = over(axis, [=](double x) { return 86.0 * std::cos(x - phase); });
      const Extreme top = maximum(series);
      CHECK(relative(top.value, 86.0) < 1e-11);
      CHECK(std::cos(top.at - phase) == doctest::Approx(1.0).epsilon(1e-14));
      CHECK(std::abs(std::remainder(top.at - phase, 2.0 * pi)) < 1e-8);
      CHECK(top.at >= 0.0);
      CHECK(top.at < 2.0 * pi);
      CHECK(relative(minimum(series).value, -86.0) < 1e-11);
    }
  }

  TEST_CASE("a higher harmonic counts the positions of its own wave") {
    const Axis axis = cycle(360);
    const Value fourth = over(axis, [](double x) { return std::cos(4.0 * x - 0.1) + 2.0; });
    CHECK(relative(maximum(fourth).value, 3.0) < 1e-8);
    const Value unresolved = over(axis, [](double x) { return std::cos(60.0 * x - 0.5); });
    CHECK(maximum(unresolved).value <= 1.0);
  }

  TEST_CASE("a summit within a millionth of a step of the first position is at it, a thousandth away it is not") {
    const Axis axis = cycle(360, 2.0 * pi, 3.0);  // an axis that begins far from 0
    const double step = 2.0 * pi / 360.0;
    const auto place = [&](double offset) {
      return maximum(over(axis, [&](double x) { return std::cos(x - 3.0 - offset); })).at;
    };
    CHECK(place(1e-8 * step) == 3.0);
    CHECK(place(1e-3 * step) == doctest::Approx(3.0 + 1e-3 * step).epsilon(1e-9));
    CHECK(place(0.1 * step) == doctest::Approx(3.0 + 0.1 * step).epsilon(1e-9));
  }

  TEST_CASE("steps of 15 degrees refine a cosine and do not refine a peak narrower than the grid") {
    const Axis axis = cycle(24);
    const Value cosine = over(axis, [](double x) { return std::cos(x - 0.13); });
    CHECK(relative(maximum(cosine).value, 1.0) < 2e-6);
    const auto narrow = [](double x) { return std::exp(-30.0 * (x - 3.0) * (x - 3.0)); };
    const Value spike = over(axis, narrow);
    const Extreme top = maximum(spike);
    CHECK(top.value == spike.si[top.nearest]);
    CHECK(top.value < 1.0);
  }

  TEST_CASE("a refined extreme never falls below the positions") {
    const Axis axis = cycle(48);
    for (int i = 0; i < 200; ++i) {
      const double a = 0.37 * i;
      const Value series =
          over(axis, [=](double x) { return std::cos(x + a) + std::sin(3.0 * x - a * a) + 0.4 * std::cos(7.0 * x); });
      CHECK(maximum(series).value >= series.si[maximum(series).nearest]);
      CHECK(minimum(series).value <= series.si[minimum(series).nearest]);
    }
  }

  TEST_CASE("an extreme that is reached twice, but for rounding, is reported at the first position") {
    const Axis axis = cycle(360);
    for (const double rounding : {-1e-15, 1e-15}) {
      const Value twice = over(axis, [=](double x) { return std::cos(2.0 * x - 1.0) + (x > 3.0 ? rounding : 0.0); });
      CHECK(maximum(twice).at == doctest::Approx(0.5));
      CHECK(minimum(twice).at == doctest::Approx(0.5 + 0.5 * pi));
      CHECK(largest(twice).at == doctest::Approx(0.5));
    }
    Value coarse = over(axis, [](double x) { return std::cos(2.0 * x - 1.0) + (x > 3.0 ? 1e-6 : 0.0); });
    CHECK(maximum(coarse).at == doctest::Approx(0.5 + pi));
    coarse.rounding = 2e-6;
    CHECK(maximum(coarse).at == doctest::Approx(0.5));
  }

  TEST_CASE("an extreme at zero, or at the beginning of a revolution, is reported there and not a rounding error off") {
    for (const double start : {0.0, -0.5 * pi, 1e-17}) {
      CAPTURE(start);
      const Axis axis = cycle(360, 2.0 * pi, start);
      const Value lines = over(axis, [](double x) { return std::cos(x + 1e-13); });
      CHECK(maximum(lines).at == 0.0);
      CHECK(maximum(over(axis, [](double x) { return -std::abs(std::sin(0.5 * x)); })).at == 0.0);
    }
    const Axis axis = cycle(360);
    CHECK(maximum(over(axis, [](double x) { return std::cos(x - 1e-5); })).at == doctest::Approx(1e-5));
  }

  TEST_CASE("a jump is not overshot") {
    const Axis axis = cycle(36);
    for (std::size_t width = 1; width < 36; ++width) {
      CAPTURE(width);
      std::vector<double> step(36, -2.0);
      for (std::size_t i = 0; i < width; ++i) step[(i + 30) % 36] = 5.0;
      const Value series = listed(axis, step);
      CHECK(maximum(series).value == 5.0);
      CHECK(minimum(series).value == -2.0);
    }
  }

  TEST_CASE("a summit cut off by a jump stays at its position") {
    const Axis axis = cycle(360);
    const Value saw = over(axis, [](double x) { return x < 2.0 ? std::sin(x / 1.3) : -1.0; });
    CHECK(maximum(saw).value == *std::max_element(saw.si.begin(), saw.si.end()));
  }

  TEST_CASE("the tip of a triangle is the position itself") {
    const Axis axis = cycle(40);
    for (const double shift : {0.0, 0.2, 0.5, 0.8}) {
      CAPTURE(shift);
      const double tip = axis.at[10] + shift * 2.0 * pi / 40.0;
      const Value triangle = over(axis, [=](double x) { return 3.0 - std::abs(x - tip); });
      CHECK(maximum(triangle).value == *std::max_element(triangle.si.begin(), triangle.si.end()));
    }
  }

  TEST_CASE("a magnitude that passes through zero between the positions has its valley there") {
    const Axis axis = cycle(360, 2.0 * pi, 0.004);
    const Extreme least = minimum(over(axis, [](double phi) { return std::abs(700.0 * std::cos(phi)); }));
    CHECK(least.value < 1e-3);
    CHECK(std::abs(std::cos(least.at)) < 1e-6);
    const Extreme of_two = minimum(over(axis, [](double phi) { return std::hypot(700.0 * std::cos(phi), 0.5); }));
    CHECK(relative(of_two.value, 0.5) < 1e-3);
  }

  TEST_CASE("an extreme next to the first position is reported within the listed revolution") {
    const Axis axis = cycle(360);
    const Value series = over(axis, [](double x) { return std::cos(x + 0.003); });
    CHECK(maximum(series).at == doctest::Approx(2.0 * pi - 0.003).epsilon(1e-10));
    CHECK(maximum(series).nearest == 0);
  }

  TEST_CASE("a descending cycle has the same extremes") {
    const Axis axis = cycle(360, -2.0 * pi, 1.0);
    const Value series = over(axis, [](double x) { return std::cos(x + 2.3); });
    CHECK(relative(maximum(series).value, 1.0) < 1e-11);
    CHECK(maximum(series).at == doctest::Approx(-2.3).epsilon(1e-9));
    CHECK(relative(minimum(series).value, -1.0) < 1e-11);
  }

  TEST_CASE("unequal steps are refined at their own positions") {
    Axis axis = cycle(360);
    for (std::size_t i = 0; i < axis.at.size(); ++i) axis.at.numbers()[i] += 0.004 * std::sin(7.0 * axis.at[i]);
    const Value series = over(axis, [](double x) { return std::cos(x - 1.234); });
    CHECK(relative(maximum(series).value, 1.0) < 1e-10);
    CHECK(maximum(series).at == doctest::Approx(1.234).epsilon(1e-7));
  }

  TEST_CASE("an open axis is refined inside and never beyond its ends") {
    const Axis inside = open(0.0, 2.0, 101);
    const Value hill = over(inside, [](double x) { return std::sin(x); });
    CHECK(relative(maximum(hill).value, 1.0) < 1e-10);
    CHECK(minimum(hill).value == 0.0);
    CHECK(minimum(hill).at == 0.0);

    const Axis rising = open(1.0, 1.5, 26);
    const Value slope = over(rising, [](double x) { return std::sin(x); });
    CHECK(maximum(slope).value == std::sin(1.5));
    CHECK(maximum(slope).at == 1.5);

    const Axis beside_the_end = open(0.5 * pi - 0.006, 0.5 * pi + 0.4, 21);
    const Value first = over(beside_the_end, [](double x) { return std::sin(x); });
    CHECK(relative(maximum(first).value, 1.0) < 1e-9);
    CHECK(maximum(first).at == doctest::Approx(0.5 * pi).epsilon(1e-5));
  }

  TEST_CASE("the largest value keeps its sign") {
    const Axis axis = cycle(360);
    CHECK(largest(over(axis, [](double x) { return std::cos(x) - 0.5; })).value == doctest::Approx(-1.5));
    CHECK(largest(over(axis, [](double x) { return std::cos(x) + 0.5; })).value == doctest::Approx(1.5));
    CHECK(largest(over(axis, [](double x) { return std::cos(x); })).value > 0.0);
  }

  TEST_CASE("an extreme of an empty or incomplete series is not available") {
    const Axis axis = cycle(8);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(maximum(listed(axis, {})).value));
    CHECK(std::isnan(minimum(listed(axis, {1, 2, nan, 4, 5, 6, 7, 8})).value));
    CHECK(std::isnan(largest(listed(axis, {nan, 2, 3, 4, 5, 6, 7, 8})).value));
    CHECK(maximum(Value{{}, {3.0}}).value == 3.0);
  }

  TEST_CASE("few positions are taken as they are") {
    const Axis axis = cycle(4);
    CHECK(maximum(listed(axis, {0.0, 1.0, 0.9, 0.1})).value == 1.0);
    const Axis one = cycle(1);
    CHECK(maximum(listed(one, {2.0})).value == 2.0);
  }

  TEST_CASE("the mean is weighted by the time at each position") {
    Axis axis = cycle(4);
    axis.share = {0.5, 0.25, 0.125, 0.125};
    const Value series = listed(axis, {1.0, 2.0, 4.0, 8.0});
    CHECK(mean(series) == 2.5);
    CHECK(root_mean_square(series) == doctest::Approx(std::sqrt(0.5 + 1.0 + 2.0 + 8.0)).epsilon(1e-15));
  }

  TEST_CASE("mean and rms of a sine are exact for equal steps") {
    const Axis axis = cycle(24);
    const Value series = over(axis, [](double x) { return 3.0 + 2.0 * std::sin(x); });
    CHECK(mean(series) == doctest::Approx(3.0).epsilon(1e-14));
    CHECK(root_mean_square(series) == doctest::Approx(std::sqrt(11.0)).epsilon(1e-14));
  }

  TEST_CASE("mean and rms exist for a cycle only") {
    const Axis axis = open(0.0, 1.0, 11);
    const Value series = over(axis, [](double x) { return x; });
    CHECK(std::isnan(mean(series)));
    CHECK(std::isnan(root_mean_square(series)));
    CHECK(std::isnan(mean(Value{{}, {3.0}})));
  }

  TEST_CASE("the value at a position is that of the position, between them that of a cubic") {
    const Axis axis = cycle(360);
    const auto f = [](double x) { return std::cos(x) + 0.3 * std::sin(2.0 * x); };
    const Value series = over(axis, f);
    for (std::size_t i = 0; i < 360; ++i)
      CHECK(value_at(series, axis.at[i]) == doctest::Approx(series.si[i]).epsilon(1e-13));
    for (const double x : {0.001, 1.0, 3.3333, 6.2831, 2.0 * pi + 1.0, -1.0, -100.0}) {
      CHECK(value_at(series, x) == doctest::Approx(f(x)).epsilon(1e-7));
    }
  }

  TEST_CASE("a cubic is reproduced on an open axis, up to its ends") {
    const auto cubic = [](double x) { return 1.0 + x * (2.0 - x * (3.0 - 4.0 * x)); };
    for (const Axis& axis : {open(0.0, 2.0, 5), open(2.0, 0.0, 5), open(0.0, 2.0, 4)}) {
      const Value series = over(axis, cubic);
      for (const double x : {0.0, 0.1, 0.77, 1.5, 1.93, 2.0}) {
        CHECK(value_at(series, x) == doctest::Approx(cubic(x)).epsilon(1e-13));
      }
      CHECK(std::isnan(value_at(series, 2.01)));
      CHECK(std::isnan(value_at(series, -0.01)));
    }
    const Axis fine = open(0.0, 2.0, 41);
    const Value wave = over(fine, [](double x) { return std::sin(x); });
    for (const double x : {0.01, 0.06, 1.94, 1.99}) CHECK(std::abs(value_at(wave, x) - std::sin(x)) < 3e-7);
  }

  TEST_CASE("the end of an open axis is met in spite of rounding") {
    const Axis axis = open(0.0, 60.0 * pi / 180.0, 7);
    const Value series = over(axis, [](double x) { return x; });
    CHECK(value_at(series, std::nextafter(axis.at.back(), 9.0)) == doctest::Approx(axis.at.back()));
  }

  TEST_CASE("a descending cycle is read at any position") {
    const Axis axis = cycle(360, -2.0 * pi);
    const Value series = over(axis, [](double x) { return std::sin(x); });
    for (const double x : {-0.5, 0.5, 4.0, -6.28})
      CHECK(value_at(series, x) == doctest::Approx(std::sin(x)).epsilon(1e-7));
  }

  TEST_CASE("nothing can be read at a position that is not a number or from a single value") {
    const Axis axis = cycle(12);
    const Value series = over(axis, [](double x) { return x; });
    CHECK(std::isnan(value_at(series, std::numeric_limits<double>::quiet_NaN())));
    CHECK(std::isnan(value_at(series, std::numeric_limits<double>::infinity())));
    CHECK(std::isnan(value_at(Value{{}, {3.0}}, 0.0)));
  }

  TEST_CASE("a series is constant when its values differ by no more than their rounding") {
    const Axis axis{"a", "crank angle", "deg", {0.0, 1.0, 2.0}, {}, 0.0};
    Value series{{{}, &axis}, {5.0, 5.0 + 1e-15, 5.0 - 1e-15}, 1e-14};
    CHECK(is_constant(series));
    series.rounding = 1e-16;
    CHECK_FALSE(is_constant(series));
    series.si = {0.0, 0.0, std::numeric_limits<double>::quiet_NaN()};
    CHECK_FALSE(is_constant(series));
    series.si.clear();
    CHECK_FALSE(is_constant(series));
  }
}
