#include "tests/lib/quantity/expression/world.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::expression_test;

namespace {

struct Wrong {
  std::string_view text;
  std::string_view marked;
  std::string_view message;
  std::string_view hint;
};

void check_wrong(const Wrong& wrong) {
  CAPTURE(wrong.text);
  const Fault fault = fault_of(wrong.text);
  CHECK(fault.message.text() == wrong.message);
  CHECK(fault.hint.text() == wrong.hint);
  CHECK(wrong.text.substr(fault.at, fault.length) == wrong.marked);
}

Signature signature_of(std::string_view text) { return value_of(text).signature; }

constexpr std::string_view kind_hint = "both must have the same dimension";
constexpr std::string_view unit_hint = "give the number a unit";
constexpr std::string_view ratio_hint = "divide by a quantity of the same kind";
constexpr std::string_view exponent_hint = "write a number, as in ^2 or ^(1/3)";
constexpr std::string_view root_hint = "make it a number first: divide by 1 of its unit";

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("an unknown name gets the answer of the project, at its own place") {
    check_wrong({"2 * lever.mas", "lever.mas", "'lever.mas' has no result", "did you mean 'lever.mass'?"});
  }

  TEST_CASE("unlike quantities are neither added nor compared") {
    const Wrong rows[] = {
        {"2*(1 N + 1 mm)", "(1 N + 1 mm)", "force and length cannot be added", kind_hint},
        {"1 kW/(10 rad/s) + 3 N", "1 kW/(10 rad/s) + 3 N", "torque and force cannot be added", kind_hint},
        {"1 N - shaft.d", "1 N - shaft.d", "length cannot be subtracted from force", kind_hint},
        {"lever.drive.M + 2", "lever.drive.M + 2", "moment and plain number cannot be added", unit_hint},
        {"min(1 N, 2 N, 3 m)", "min(1 N, 2 N, 3 m)", "force and length cannot be compared", kind_hint},
        {"max(1, 2 N)", "max(1, 2 N)", "plain number and force cannot be compared", unit_hint},
        {"atan2(1 N, 2 m)", "atan2(1 N, 2 m)", "force and length cannot be the sides of one angle", kind_hint},
        {"hypot(1 N, 2 m)", "hypot(1 N, 2 m)", "force and length cannot be components of one resultant", kind_hint},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("an exponent is a constant number that leaves the unit's exponents in whole twelfths") {
    const Wrong rows[] = {
        {"2^lever.mass", "lever.mass", "an exponent must be a constant number, and 'lever.mass' is not", exponent_hint},
        {"2^(60 deg)", "(60 deg)", "an exponent must be a constant number, and '(60 deg)' is not", exponent_hint},
        {"2^(0/0)", "(0/0)", "an exponent must be a constant number, and '(0/0)' is not", exponent_hint},
        {"2^(lever.mass/(1 kg))", "(lever.mass/(1 kg))",
         "an exponent must be a constant number, and '(lever.mass/(1 kg))' is not", exponent_hint},
        {"shaft.d^0.4", "shaft.d^0.4", "length cannot be raised to the power 0.4", root_hint},
        {"shaft.d^101", "shaft.d^101", "length cannot be raised to the power 101", root_hint},
        {"sqrt(sqrt(sqrt(shaft.d)))", "sqrt(sqrt(sqrt(shaft.d)))", "'sqrt' cannot be taken of quantity in m^(1/4)",
         root_hint},
    };
    for (const auto& row : rows) check_wrong(row);
    const std::string_view huge = "shaft.d^90 * shaft.d^90";
    check_wrong({huge, huge, "the power of a unit exceeds 100 here", "check the exponents"});
  }

  TEST_CASE("an angle's function needs an angle or a number, its inverse a ratio") {
    const Wrong rows[] = {
        {"cos(3 m)", "3 m", "'cos' needs an angle or a number, not length", ratio_hint},
        {"tan(lever.drive.M)", "lever.drive.M", "'tan' needs an angle or a number, not moment", ratio_hint},
        {"asin(1 N)", "1 N", "'asin' needs a number, not force", ratio_hint},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("series over different axes are combined only when one of them is reduced") {
    constexpr std::string_view message =
        "series over different axes cannot be combined: 'lever: crank angle' and 'column: height'";
    constexpr std::string_view hint = "reduce one of them with peak, max, mean, at ...";
    for (const std::string_view text :
         {"lever.joints.A.F + column.N", "lever.drive.M * column.N", "max(lever.joints.A.F, 1 N, column.N)"}) {
      check_wrong({text, text, message, hint});
    }
    CHECK(signature_of("lever.joints.A.F + peak(column.N)").axis == &crank());
  }

  TEST_CASE("only a series is reduced, and only over a cycle is there a mean") {
    const Wrong rows[] = {
        {"peak(lever.mass)", "lever.mass", "'peak' needs a series; lever.mass is one value", "use the value as it is"},
        {"2 * rms(2 N + 1 N)", "2 N + 1 N", "'rms' needs a series; 2 N + 1 N is one value", "use the value as it is"},
        {"at(lever.mass, 60 deg)", "lever.mass", "'at' needs a series; lever.mass is one value",
         "use the value as it is"},
        {"max(lever.mass)", "lever.mass", "'max' needs a series; lever.mass is one value",
         "give a series, or two values to compare: max(a, b)"},
        {"mean(column.N)", "mean(column.N)", "'mean' needs a closed cycle, and 'column: height' is not one",
         "reduce the series with max, min or peak"},
        {"rms(column.N)", "rms(column.N)", "'rms' needs a closed cycle, and 'column: height' is not one",
         "reduce the series with max, min or peak"},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("a position is a constant in the unit of the axis") {
    const Wrong rows[] = {
        {"at(lever.drive.M, 60)", "60", "the position must be on the axis 'lever: crank angle', not plain number",
         "write it in deg, as in 60 deg"},
        {"at(lever.drive.M, 1 mm)", "1 mm", "the position must be on the axis 'lever: crank angle', not length",
         "write it in deg, as in 60 deg"},
        {"at(column.N, 60 deg)", "60 deg", "the position must be on the axis 'column: height', not angle",
         "write it in m, as in 60 m"},
        {"at(column.N, shaft.d)", "shaft.d", "the position must be a constant", "write it in m, as in 60 m"},
    };
    for (const auto& row : rows) check_wrong(row);
    CHECK(signature_of("at(lever.drive.M, 2 * 30 deg)").axis == nullptr);
    CHECK(signature_of("at(column.N, 1 m + 20 mm)").dimension == Dimension::of(1, 1, -2));
  }

  TEST_CASE("dimensions are compared without the angle and keep it") {
    CHECK(signature_of("lever.drive.M * lever.omega + 1 W").dimension == Dimension::of(2, 1, -3, 0, 1));
    CHECK(signature_of("max(1 W, lever.drive.M * lever.omega)").dimension == Dimension::of(2, 1, -3));
    CHECK(signature_of("1 + 60 deg").dimension.is_number());
    CHECK(signature_of("asin(0.5)").dimension == Dimension::of(0, 0, 0, 0, 1));
    CHECK(signature_of("atan2(1 mm, 1 m)").dimension == Dimension::of(0, 0, 0, 0, 1));
    CHECK(signature_of("sin(60 deg) + cos(0.5 rad)").dimension.is_number());
  }

  TEST_CASE("powers and roots have exact dimensions") {
    CHECK(signature_of("sqrt(shaft.d)").dimension == Dimension::of(1, 0, 0).power(1, 2));
    CHECK(signature_of("cbrt(8 mm^3)").dimension == Dimension::of(1, 0, 0));
    CHECK(signature_of("(16*lever.drive.M/(pi*shaft.segments[2].tau))^(1/3)").dimension == Dimension::of(1, 0, 0));
    CHECK(signature_of("shaft.d^-2").dimension == Dimension::of(-2, 0, 0));
    CHECK(signature_of("(32 mm^5)^0.2").dimension == Dimension::of(1, 0, 0));
    CHECK(signature_of("(shaft.d/(1 mm))^0.37").dimension.is_number());
  }

  TEST_CASE("a series stays one until it is reduced") {
    CHECK(signature_of("2 * lever.drive.M").axis == &crank());
    CHECK(signature_of("max(lever.drive.M, 0 N*m)").axis == &crank());
    CHECK(signature_of("abs(column.N)").axis == &height());
    CHECK(signature_of("max(abs(column.N))").axis == nullptr);
  }
}
