#include "lib/text/utf8.hpp"

#include <doctest/doctest.h>

using namespace loadpath;

TEST_SUITE("utf8") {
  TEST_CASE("malformed bytes are found at their position") {
    struct Row {
      std::string_view text;
      std::size_t at;
    };
    const Row rows[] = {
        {"", std::string_view::npos},
        {"plain text that is longer than eight", std::string_view::npos},
        {"Н·м °C 𝛔", std::string_view::npos},
        {"ab\x80", 2},            // a tail without a lead
        {"\xC0\xAF", 0},          // overlong
        {"\xE0\x80\xAF", 0},      // overlong
        {"\xF0\x80\x80\xAF", 0},  // overlong
        {"a\xED\xA0\x80", 1},     // a surrogate
        {"\xF4\x90\x80\x80", 0},  // beyond U+10FFFF
        {"\xFF", 0},
        {"12345678\xE2\x82", 8},  // cut off
    };
    for (const Row& row : rows) {
      CAPTURE(row.text);
      CHECK(first_invalid_byte(row.text) == row.at);
    }
  }

  TEST_CASE("code points and text are inverse to each other") {
    const std::string text = "a é Ж € 𝛔";
    CHECK(code_points(text) == U"a é Ж € 𝛔");
    CHECK(utf8(code_points(text)) == text);
  }

  TEST_CASE("a byte that is not text is taken as its own code") {
    CHECK(code_points("\xFF"
                      "a") == U"\u00FFa");
  }

  TEST_CASE("capitals of both alphabets have small letters") {
    const std::u32string capitals = U"AZАЯЁІЇЄҐ7", small = U"azаяёіїєґ7";
    for (std::size_t i = 0; i < capitals.size(); ++i) CHECK(lower_case(capitals[i]) == small[i]);
  }
}
