#include "lib/quantity/literal.hpp"

#include "lib/quantity/format.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace loadpath;
using std::numbers::pi;

namespace {

Expected in(std::string_view unit, Kind kind = Kind::plain) { return {parse_unit(unit)->dimension, kind, unit}; }

const Expected length = in("mm"), stress = in("MPa"), force = in("N"), mass = in("kg"), power = in("kW"),
               time_ = in("h");
const Expected angle = in("deg"), omega = in("rpm"), hertz = in("Hz"), number = in("-"), twist = in("deg/m"),
               inertia = in("kg*m^2");
const Expected moment = in("N*m", Kind::moment), energy = in("J", Kind::energy), stiffness = in("N/mm"),
               area = in("mm^2");
const Expected line_load{stiffness.dimension, Kind::plain, "N/mm", "q_adm"};
const Expected celsius = in("°C", Kind::temperature), kelvin = in("K", Kind::difference), expansion = in("1/K");

}  // namespace

TEST_SUITE("quantity") {
  TEST_CASE("notations of drawings, catalogues and textbooks are read") {
    struct Row {
      std::string_view text;
      const Expected& expected;
      double si;
    };
    const Row rows[] = {
        {"30 MPa", stress, 30e6},
        {"30MPa", stress, 30e6},
        {"  30 MPa  ", stress, 30e6},
        {"30\u00A0MPa", stress, 30e6},
        {"210 GPa", stress, 210e9},
        {"355 N/mm²", stress, 355e6},
        {"355 N/mm^2", stress, 355e6},
        {"2,1·10^5 МПа", stress, 2.1e11},
        {"2.1x10^5 MPa", stress, 2.1e11},
        {"10^6 Pa", stress, 1e6},
        {"6 bar", stress, 6e5},
        {"1 atm", stress, 101325},
        {"100 psi", stress, 689475.7293168361},
        {"30 ksi", stress, 206842718.79505083},
        {"5 kgf/cm²", stress, 490332.5},
        {"50 mm", length, 0.05},
        {"50,5 mm", length, 0.0505},
        {"-5 mm", length, -0.005},
        {"−5 мм", length, -0.005},
        {"1 200 mm", length, 1.2},
        {"1'200 mm", length, 1.2},
        {"1_200 mm", length, 1.2},
        {"0.5 µm", length, 5e-7},
        {"0.5 um", length, 5e-7},
        {"2 in", length, 0.0508},
        {"1/2 in", length, 0.0127},
        {"1-1/2 in", length, 0.0381},
        {"1 1/2 in", length, 0.0381},
        {"6 ft", length, 1.8288},
        {"3 mil", length, 7.62e-5},
        {"3 inches", length, 0.0762},
        {"5 kN", force, 5000},
        {"5 кН", force, 5000},
        {"5000 newton", force, 5000},
        {"100 lbf", force, 444.82216152605},
        {"10 kip", force, 44482.216152605},
        {"10 kgf", force, 98.0665},
        {"1e3 N", force, 1000},
        {"3 kg*m/s^2", force, 3},
        {"3 kg·m/s²", force, 3},
        {"2 kg", mass, 2},
        {"2 t", mass, 2000},
        {"2 lb", mass, 0.90718474},
        {"15 g", mass, 0.015},
        {"900 N*m", moment, 900},
        {"900 N·m", moment, 900},
        {"900 N⋅m", moment, 900},
        {"900 N.m", moment, 900},
        {"900 N m", moment, 900},
        {"900 Nm", moment, 900},
        {"0,9 kNm", moment, 900},
        {"9·10^5 Nmm", moment, 900},
        {"900 Н·м", moment, 900},
        {"100 lbf-ft", moment, 135.58179483314004},
        {"100 lbf*in", moment, 11.298482902761669},
        {"5 J", energy, 5},
        {"5 N*m", energy, 5},
        {"2 kWh", energy, 7.2e6},
        {"11 kW", power, 11000},
        {"11 кВт", power, 11000},
        {"5 hp", power, 3728.499357911351},
        {"5 PS", power, 3677.49375},
        {"5 к.с.", power, 3677.49375},
        {"5 л.с.", power, 3677.49375},
        {"5 N*m/s", power, 5},
        {"30 deg", angle, pi / 6},
        {"30°", angle, pi / 6},
        {"0.5 rad", angle, 0.5},
        {"0,5 рад", angle, 0.5},
        {"2 rev", angle, 4 * pi},
        {"3 arcmin", angle, pi / 3600},
        {"900 rpm", omega, 30 * pi},
        {"900 1/min", omega, 30 * pi},
        {"900 min^-1", omega, 30 * pi},
        {"900 min⁻¹", omega, 30 * pi},
        {"900 rev/min", omega, 30 * pi},
        {"900 об/мин", omega, 30 * pi},
        {"15 rev/s", omega, 30 * pi},
        {"12 rad/s", omega, 12},
        {"180 deg/s", omega, pi},
        {"50 Hz", hertz, 50},
        {"2 kHz", hertz, 2000},
        {"3000 1/min", hertz, 50},
        {"50 s^-1", hertz, 50},
        {"20000 h", time_, 7.2e7},
        {"100 000 h", time_, 3.6e8},
        {"20 000 ч", time_, 7.2e7},
        {"10 d", time_, 864000},
        {"20 °C", celsius, 293.15},
        {"68 °F", celsius, 293.15},
        {"293 K", celsius, 293},
        {"40 K", kelvin, 40},
        {"1.2e-5 1/K", expansion, 1.2e-5},
        {"1.2e-5 /K", expansion, 1.2e-5},
        {"12 µm/(m*K)", expansion, 1.2e-5},
        {"0.25 deg/m", twist, pi / 720},
        {"0.004 rad/m", twist, 0.004},
        {"0.02 kg*m²", inertia, 0.02},
        {"2 N/mm", stiffness, 2000},
        {"125 mm2", area, 1.25e-4},
        {"5 %", number, 0.05},
        {"1.5", number, 1.5},
        {"1/2", number, 0.5},
        {"300 µm/m", number, 3e-4},
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<Literal> literal = parse_literal(row.text, row.expected);
      REQUIRE(literal);
      CHECK(std::fabs(literal->si / row.si - 1.0) <= 1e-15);
      CHECK(literal->dimension == row.expected.dimension);
    }
  }

  TEST_CASE("a text that needs a guess, or is of another kind, is refused with the place and a remedy") {
    struct Row {
      std::string_view text;
      const Expected& expected;
      std::size_t at, length;
      std::string_view message, hint;
    };
    const Row rows[] = {
        {"30 kg", length, 0, 5, "'30 kg' is a mass; a length is expected", "write a unit such as mm"},
        {"30", length, 0, 2, "'30' has no unit; a length is expected", "write '30 mm'"},
        {"30", angle, 0, 2, "'30' has no unit; an angle is expected", "write '30 deg'"},
        {" 1 200 ", omega, 1, 5, "'1 200' has no unit; an angular velocity is expected", "write '1 200 rpm'"},
        {"30 mm", number, 0, 5, "'30 mm' is a length; a plain number is expected", "write the number without a unit"},
        {"15 Hz", omega, 0, 5, "'15 Hz' is a frequency; an angular velocity is expected",
         "write it in rpm or in rad/s"},
        {"15 1/s", omega, 0, 6, "'15 1/s' is ambiguous: radians or revolutions", "write 'rad/s' or 'rev/s'"},
        {"15 rpm", hertz, 0, 6, "'15 rpm' is an angular velocity; a frequency is expected", "write a unit such as Hz"},
        {"5 J", moment, 0, 3, "'5 J' is an energy; a moment is expected", "write it in N*m"},
        {"5 kJ", force, 0, 4, "'5 kJ' is an energy; a force is expected", "write a unit such as N"},
        {"5 N*m", inertia, 0, 5, "'5 N*m' is a moment; a moment of inertia is expected", "write a unit such as kg*m^2"},
        {"20 °C", kelvin, 0, 6, "'20 °C' is a point on the temperature scale; a difference is expected",
         "write the difference in K"},
        {"1.2e-5 /°C", expansion, 7, 4, "'/°C': a point on a temperature scale cannot be used in a product",
         "write the temperature difference in K"},
        {"30 kg", force, 0, 5, "'30 kg' is a mass; a force is expected",
         "a force is written in N, kgf or lbf, a mass in kg or lb"},
        {"50 ft-lb", moment, 0, 8, "'50 ft-lb' is a quantity in kg*m; a moment is expected",
         "lb is a mass: a torque is written in lbf*ft or lbf*in"},
        {"30 N/mm^2", line_load, 0, 9, "'30 N/mm^2' is a stress; a load per length is expected",
         "write a unit such as N/mm"},
        {"30", line_load, 0, 2, "'30' has no unit; a load per length is expected", "write '30 N/mm'"},
        {"30 N", stiffness, 0, 4, "'30 N' is a force; a stiffness is expected", "write a unit such as N/mm"},
        {"30 N/mm", force, 0, 7, "'30 N/mm' is a stiffness or load per length; a force is expected",
         "write a unit such as N"},
        {"300 HB", number, 4, 2, "unknown unit 'HB'", "write the number without a unit"},
        {"350 mpa", stress, 4, 3, "unknown unit 'mpa'", "did you mean 'MPa'?"},
        {"30 mn", length, 3, 2, "unknown unit 'mn'", "did you mean 'mm'?"},
        {"30 Cm", length, 3, 2, "unknown unit 'Cm'", "did you mean 'cm'?"},
        {"30 mn", force, 3, 2, "unknown unit 'mn'", "did you mean 'mN'?"},
        {"30 mn", moment, 3, 2, "unknown unit 'mn'", "write a unit such as N*m"},
        {"30 knm", moment, 3, 3, "unknown unit 'knm'", "did you mean 'kNm'?"},
        {"30 n*m", moment, 3, 1, "unknown unit 'n'", "did you mean 'N'?"},
        {"1,250 mm", length, 0, 5, "'1,250' is ambiguous", "write '1.250' or '1250'"},
        {"2 ft 3 in", length, 5, 1, "a second number '3'",
         "write one number and one unit; digits are grouped by exactly three; an expression begins with '='"},
        {"12 34 mm", length, 3, 2, "a second number '34'",
         "write one number and one unit; digits are grouped by exactly three; an expression begins with '='"},
        {"30 mm;", length, 5, 1, "';' does not belong in a unit", "write a number and a unit, as in '30 mm'"},
        {"", length, 0, 1, "a number is missing", "write a number and a unit, as in '30 mm'"},
        {"  ", number, 0, 1, "a number is missing", "write a plain number"},
        {"?", length, 0, 1, "a number must come first, not '?'", "write a number and a unit, as in '30 mm'"},
        {"1e300 Gm", length, 0, 8, "'1e300 Gm' is out of the range of numbers", ""},
        {"1e-300 pm", length, 0, 9, "'1e-300 pm' is out of the range of numbers", ""},
        {"30 \x1b[31m", length, 3, 1, "a control character does not belong in a quantity",
         "write a number and a unit, as in '30 mm'"},
        {"30 m\xff", length, 4, 1, "this byte is not UTF-8 text", "write it in UTF-8"},
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<Literal> literal = parse_literal(row.text, row.expected);
      REQUIRE_FALSE(literal);
      CHECK(literal.fault().at == row.at);
      CHECK(literal.fault().length == row.length);
      CHECK(literal.fault().message.text() == row.message);
      CHECK(literal.fault().hint.text() == row.hint);
    }
  }

  TEST_CASE("a text that is too long is refused before it is read") {
    const Outcome<Literal> literal = parse_literal(std::string(300, '1'), length);
    REQUIRE_FALSE(literal);
    CHECK(literal.fault().at == 256);
    CHECK(literal.fault().message.text() == "a quantity of more than 256 characters");
  }

  TEST_CASE("the torque of one shaft is the same in three unit systems") {
    CHECK(parse_literal("900 N·m", moment)->si == 900.0);
    CHECK(parse_literal("0.9 kN·m", moment)->si == 900.0);
    CHECK(std::fabs(parse_literal("7965.671 lbf·in", moment)->si / 900.0 - 1.0) <= 0.0005 / 7965.671);
  }

  TEST_CASE("without an expected dimension any unit is read, and none") {
    CHECK(parse_literal("20 °C")->si == 293.15);
    CHECK(parse_literal("3")->dimension.is_number());
    CHECK(parse_literal("120 1/min")->si == 2.0);
  }
}
