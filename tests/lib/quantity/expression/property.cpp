#include "lib/quantity/format.hpp"
#include "tests/lib/quantity/expression/world.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace loadpath;
using namespace loadpath::expression_test;

namespace {

/// A text and the value that plain C++ gives to it.
struct Sample {
  std::string text;
  double value;
};

class Generator {
 public:
  explicit Generator(unsigned seed) : random_{seed} {}

  /// A dimensionless tree, every operand in parentheses.
  Sample number(int depth) {
    if (depth == 0) return leaf();
    const Sample a = number(depth - 1);
    switch (pick(8)) {
      case 0:
        return {"-(" + a.text + ")", -a.value};
      case 1:
        return {"sin((" + a.text + ")*1 rad)", finite(std::sin(a.value))};
      case 2:
        return {"sqrt(abs(" + a.text + "))", finite(std::sqrt(std::abs(a.value)))};
      case 3:
        return {"(" + a.text + ")^2", finite(a.value * a.value)};
      default:
        return binary(a, number(depth - 1));
    }
  }

  /// A tree that may or may not be right in its dimensions.
  std::string any(int depth) {
    static constexpr std::string_view leaves[] = {"lever.drive.M", "lever.joints.A.F", "column.N",    "lever.mass",
                                                  "shaft.d",       "shaft.missing",    "lever.omega", "2",
                                                  "30 MPa",        "60 deg",           "pi",          "g"};
    static constexpr std::string_view calls[] = {"peak", "min",  "max",  "mean", "rms",  "range",
                                                 "abs",  "sqrt", "cbrt", "cos",  "asin", "amplitude"};
    static constexpr std::string_view operators[] = {" + ", " - ", "*", "/"};
    if (depth == 0 || pick(8) == 0) return std::string(leaves[pick(std::size(leaves))]);
    switch (pick(5)) {
      case 0:
        return std::string(calls[pick(std::size(calls))]) + "(" + any(depth - 1) + ")";
      case 1:
        return "max(" + any(depth - 1) + ", " + any(depth - 1) + ")";
      case 2:
        return "(" + any(depth - 1) + ")^" + std::to_string(pick(4));
      case 3:
        return "at(" + any(depth - 1) + ", " + (pick(2) == 0 ? "60 deg" : "1.5 m") + ")";
      default:
        return "(" + any(depth - 1) + ")" + std::string(operators[pick(std::size(operators))]) + "(" + any(depth - 1) +
               ")";
    }
  }

  std::size_t pick(std::size_t n) { return random_() % n; }

 private:
  Sample leaf() {
    const double value = static_cast<double>(random_() % 100000) / 1000.0;
    switch (pick(4)) {
      case 0:
        return {format_exact(value) + " kN/(10 N)", value * 1000.0 / 10.0};
      case 1:
        return {"lever.mass/(1 kg)", 80.0};
      default:
        return {format_exact(value), value};
    }
  }

  Sample binary(const Sample& a, const Sample& b) {
    const auto in_parentheses = [&](const char* sign) { return "(" + a.text + ")" + sign + "(" + b.text + ")"; };
    switch (pick(5)) {
      case 0:
        return {in_parentheses(" + "), finite(a.value + b.value)};
      case 1:
        return {in_parentheses(" - "), finite(a.value - b.value)};
      case 2:
        return {in_parentheses("*"), finite(a.value * b.value)};
      case 3:
        return {in_parentheses("/"), finite(a.value / b.value)};
      default:
        return {"max(" + a.text + ", " + b.text + ")",
                std::isnan(a.value + b.value) ? std::nan("") : std::max(a.value, b.value)};
    }
  }

  static double finite(double x) { return std::isfinite(x) ? x : std::nan(""); }

