#include "lib/quantity/unit.hpp"

#include "lib/quantity/literal.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace loadpath;

TEST_SUITE("quantity") {
  TEST_CASE("spellings of one unit are equal to the bit") {
    const std::vector<std::vector<std::string_view>> same = {
        {"N*m", "N·m", "N⋅m", "N.m", "N m", "Nm", "N-m", "Н·м", "Нм", "N * m", "(N*m)", "m N", "newton metre", "J"},
        {"mm^2", "mm²", "mm2", "мм²", "(mm)^2", "mm*mm"},
        {"min^-1", "min⁻¹", "min-1", "1/min", "/min", "1 / min"},
        {"kN*mm", "kNmm", "N*m", "кН·мм"},
        {"W/(m*K)", "W/(m K)", "W*m^-1*K^-1", "(W/m)/K"},
        {"um", "µm", "μm", "мкм", "micrometre", "micrometers"},
        {"rpm", "rev/min", "r/min", "об/мин", "U/min", "tr/min"},
        {"PS", "л.с.", "л. с.", "к.с.", "к. с."},
        {"MPa", "МПа", "N/mm^2", "N/mm²", "megapascal"},
        {"MPa*m^0.5", "MPa·m^(1/2)"},
        {"°C", "ºC", "\u2103", "degC", "°С"},
        {"deg", "°", "град", "degrees"},
        {"lbf*ft", "lbf-ft", "ft-lbf", "ft*lbf"},
    };
    for (const auto& spellings : same) {
      const Outcome<UnitValue> first = parse_unit(spellings.front());
      for (const std::string_view text : spellings) {
        CAPTURE(text);
        const Outcome<UnitValue> unit = parse_unit(text);
        REQUIRE(unit);
        CHECK(unit->factor == first->factor);
        CHECK(unit->offset == first->offset);
        CHECK(unit->dimension == first->dimension);
      }
    }
  }

  TEST_CASE("factors are those of the definitions") {
    struct Row {
      std::string_view unit;
      double si;
      std::string_view definition;
    };
    const Row rows[] = {
        {"mm^3", 1e-9, "SI prefixes"},
        {"mm^4", 1e-12, "SI prefixes"},
        {"in", 0.0254, "25.4 mm"},
        {"ft", 0.3048, "12 in"},
        {"mil", 2.54e-5, "in/1000"},
        {"lb", 0.45359237, "7000 grains of 64.79891 mg"},
        {"lbf", 4.4482216152605, "lb times standard gravity"},
        {"kip", 4448.2216152605, "1000 lbf"},
        {"psi", 6894.757293168361, "lbf/in^2"},
        {"ksi", 6894757.293168361, "1000 lbf/in^2"},
        {"hp", 745.6998715822702, "550 ft lbf/s"},
        {"PS", 735.49875, "75 kgf m/s"},
        {"kgf", 9.80665, "kg times standard gravity"},
        {"bar", 1e5, "1e5 Pa"},
        {"atm", 101325, "standard atmosphere"},
        {"t", 1000, "1000 kg"},
        {"d", 86400, "24 h"},
        {"l", 1e-3, "1 dm^3"},
        {"cSt", 1e-6, "1 mm^2/s"},
        {"cP", 1e-3, "1 mPa s"},
        {"kWh", 3.6e6, "3600 kJ"},
        {"slug", 14.593902937206364, "lbf s^2/ft"},
        {"mph", 0.44704, "1760 yd/h"},
    };
    for (const Row& row : rows) {
      CAPTURE(row.unit);
      CAPTURE(row.definition);
      CHECK(std::fabs(parse_unit(row.unit)->factor / row.si - 1.0) <= 4e-16);
    }
  }

  TEST_CASE("an unknown unit is refused with the place and the nearest valid word") {
    struct Row {
      std::string_view text;
      std::size_t at, length;
      std::string_view message, hint;
    };
    const Row rows[] = {
        {"", 0, 1, "a unit is missing at the end", ""},
        {"mpa", 0, 3, "unknown unit 'mpa'", "did you mean 'MPa'?"},
        {"gpa", 0, 3, "unknown unit 'gpa'", "did you mean 'GPa'?"},
        {"kn", 0, 2, "unknown unit 'kn'", "did you mean 'kN'?"},
        {"KN", 0, 2, "unknown unit 'KN'", "did you mean 'kN'?"},
        {"Kg", 0, 2, "unknown unit 'Kg'", "did you mean 'kg'?"},
        {"MM", 0, 2, "unknown unit 'MM'", "did you mean 'mm'?"},
        {"RPM", 0, 3, "unknown unit 'RPM'", "did you mean 'rpm'?"},
        {"мпа", 0, 6, "unknown unit 'мпа'", "did you mean 'МПа'?"},
        {"kgm", 0, 3, "unknown unit 'kgm'", "did you mean 'kg*m'?"},
        {"kN*mn", 3, 2, "unknown unit 'mn'", "did you mean 'mN'?"},
        {"кH", 0, 3, "the unit 'кH' mixes Latin and Cyrillic letters", "did you mean 'кН'?"},
        {"OO", 0, 2, "unknown unit 'OO'", "write the digit 0, not the letter O"},
        {"zorkmid", 0, 7, "unknown unit 'zorkmid'", ""},
        {"N/m*s", 3, 1, "use parentheses after '/' to show what is divided", "write 'N/(m*s)' or 'N*s/m'"},
        {"W/m K", 3, 1, "use parentheses after '/' to show what is divided", "write 'W/(m*K)' or 'W*K/m'"},
        {"µm/m/K", 5, 1, "use parentheses after '/' to show what is divided", "write 'µm/(m*K)'"},
        {"1/m*s", 3, 1, "use parentheses after '/' to show what is divided", "write '1/(m*s)' or 's/m'"},
        {"N/m/(K*s)", 3, 1, "use parentheses after '/' to show what is divided",
         "write one '/' and parentheses, as in 'W/(m*K)'"},
        {"Nm²", 0, 4, "'Nm²' is ambiguous", "write 'N*m²'"},
        {"kNmm^2", 0, 6, "'kNmm^2' is ambiguous", "write 'kN*mm^2'"},
        {"(m", 0, 1, "this '(' is not closed", ""},
        {"m)", 1, 1, "this ')' has no '('", ""},
        {"m+2", 1, 1, "'+' does not belong in a unit", ""},
        {"m^", 1, 1, "an integer must follow '^'", ""},
        {"m^(2", 1, 3, "the '(' of the exponent is not closed", ""},
        {"m^0", 1, 2, "an exponent of 0 leaves no unit", ""},
        {"m^(2/5)", 1, 6, "'^(2/5)' is not a valid exponent of a unit", ""},
        {"m^13", 1, 3, "'^13' is too large a power for a unit", ""},
        {"((m^9)^9)^9", 1, 7, "'(m^9)^9' is too large a power for a unit", ""},
        {"m*", 2, 1, "a unit is missing at the end", ""},
        {"1/(m*°C)", 0, 9, "'1/(m*°C)': a point on a temperature scale cannot be used in a product",
         "write the temperature difference in K"},
        {"mm 5", 3, 1, "a second number '5'",
         "write one number and one unit; digits are grouped by exactly three; an expression begins with '='"},
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<UnitValue> unit = parse_unit(row.text);
      REQUIRE_FALSE(unit);
      CHECK(unit.fault().at == row.at);
      CHECK(unit.fault().length == row.length);
      CHECK(unit.fault().message.text() == row.message);
      CHECK(unit.fault().hint.text() == row.hint);
    }
  }

  TEST_CASE("a ratio has the unit '-' or '1'") {
    CHECK(parse_unit("-")->factor == 1.0);
    CHECK(parse_unit("1")->dimension.is_number());
  }

  TEST_CASE("a value is converted to SI and back") {
    const Outcome<ParsedUnit> celsius = read_unit("°C", 0);
    CHECK(celsius->to_si(20.0) == 293.15);
    CHECK(std::fabs(celsius->from_si(293.15) - 20.0) <= 1e-12);
    CHECK(read_unit("in", 0)->to_si(1.5) == 0.0381);
    CHECK(read_unit("mm", 0)->from_si(0.07) == 70.0);
  }
}
