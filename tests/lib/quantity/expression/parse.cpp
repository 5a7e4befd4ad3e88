#include "tests/lib/quantity/expression/world.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace loadpath;
using namespace loadpath::expression_test;

namespace {

struct Row {
  std::string_view text;
  double expected;
};

struct Wrong {
  std::string_view text;
  std::string_view marked;  // the part of the text that the fault points at; empty: behind the end
  std::string_view message;
  std::string_view hint;
};

void check_wrong(const Wrong& wrong) {
  CAPTURE(wrong.text);
  const auto parsed = Expression::parse(wrong.text);
  REQUIRE_FALSE(parsed);
  const Fault& fault = parsed.fault();
  CHECK(fault.message.text() == wrong.message);
  CHECK(fault.hint.text() == wrong.hint);
  CHECK(fault.length > 0);
  if (wrong.marked.empty()) {
    CHECK(fault.at == wrong.text.size());
  } else {
    CHECK(wrong.text.substr(fault.at, fault.length) == wrong.marked);
  }
}

constexpr std::string_view value_hint = "write a number, a reference such as lever.drive.M, or a function";
constexpr std::string_view unit_hint = "a unit is written as in 30 N/mm^2; to raise the quantity write (3 mm)^2";
constexpr std::string_view close_hint = "write ')' after its last value";
constexpr std::string_view times_hint = "write * between them";

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("a part of a reference that is not a name is in quotes") {
    const auto parsed = Expression::parse("2*tables.sections.\"IPE 330\".I_y + tables.materials.\"1.0038\".E * x.y");
    REQUIRE(parsed);
    const auto& references = parsed->references();
    REQUIRE(references.size() == 3);
    CHECK(references[0].path == "tables.sections.\"IPE 330\".I_y");
    CHECK(references[1].path == "tables.materials.\"1.0038\".E");
    CHECK(references[2].path == "x.y");
    CHECK_FALSE(Expression::parse("tables.sections.\"IPE 330.I_y"));
    CHECK_FALSE(Expression::parse("tables.sections.\"\".I_y"));
  }

  TEST_CASE("references are listed as written, with their places") {
    const auto parsed = Expression::parse("2 N*m + lever.drive.M*shaft.segments[2].tau - shaft.segments.journal.tau");
    REQUIRE(parsed);
    const auto& references = parsed->references();
    REQUIRE(references.size() == 3);
    CHECK(references[0].path == "lever.drive.M");
    CHECK(references[0].at == 8);
    CHECK(references[1].path == "shaft.segments[2].tau");
    CHECK(references[2].path == "shaft.segments.journal.tau");
  }

  TEST_CASE("a unit ends before a reference, a call, a number and pi") {
    struct Quantity {
      std::string_view text;
      double si;
      Dimension dimension;
    };
    constexpr Dimension number, length = Dimension::of(1, 0, 0), moment = Dimension::of(2, 1, -2);
    constexpr Dimension stress = Dimension::of(-1, 1, -2), mass = Dimension::of(0, 1, 0);
    const Quantity rows[] = {
        {"300 mm^2", 300e-6, length * length},
        {"300 mm²", 300e-6, length * length},
        {"2 N*m*lever.mass", 160.0, moment * mass},
        {"2 N*m / shaft.d", 50.0, moment / length},
        {"2 N * m", 2.0, moment},
        {"2 kN·m", 2000.0, moment},
        {"2 kN·m·shaft.d", 80.0, moment * length},
        {"3*4 mm", 0.012, length},
        {"40 mm*cos(0 deg)", 0.04, length},
        {"40 mm*cos (0 deg)", 0.04, length},
        {"2 m*pi", 2.0 * std::numbers::pi, length},
        {"45 rad/s", 45.0, Dimension::of(0, 0, -1, 0, 1)},
        {"5 Hz", 5.0, Dimension::of(0, 0, -1)},
        {"30 W/(m*K)", 30.0, Dimension::of(1, 1, -3, -1)},
        {"30 W/(m*K)*lever.mass", 2400.0, Dimension::of(1, 2, -3, -1)},
        {"6 N/mm^2/2", 3e6, stress},
        {"6 N/mm^2/(2)", 3e6, stress},
        {"6 MPa*m^(1/2)", 6e6, stress * length.power(1, 2)},
        {"6 m/2 m", 3.0, number},
        {"20 %", 0.2, number},
        {"1.5e3", 1500.0, number},
        {".5", 0.5, number},
        {"2 kg*lever.mass/(40 kg)", 4.0, mass},
    };
    for (const auto& row : rows) {
      CAPTURE(row.text);
      const Value value = value_of(row.text);
      CHECK(value.si.front() == doctest::Approx(row.si).epsilon(1e-14));
      CHECK(value.signature.dimension == row.dimension);
    }
  }

