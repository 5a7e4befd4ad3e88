// Formulas as text, and what of them stays MathML.
#include "lib/report/html/html.hpp"

#include <doctest/doctest.h>

using loadpath::report::page::math;

TEST_SUITE("report") {
  TEST_CASE("a formula without a fraction or a root is text, its letters in italics, its subscripts low") {
    CHECK(math("<mo>=</mo><mtext>not available</mtext>") == "<i>= not available</i>");
    CHECK(math("<mo form=\"infix\">+</mo><mi>W</mi>") == "<i> + 𝑊</i>");
    CHECK(math("<msub><mi>τ</mi><mi>t</mi></msub>") == "<i>𝜏<sub>𝑡</sub></i>");
    CHECK(math("<mi>h</mi><mo form=\"prefix\">−</mo><mi mathvariant=\"normal\">π</mi>") == "<i>\u210e−π</i>");
    CHECK(math("<mi>min</mi><mo>\u2061</mo><mrow><mn>(</mn><mi>a</mi><mo>,</mo><mn>1</mn><mn>)</mn></mrow>") ==
          "<i>min(𝑎,\u20091)</i>");
  }

  TEST_CASE("two scripts at one letter, and text that is not markup, are unchanged") {
    CHECK(math("<msubsup><mi>R</mi><mi>x</mi><mn>2</mn></msubsup>") ==
          "<math><msubsup><mi>R</mi><mi>x</mi><mn>2</mn></msubsup></math>");
    CHECK(math("a < b") == "<math>a < b</math>");
  }

  TEST_CASE("the parts of a fraction are text, its delimiters grow with it") {
    CHECK(math("<mo>=</mo><mfrac><mi>T</mi><mrow><mn>2</mn><mspace width=\"0.17em\"/><mi>W</mi></mrow></mfrac>") ==
          "= <math><mfrac><mi>T</mi><mn>2\u2009𝑊</mn></mfrac></math>");
    CHECK(math("<mo>=</mo><mfrac><mn>600\u2009N·m</mn><mrow><mn>2</mn><mo>⋅</mo><mn>24500</mn><mspace "
               "width=\"0.2em\"/><msup><mi>mm</mi><mn>3</mn></msup></mrow></mfrac>") ==
          "= <math><mfrac><mn>600\u2009N·m</mn><mn><i>2 ⋅ 24500\u2009mm<sup>3</sup></i></mn></mfrac></math>");
    CHECK(math("<mrow><mo>(</mo><mfrac><msub><mi>R</mi><mi>y</mi></msub><mi>x</mi></mfrac><mo>)</mo></mrow><mo>−</"
               "mo><mn>1</mn>") ==
          "<math><mrow><mo>(</mo><mfrac><msub><mi>R</mi><mi>y</mi></msub><mi>x</mi></mfrac><mo>)</mo></"
          "mrow><mn>\u00a0− 1</mn></math>");
  }
}
