#include "lib/text/latex.hpp"

#include <doctest/doctest.h>

#include <string_view>
#include <vector>

using namespace loadpath;

TEST_SUITE("text") {
  TEST_CASE("words in LaTeX are never read as markup") {
    struct Row {
      std::string_view words, written;
    };
    for (const Row& row :
         std::vector<Row>{{"lever_1.toml: 5 % of $x$ & #2", "lever\\_1.toml: 5 \\% of \\$x\\$ \\& \\#2"},
                          {"\\input{a} ^ ~ `b`",
                           "\\textbackslash{}input\\{a\\} \\textasciicircum{} "
                           "\\textasciitilde{} \\textasciigrave{}b\\textasciigrave{}"},
                          {"--json, << >> ,, ''", "-{}-json, <{}< >{}> ,{}, '{}'"},
                          {"[2] of a[1]", "{[}2] of a[1]"},
                          {"* a*", "{*} a*"},
                          {"τ ≤ 3·10⁻⁵ m²", "τ ≤ 3·10⁻⁵ m²"},
                          {"a\nb\x7f\tc", "a b c"},
                          {"", ""}}) {
      CAPTURE(row.words);
      CHECK(latex_text(row.words) == row.written);
    }
  }

  TEST_CASE("bytes that are not UTF-8 become letters or are dropped") {
    CHECK(latex_text("a\xffz") == "aÿz");
    CHECK(latex_text("a\x80z") == "az");
  }
}