  TEST_CASE("a number with a unit is the same double as the plain literal") {
    CHECK(value_of("0.3 mm").si.front() == 0.0003);
    CHECK(value_of("45.7 MPa").si.front() == 45.7e6);
  }

  TEST_CASE("g is the gram inside a unit and gravity elsewhere") {
    CHECK(value_of("5 g").signature.dimension == Dimension::of(0, 1, 0));
    CHECK(value_of("5 g").si.front() == 0.005);
    CHECK(value_of("80 kg*(g)").si.front() == 80.0 * 9.80665);
    CHECK(value_of("lever.mass * g").si.front() == 80.0 * 9.80665);
    CHECK(value_of("2*g").si.front() == 2.0 * 9.80665);
    CHECK(value_of("80 kg*g").signature.dimension == Dimension::of(0, 2, 0));
  }

  TEST_CASE("operators bind as usual") {
    const Row rows[] = {
        {"2 + 3*4", 14},    {"2*3 + 4", 10}, {"10 - 4 - 3", 3}, {"16/4/2", 2},    {"-2^2", -4},  {"(-2)^2", 4},
        {"2^3^2", 512},     {"2^-1", 0.5},   {"2*-3", -6},      {"--2", 2},       {"3 − 5", -2}, {"4^(1/2)", 2},
        {"12 / 3 * 4", 16}, {"2 · 3", 6},    {"((7))", 7},      {"\t1\n+\r2", 3}, {"10-4+3", 9}, {"1 + 2 - 4", -1},
    };
    for (const auto& row : rows) {
      CAPTURE(row.text);
      CHECK(value_of(row.text).si.front() == doctest::Approx(row.expected).epsilon(1e-15));
    }
  }