  std::mt19937 random_;
};

bool same(double a, double b) {
  return (!std::isfinite(a) && !std::isfinite(b)) ||
         std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("a printed tree is read back with its value") {
    Generator generator{20};
    int finite = 0;
    for (int i = 0; i < 4000; ++i) {
      const Sample sample = generator.number(static_cast<int>(generator.pick(5)));
      if (sample.text.size() > 1024) continue;
      CAPTURE(sample.text);
      const double value = value_of(sample.text).si.front();
      CHECK((value == sample.value || (std::isnan(value) && std::isnan(sample.value))));
      finite += std::isfinite(value) ? 1 : 0;
    }
    CHECK(finite > 3000);
  }

  TEST_CASE("a tree without needless parentheses binds as in C++") {
    Generator generator{21};
    for (int i = 0; i < 2000; ++i) {
      const double a = 1.0 + static_cast<double>(generator.pick(9)), b = 1.0 + static_cast<double>(generator.pick(9)),
                   c = 1.0 + static_cast<double>(generator.pick(9)), d = 1.0 + static_cast<double>(generator.pick(9));
      const auto text = [](double x) { return format_exact(x); };
      CHECK(same(value_of(text(a) + "-" + text(b) + "*" + text(c) + "/" + text(d)).si.front(), a - b * c / d));
      CHECK(same(value_of(text(a) + "/" + text(b) + "/" + text(c) + "+-" + text(d)).si.front(), a / b / c + -d));
      CHECK(same(value_of("-" + text(a) + "^2*" + text(b) + "-" + text(c)).si.front(), -(a * a) * b - c));
    }
  }

  TEST_CASE("the check of dimensions never contradicts the evaluation") {
    Generator generator{22};
    int right = 0;
    for (int i = 0; i < 20000; ++i) {
      const std::string text = generator.any(4);
      CAPTURE(text);
      const auto parsed = Expression::parse(text);
      if (!parsed) {
        CHECK(text.size() > 1024);
        continue;
      }
      const auto signature = parsed->check(declared);
      if (!signature) {
        CHECK_FALSE(signature.fault().message.empty());
        CHECK_FALSE(signature.fault().hint.empty());
        CHECK(signature.fault().at + signature.fault().length <= text.size());
        continue;
      }
      const Value value = parsed->evaluate(known);
      CHECK(value.signature.dimension == signature->dimension);
      CHECK(value.signature.axis == signature->axis);
      CHECK(value.si.size() == (signature->axis == nullptr ? 1 : signature->axis->at.size()));
      for (const double x : value.si) CHECK_FALSE(std::isinf(x));
      ++right;
    }
    CHECK(right > 1000);
  }

  TEST_CASE("a change of units does not change the value") {
    CHECK(
        same(value_of("peak(lever.drive.M + 2 kN*mm)").si.front(), value_of("peak(lever.drive.M + 2 N*m)").si.front()));
    CHECK(same(value_of("at(lever.drive.M, 0.25 rev)").si.front(), value_of("at(lever.drive.M, 90 deg)").si.front()));
  }

  TEST_CASE("mean, work and values at a position superpose") {
    const Value& M = known("lever.drive.M");
    Generator generator{23};
    for (int i = 0; i < 200; ++i) {
      Value a = M, b = M;
      for (double& x : a.si) x = static_cast<double>(generator.pick(2000)) - 1000.0;
      for (double& x : b.si) x = static_cast<double>(generator.pick(2000)) - 1000.0;
      Value sum = a;
      for (std::size_t k = 0; k < sum.si.size(); ++k) sum.si[k] += 3.0 * b.si[k];
      const double at = static_cast<double>(generator.pick(100000)) / 5000.0 - 10.0;
      CHECK(same(mean(sum), mean(a) + 3.0 * mean(b)));
      CHECK(same(value_at(sum, at), value_at(a, at) + 3.0 * value_at(b, at)));
    }
  }

  TEST_CASE("the extremes of the opposite series change places") {
    Generator generator{24};
    for (int i = 0; i < 200; ++i) {
      Value a = known("lever.drive.M");
      for (double& x : a.si) x += static_cast<double>(generator.pick(100)) / 300.0;
      Value opposite = a;
      for (double& x : opposite.si) x = -x;
      CHECK(maximum(a).value == -minimum(opposite).value);
      CHECK(std::abs(largest(a).value) == std::abs(largest(opposite).value));
    }
  }
}
