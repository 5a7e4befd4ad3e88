#include "lib/report/terminal/layout.hpp"

#include <doctest/doctest.h>

using namespace loadpath::terminal;

TEST_SUITE("terminal layout") {
  TEST_CASE("columns that fit are side by side") {
    CHECK(columns({{"  d", "mm", "outer diameter"}, {"  theta", "deg", ""}}, 80) ==
          "  d      mm   outer diameter\n  theta  deg  \n");
  }

  TEST_CASE("a cell that does not fit is broken between its words, in its column") {
    CHECK(columns({{"  d", "mm", "outer diameter of the shaft"}}, 24) ==
          "  d  mm  outer diameter\n"
          "         of the shaft\n");
  }

  TEST_CASE("later lines of an indented cell are indented further") {
    CHECK(columns({{"  sigma = F / A", "stress"}}, 18) == "  sigma =   stress\n    F / A\n");
  }

  TEST_CASE("the widest column is narrowed first, and words are not broken") {
    CHECK(columns({{"a b", "one two three four"}}, 12) == "a b  one two\n     three\n     four\n");
    CHECK(columns({{"unbreakable", "word"}}, 5) == "unbreakable  word\n");
  }

  TEST_CASE("a coloured text is one word with the width of its letters") {
    CHECK(columns({{"\033[33mnot judged\033[0m", "a bb ccc"}}, 16) ==
          "\033[33mnot judged\033[0m  a bb\n            ccc\n");
  }

  TEST_CASE("a number stays with its unit") {
    CHECK(columns({{"90 mm", "-1.5 kN", "20 to 30 mm"}}, 18) ==
          "90 mm  -1.5 kN  20\n                to\n                30\n                mm\n");
  }

  TEST_CASE("letters are counted, not bytes") { CHECK(columns({{"µm", "x"}, {"mm", "y"}}, 80) == "µm  x\nmm  y\n"); }

  TEST_CASE("a paragraph breaks between words and has a hanging indent") {
    CHECK(paragraph("[B19] Technical mechanics", 2, 16) == "[B19] Technical\n  mechanics\n");
    CHECK(paragraph("short", 2, 16) == "short\n");
  }

  TEST_CASE("without a terminal a line has 100 characters") { CHECK(line_width() == 100); }
}
