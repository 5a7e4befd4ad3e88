#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace loadpath::formula;

namespace {

const double refused = std::numeric_limits<double>::quiet_NaN();  // no value: parse gives nothing

std::optional<double> known(std::string_view name) {
  static const std::map<std::string_view, double> values = {
      {"a", 3.0}, {"b", -2.0},  {"c", 0.5}, {"d", 0.04}, {"n", 7.0}, {"lost", std::numeric_limits<double>::quiet_NaN()},
      {"W", 2.5}, {"root", 4.0}};
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

TEST_SUITE("formula") {
  TEST_CASE("the value is the one that C++ computes") {
    const double a = 3.0, b = -2.0, c = 0.5, d = 0.04, W = 2.5, pi = std::acos(-1.0);
    struct Row {
      std::string_view cpp;
      double value;
    };
    for (const Row& row : std::vector<Row>{{"1e-3", 1e-3},
                                           {".5E+2", 50.0},
                                           {"a - b - c", a - b - c},
                                           {"a - (b - c)", a - (b - c)},
                                           {"a / b / c", a / b / c},
                                           {"a / b * c", a / b * c},
                                           {"-a * b", -a * b},
                                           {"a - -b", a - -b},
                                           {"a * -b", a * -b},
                                           {"- - a", a},
                                           {"pi / 32.0 * pow<3>(d)", pi / 32.0 * d * d * d},
                                           {"pow<-2>(a)", 1.0 / 9.0},
                                           {"pow(a, c)", std::sqrt(a)},
                                           {"root<4>(a) * cbrt(b)", std::pow(a, 0.25) * std::cbrt(b)},
                                           {"sqrt(a * a + 3.0 * b * b)", std::sqrt(21.0)},
                                           {"abs(b) + exp(c) + log(a)", 2.0 + std::exp(c) + std::log(a)},
                                           {"sin(a) + cos(a) + tan(a)", std::sin(a) + std::cos(a) + std::tan(a)},
                                           {"asin(c) + acos(c) + atan(c)", std::asin(c) + std::acos(c) + std::atan(c)},
                                           {"min(a, b) - max(a, c)", b - a},
                                           {"a < b ? a : c", c},
                                           {"a > b ? b > c ? 1.0 : 2.0 : 3.0", 2.0},
                                           {"a < b || b < c ? 1.0 : 2.0", 1.0},
                                           {"a < b && c < a ? 1.0 : 2.0", 2.0},
                                           {"a == 3.0 && a != b && a >= 3.0 && a <= 3.0", 1.0},
                                           {"a < b && unknown", 0.0},
                                           {"a > b || unknown", 1.0},
                                           {"lost < 1.0 ? 1.0 : 2.0", 2.0},
                                           {"is_set(a) && !1.0 < 0.0 ? 1.0 : 2.0", refused},
                                           {"is_set(a) ? 1.0 : 2.0", 1.0},
                                           {"is_set(lost) ? 1.0 : 2.0", 2.0},
                                           {"is_set(unknown) ? 1.0 : 2.0", 2.0},
                                           {"d / mm", 40.0},
                                           {"10.0 * N_m + 2.0 * MPa", 2000010.0},
                                           {"a / W", a / W},
                                           {"root + 1.0", 5.0}}) {
      CAPTURE(row.cpp);
      const auto tree = parse(row.cpp);
      if (std::isnan(row.value)) {
        CHECK_FALSE(tree);
        continue;
      }
      REQUIRE(tree);
      CHECK(value(*tree, known) == doctest::Approx(row.value).epsilon(1e-14));
    }
  }

  TEST_CASE("a name keeps its path, and is shown without it") {
    CHECK(names(parse("in.d_1 * (d - r.F_c / pulley.d) + in.load.d_1 * in.d_1").value()) ==
          std::vector<std::string>{"in.d_1", "d", "r.F_c", "pulley.d", "in.load.d_1"});
    CHECK(names(parse("in.kind == belt::Kind::wide ? 2.5 : 1.0").value()) ==
          std::vector<std::string>{"in.kind", "in.kind::wide"});
    CHECK(symbol_of("in.load.d_1") == "d_1");
    CHECK(symbol_of("d_1") == "d_1");
    CHECK(shown("in.d_1 * (d - r.F_c / pulley.d) + 2.0 * in.load.d_1") == "d_1 * (d - F_c / d) + 2.0 * d_1");
    CHECK(shown("in.kind == belt::Kind::wide ? 2.5 : d") == "kind == wide ? 2.5 : d");
  }

  TEST_CASE("an unknown name makes the value NaN, also after a comparison") {
    for (const char* cpp : {"a + unknown", "unknown < a", "unknown < a ? 1.0 : 2.0", "min(a, unknown)", "-unknown"}) {
      CAPTURE(cpp);
      CHECK(std::isnan(value(parse(cpp).value(), known)));
    }
    CHECK(std::isnan(value(parse("a").value(), {})));
  }

  TEST_CASE("text outside the language is refused") {
    for (const char* cpp : {"",
                            "a +",
                            "a b",
                            "2 a",
                            "(a",
                            "a)",
                            "()",
                            "+a",
                            "!a",
                            "a--b",
                            "--a",
                            "a++",
                            "a % b",
                            "a = b",
                            "a & b",
                            "a | b",
                            "a << b",
                            "a < b < c",
                            "a == b == c",
                            "a ? b",
                            "a : b",
                            "a, b",
                            "f(a)",
                            "sqrt()",
                            "sqrt(a, b)",
                            "pow<2>",
                            "pow<a>(b)",
                            "pow<2>(a, b)",
                            "pow<0>(a)",
                            "root<-2>(a)",
                            "pow(a)",
                            "min(a)",
                            "max(a, b, c)",
                            "std::sqrt(a)",
                            "in.",
                            "in.2",
                            ".d",
                            "in.f(a)",
                            "in..d",
                            "a[1]",
                            "a->b",
                            "1.2.3",
                            "1.f",
                            "1e",
                            "1'000.0",
                            "0x1p3",
                            "010",
                            ".",
                            "1.0mm",
                            "\"a\"",
                            "a;",
                            "a // b",
                            "static_cast<double>(a)",
                            "sqrt",
                            "pow",
                            "σ",
                            "a\xff"}) {
      CAPTURE(cpp);
      CHECK_FALSE(parse(cpp));
    }
  }

  TEST_CASE("nesting and length are bounded") {
    const std::string deep(5000, '('), signs = [] {
      std::string text;
      for (int i = 0; i < 500; ++i) text += "- ";
      return text + "a";
    }();
    CHECK_FALSE(parse(deep));
    CHECK_FALSE(parse(signs));
    CHECK(parse(std::string(50, '(') + "a" + std::string(50, ')')));
    CHECK_FALSE(parse(std::string(5000, ' ') + "a"));
  }
}
