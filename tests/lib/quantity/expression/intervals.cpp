// Intervals hold what a law does between two places, and lines with corners pass over no pulse.
#include "lib/quantity/expression/resolved.hpp"
#include "lib/quantity/units.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace loadpath;

namespace {

Law law_of(const std::string& text) {
  auto law = Law::parse(text, {"x", {}}, {});
  REQUIRE_MESSAGE(static_cast<bool>(law), text);
  return std::move(*law);
}

/// A formula of random operations, so that its value may be any number or none.
class RandomLaws {
 public:
  std::string text(int depth) {
    if (depth == 0) return pick(3) == 0 ? number() : "x";
    const std::string a = text(depth - 1);
    switch (pick(10)) {
      case 0:
        return "(" + a + " + " + text(depth - 1) + ")";
      case 1:
        return "(" + a + " - " + text(depth - 1) + ")";
      case 2:
      case 3:
        return "(" + a + ")*(" + text(depth - 1) + ")";
      case 4:
        return "(" + a + ")/(" + number() + " + (" + text(depth - 1) + ")^2)";
      case 5:
        return "(" + a + ")^" + std::to_string(pick(4));
      case 6:
        return "-(" + a + ")";
      case 7:
        return "atan2(" + a + ", 1.5 + (" + text(depth - 1) + ")^2)";
      default:
        break;
    }
    static const char* const functions[] = {"sin", "cos", "exp", "sqrt", "cbrt", "ln", "atan", "tan", "asin", "acos"};
    const std::string f = functions[pick(10)];
    const bool angle = f == "sin" || f == "cos" || f == "tan";
    return f + "(" + (angle ? "1*" : "") + "(" + a + "))";
  }
  double real(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  std::string number() { return std::to_string(pick(40) * 0.1 + 0.1); }
  std::mt19937 random_{20261127};
};

void check_holds(const Interval& bounds, double x, double scale) {
  if (!std::isfinite(x)) return;
  const double rounding = 1e-9 * (scale + std::abs(x));
  CHECK(bounds.low - rounding <= x);
  CHECK(x <= bounds.high + rounding);
}

double most_of(const Resolved& resolved) {
  double most = 0.0;
  for (const auto& corner : resolved.corners) most = std::max(most, std::abs(corner.second));
  return most;
}

}  // namespace

TEST_SUITE("intervals of laws") {
  TEST_CASE("bounds hold 10^5 samples of random laws and of their derivatives") {
    RandomLaws random;
    int samples = 0, bounded = 0, all = 0;
    while (samples < 100'000) {
      const std::string text = random.text(3);
      auto law = Law::parse(text, {"x", {}}, {});
      if (!law) continue;  // of an angle that is none
      for (int k = 0; k < 20; ++k) {
        const double from = random.real(-3.0, 3.0), to = from + std::pow(10.0, random.real(-4.0, 0.5));
        const IntervalJet bounds = law->over({from, to});
        ++all;
        bounded += bounds.value.is_bounded() ? 1 : 0;
        for (int i = 0; i <= 10; ++i) {
          const numerics::Jet jet = law->at(from + (to - from) * i / 10.0);
          INFO(text << " at " << from + (to - from) * i / 10.0);
          check_holds(bounds.value, jet.value, 0.0);
          if (std::isfinite(jet.value)) check_holds(bounds.first, jet.first, std::abs(jet.value));
          if (std::isfinite(jet.value)) check_holds(bounds.second, jet.second, std::abs(jet.first));
          ++samples;
        }
      }
    }
    CHECK(bounded > all / 2);
  }

  TEST_CASE("a pulse is found wherever it is and however narrow") {
    RandomLaws random;
    for (int i = 0; i < 300; ++i) {
      const double at = random.real(0.0, 1.0), width = std::pow(10.0, random.real(-7.0, -2.0));
      const std::string text = "exp(-((x - " + std::to_string(at) + ")/" + std::to_string(width * 1e9) + "*1e9)^2)";
      INFO(text);
      const Resolved resolved = resolve(law_of(text), 0.0, 1.0, 0.01);
      CHECK(resolved.complete);
      CHECK(most_of(resolved) > 0.98);
    }
  }

  TEST_CASE("waves that vanish at every even position are found") {
    const Resolved resolved = resolve(law_of("sin(64*pi*x)"), 0.0, 1.0, 0.01);
    CHECK(resolved.complete);
    CHECK(most_of(resolved) > 0.98);
  }

  TEST_CASE("a pole and too many waves are reported") {
    CHECK_FALSE(resolve(law_of("1/(x - 0.3)"), 0.0, 1.0, 0.01).complete);
    CHECK_FALSE(resolve(law_of("sin(1e9*x)"), 0.0, 1.0, 0.01).complete);
    CHECK(resolve(law_of("sqrt(x)"), 0.0, 1.0, 0.01).complete);
    CHECK(resolve(law_of("0*x"), 0.0, 1.0, 0.01).complete);
  }
}
