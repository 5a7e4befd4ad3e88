#include "lib/quantity/number/number.hpp"

#include <doctest/doctest.h>

using namespace loadpath;

TEST_SUITE("quantity") {
  TEST_CASE("a number is read as people write it, and the reader stops after it") {
    struct Row {
      std::string_view text;
      double value;
      std::string_view rest;
    };
    const Row rows[] = {
        {"30", 30, ""},
        {"30mm", 30, "mm"},
        {"+30", 30, ""},
        {"-5", -5, ""},
        {"\u22125", -5, ""},
        {".5", 0.5, ""},
        {"-,5", -0.5, ""},
        {"2,5", 2.5, ""},
        {"2.5", 2.5, ""},
        {"1e6", 1e6, ""},
        {"1E-6", 1e-6, ""},
        {"1e\u22126", 1e-6, ""},
        {"5e", 5, "e"},
        {"10^6", 1e6, ""},
        {"10^-3", 1e-3, ""},
        {"10^(-3)", 1e-3, ""},
        {"10⁻³", 1e-3, ""},
        {"-10^6", -1e6, ""},
        {"2·10^6", 2e6, ""},
        {"2⋅10⁶", 2e6, ""},
        {"2*10^6", 2e6, ""},
        {"2x10^6", 2e6, ""},
        {"2×10^6", 2e6, ""},
        {"2\u044510^6", 2e6, ""},
        {"2,5 · 10^6 N", 2.5e6, " N"},
        {"1 200", 1200, ""},
        {"1'200", 1200, ""},
        {"1_200", 1200, ""},
        {"1\u00A0200", 1200, ""},
        {"1\u2009200", 1200, ""},
        {"1\u202F200", 1200, ""},
        {"1 234 567,89", 1234567.89, ""},
        {"100 000 h", 100000, " h"},
        {"0,125", 0.125, ""},
        {"1234,567", 1234.567, ""},
        {"1.250", 1.25, ""},
        {"1/2 in", 0.5, " in"},
        {"3/2", 1.5, ""},
        {"1-1/2", 1.5, ""},
        {"1 1/2", 1.5, ""},
        {"-1 1/2", -1.5, ""},
        {"0 3/4", 0.75, ""},
        {"120 1/min", 120, " 1/min"},
        {"1 200 1/min", 1200, " 1/min"},
        {"0e999999", 0, ""},
        {"0.000", 0, ""},
        {"1.7976931348623157e308", 1.7976931348623157e308, ""},
        {"2.2250738585072014e-308", 2.2250738585072014e-308, ""},
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<Number> number = read_number(row.text, 0);
      REQUIRE(number);
      CHECK(number->value == row.value);
      CHECK(row.text.substr(number->end) == row.rest);
    }
  }

  TEST_CASE("groups have exactly three digits and one mark, else the number ends before them") {
    struct Row {
      std::string_view text, rest;
    };
    const Row rows[] = {{"1 20", " 20"},       {"1 2000", " 2000"},   {"1234 567", " 567"}, {"0 200", " 200"},
                        {"1 200'300", "'300"}, {"1'200 300", " 300"}, {"1_20", "_20"},      {"1.5 200", " 200"}};
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<Number> number = read_number(row.text, 0);
      REQUIRE(number);
      CHECK(row.text.substr(number->end) == row.rest);
    }
  }

  TEST_CASE("a text that is not a number, or can be read in two ways, is refused with the place and a remedy") {
    struct Row {
      std::string_view text;
      std::size_t at, length;
      std::string_view message, hint;
    };
    const Row rows[] = {
        {"1,250 mm", 0, 5, "'1,250' is ambiguous", "write '1.250' or '1250'"},
        {"12,500", 0, 6, "'12,500' is ambiguous", "write '12.500' or '12500'"},
        {"1,234.5", 0, 7, "'1,234.5' has more than one decimal mark", "write '1234.5'"},
        {"1.234,5", 0, 7, "'1.234,5' has more than one decimal mark", "write '1234.5'"},
        {"1,250,000", 0, 9, "'1,250,000' has more than one decimal mark", "write '1250000'"},
        {"1.2.3", 0, 5, "'1.2.3' has more than one decimal mark", ""},
        {"5. mm", 1, 1, "a digit must follow the '.'", ""},
        {"–5 mm", 0, 3, "a dash is not a minus sign", "write '-'"},
        {"0x10", 0, 2, "hexadecimal numbers are not accepted", "write the number with decimal digits"},
        {"inf", 0, 3, "'inf' is not a finite number", ""},
        {"-NaN mm", 1, 3, "'NaN' is not a finite number", ""},
        {"∞", 0, 3, "'∞' is not a finite number", ""},
        {"", 0, 1, "a number is missing", ""},
        {"mm 5", 0, 2, "a number must come first, not 'mm'", ""},
        {"1e400", 0, 5, "'1e400' is out of the range of numbers", "magnitudes must be from 1e-300 to 1e300"},
        {"1e-400", 0, 6, "'1e-400' is out of the range of numbers", "magnitudes must be from 1e-300 to 1e300"},
        {"5e-320", 0, 6, "'5e-320' is out of the range of numbers", "magnitudes must be from 1e-300 to 1e300"},
        {"5^2", 1, 1, "only 10 with an integer exponent is read as a power", "write 2·10^6 or 2e6"},
        {"5²", 1, 2, "only 10 with an integer exponent is read as a power", "write 2·10^6 or 2e6"},
        {"1/0", 2, 1, "a fraction cannot have the denominator 0", ""},
        {"1/2.5", 3, 1, "a fraction consists of integers", ""},
        {"1 3/2", 1, 4, "'1 3/2' is ambiguous", "write a decimal number, or an integer and a fraction less than 1"},
        {"1 200/300", 1, 8, "'1 200/300' is ambiguous",
         "write a decimal number, or an integer and a fraction less than 1"},
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      const Outcome<Number> number = read_number(row.text, 0);
      REQUIRE_FALSE(number);
      CHECK(number.fault().at == row.at);
      CHECK(number.fault().length == row.length);
      CHECK(number.fault().message.text() == row.message);
      CHECK(number.fault().hint.text() == row.hint);
    }
  }
}