  TEST_CASE("a wrong text is refused with its place, the rule and the remedy") {
    const Wrong rows[] = {
        {"2 +", "", "a value is missing at the end", value_hint},
        {"* 2", "*", "a value is missing before '*'", value_hint},
        {"()", ")", "a value is missing before ')'", value_hint},
        {"2 m ** 2", "*", "a value is missing before '*'", value_hint},
        {"π * 2", "π", "a value is missing before 'π'", value_hint},
        {"((1)", "(", "'(' is not closed", close_hint},
        {"peak(lever.drive.M", "(", "'(' is not closed", close_hint},
        {"1)", ")", "unexpected ')'", "no '(' is open"},
        {"tables.sections.IPE 330.I_y", "3", "a name with characters other than letters and digits needs double quotes",
         "write '=tables.sections.\"IPE 330\".I_y', in single quotes for TOML"},
        {"tables.materials.16Mo3.E", ".", "a name with characters other than letters and digits needs double quotes",
         "write '=tables.sections.\"IPE 330\".I_y', in single quotes for TOML"},
        {"2 $ 3", "$", "unexpected '$'", "the operators are + - * / ^"},
        {"2 × 3", "×", "unexpected '×'", "the operators are + - * / ^"},
        {"shaft.segments[a].d", "[", "unexpected '['",
         "an index in a reference is an integer, as in shaft.segments[2].tau"},
        {"2(3)", "(", "an operator is missing before '('", times_hint},
        {"30 MPa (2)", "(", "an operator is missing before '('", times_hint},
        {"1 2", "2", "an operator is missing before '2'", times_hint},
        {"2 lever.mass", "lever.mass", "an operator is missing before 'lever.mass'", times_hint},
        {"2 cos(1)", "cos", "an operator is missing before 'cos'", times_hint},
        {"2 pi", "pi", "an operator is missing before 'pi'", times_hint},
        {"1e400", "1e400", "the number '1e400' is too large or too small", "choose a larger or a smaller unit"},
        {"1e308 kN", "kN", "the number is too large in 'kN'", "choose another unit"},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("an empty expression is reported with what to write") {
    for (const std::string_view text : {"", "   ", "\t"}) {
      const auto parsed = Expression::parse(text);
      REQUIRE_FALSE(parsed);
      CHECK(parsed.fault().at == 0);
      CHECK(parsed.fault().message.text() == "the expression is empty");
      CHECK(parsed.fault().hint.text() == "write a value after '=', as in =2 * lever.drive.M");
    }
  }

  TEST_CASE("an unknown name is refused with the nearest right one") {
    const Wrong rows[] = {
        {"1 + peek(lever.drive.M)", "peek", "unknown function 'peek'", "did you mean 'peak'?"},
        {"Sqrt(2)", "Sqrt", "unknown function 'Sqrt'", "did you mean 'sqrt'?"},
        {"40 mm*cosine(2)", "cosine", "unknown function 'cosine'",
         "the functions are peak, amplitude, midrange, range, mean, rms, at, max, min, abs, sqrt, cbrt, exp, ln, sin, "
         "cos, tan, "
         "asin, acos, atan, atan2, hypot, mises"},
        {"2*PI", "PI", "'PI' is not a complete reference", "did you mean 'pi'?"},
        {"length + 2", "length", "'length' is not a complete reference",
         "write length.RESULT, as in lever.drive.M; a shared value is values.length"},
        {"2*d", "d", "'d' is not a complete reference",
         "write step.path, as in lever.drive.M; a unit needs a number: 1 d"},
        {"lever . mass", "lever", "'lever' is not a complete reference",
         "write lever.RESULT, as in lever.drive.M; a shared value is values.lever"},
        {"shaft[2]", "shaft", "'shaft' is not a complete reference",
         "write shaft.RESULT, as in lever.drive.M; a shared value is values.shaft"},
        {"2*peak", "peak", "'peak' is not a complete reference", "write peak(series)"},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("a wrong unit is refused at its place") {
    const Wrong rows[] = {
        {"30 mpa", "mpa", "unknown unit 'mpa'", "did you mean 'MPa'?"},
        {"1 + 2 N*furlongx", "furlongx", "unknown unit 'furlongx'", unit_hint},
        {"200 W/m/K", "/", "use parentheses after '/' to show what is divided", "write 'W/(m*K)'"},
        {"30 mm ^ 2", "^", "'^' does not belong in a unit", unit_hint},
        {"5 mm²^2", "^", "'^' does not belong in a unit", unit_hint},
        {"3 mm^lever.mass", "^", "an integer must follow '^'", unit_hint},
        {"20 °C", "°C", "'°C' is a point on a scale and cannot be used in an expression",
         "write a temperature difference in K"},
        {"(shaft.d + 2 mm) mm", "mm", "the unit 'mm' must follow a number directly",
         "write * 1 mm, as in (a + b) * 1 mm"},
        {"lever.mass N*m", "N*m", "the unit 'N*m' must follow a number directly",
         "write * 1 N*m, as in (a + b) * 1 N*m"},
        {"2 N.m", "N.m", "a dot cannot join units here: 'N.m' is a reference", "join units by *, as in 2 N*m"},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("a decimal comma is refused outside a call and separates arguments inside") {
    const Wrong rows[] = {
        {"2,5 N", "2,5", "a comma separates arguments; decimals are written with a point", "write 2.5"},
        {"max((12,75), 3)", "12,75", "a comma separates arguments; decimals are written with a point", "write 12.75"},
        {"2 + 5, 3", ",", "unexpected ','", "a comma separates the arguments of a function, as in max(a, b)"},
        {"sqrt(2,5)", "sqrt(2,5)", "wrong number of arguments of 'sqrt': 2", "write sqrt(x)"},
    };
    for (const auto& row : rows) check_wrong(row);
    CHECK(value_of("max(2,5)").si.front() == 5.0);
  }

  TEST_CASE("a wrong number of arguments is answered by the form of the function") {
    const Wrong rows[] = {
        {"peak()", "peak()", "wrong number of arguments of 'peak': 0", "write peak(series)"},
        {"max()", "max()", "wrong number of arguments of 'max': 0", "write max(series) or max(a, b)"},
        {"sin(1, 2)", "sin(1, 2)", "wrong number of arguments of 'sin': 2", "write sin(angle)"},
        {"1 + atan2(1)", "atan2(1)", "wrong number of arguments of 'atan2': 1", "write atan2(y, x)"},
        {"at(lever.drive.M)", "at(lever.drive.M)", "wrong number of arguments of 'at': 1", "write at(series, place)"},
    };
    for (const auto& row : rows) check_wrong(row);
  }

  TEST_CASE("the depth and the length of a text are limited") {
    const auto nested = [](std::size_t n) { return std::string(n, '(') + "1" + std::string(n, ')'); };
    CHECK(Expression::parse(nested(63)));
    const auto deep = Expression::parse(nested(64));
    REQUIRE_FALSE(deep);
    CHECK(deep.fault().message.text() == "parentheses, signs and exponents are nested deeper than 64");
    CHECK(deep.fault().hint.text() == "give parts of the expression to steps of their own");
    CHECK(deep.fault().at == 64);
    CHECK_FALSE(Expression::parse(std::string(900, '-') + "1"));

    std::string sum = "1";
    while (sum.size() + 2 <= 1024) sum += "+1";
    CHECK(Expression::parse(sum));
    const auto long_text = Expression::parse(sum + "+1");
    REQUIRE_FALSE(long_text);
    CHECK(long_text.fault().message.text() == "an expression is at most 1024 bytes long");
    CHECK(long_text.fault().hint.text() == "give parts of it to steps of their own");
    CHECK(long_text.fault().at == 1024);
  }
}
