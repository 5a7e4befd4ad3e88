#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

using namespace loadpath::formula;

namespace {

std::string plainly(std::string_view cpp) { return plain(parse(cpp).value()); }

/// Names of values: T and d with units, z without, n negative.
std::optional<Written> numbers(std::string_view name) {
  static const std::map<std::string_view, Written> values = {{"T", {"600", "N·m"}}, {"d", {"50", "mm"}},
                                                             {"z", {"8", ""}},      {"n", {"-3", ""}},
                                                             {"x", {"-2", "mm"}},   {"e", {"1.5e-5", "mm"}}};
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

struct Row {
  std::string_view cpp, print;
};

}  // namespace

TEST_SUITE("formula") {
  TEST_CASE("plain text has the fewest parentheses that keep the meaning") {
    for (const Row& row : std::vector<Row>{{"a + b - c", "a + b − c"},
                                           {"a - (b + c)", "a − (b + c)"},
                                           {"a + (b - c)", "a + b − c"},
                                           {"(a + b) * c", "(a + b) · c"},
                                           {"((a)) * ((b))", "a · b"},
                                           {"a * (b * c)", "a · b · c"},
                                           {"a / (b * c)", "a / (b · c)"},
                                           {"a / b / c", "a / (b · c)"},
                                           {"a / (b / c)", "a / (b / c)"},
                                           {"-a * b", "−a · b"},
                                           {"a * -b", "a · (−b)"},
                                           {"a - -b", "a − (−b)"},
                                           {"-(a + b)", "−(a + b)"},
                                           {"-(-a)", "−(−a)"},
                                           {"a + -b * c", "a + (−b · c)"},
                                           {"pow<2>(-a)", "(−a)²"},
                                           {"pow<2>(a / b)", "(a / b)²"},
                                           {"pow<3>(pow<2>(a))", "(a²)³"},
                                           {"-pow<2>(a)", "−a²"},
                                           {"pow(a, b + 1.0)", "a^(b + 1)"},
                                           {"pow(a, -0.107)", "a^(−0.107)"},
                                           {"pow<-2>(a)", "a⁻²"},
                                           {"a * a * 3.0 * b * b * b", "a² · 3 · b³"},
                                           {"sqrt(sqrt(a))", "∜(a)"},
                                           {"root<5>(a)", "⁵√(a)"},
                                           {"abs(a - b)", "|a − b|"},
                                           {"log(a)", "ln(a)"},
                                           {"n * a", "n · a"},
                                           {"(n + k) * a", "(n + k) · a"},
                                           {"a < b ? c : d", "a < b ? c : d"},
                                           {"2.0 * (a < b ? c : d)", "2 · (a < b ? c : d)"},
                                           {"a <= b && c != d || e", "a ≤ b and c ≠ d or e"},
                                           {"(a < b || c) && d", "(a < b or c) and d"},
                                           {"d / mm", "d / mm"},
                                           {"10.0 * N_m", "10 · N·m"},
                                           {"M / N_m", "M / (N·m)"},
                                           {"210.0e9 * eps_0", "210 · 10⁹ · ε_0"},
                                           {".50 + 100.0", "0.5 + 100"}}) {
      CAPTURE(row.cpp);
      CHECK(plainly(row.cpp) == row.print);
    }
  }

  TEST_CASE("substituted quantities keep their units apart from the formula") {
    for (const Row& row : std::vector<Row>{{"16.0 * T / (pi * pow<3>(d))", "16 · 600 N·m / (π · (50 mm)³)"},
                                           {"T * d", "(600 N·m) · (50 mm)"},
                                           {"d * z", "(50 mm) · 8"},
                                           {"d + d", "50 mm + 50 mm"},
                                           {"z * z", "8²"},
                                           {"n * z", "−3 · 8"},
                                           {"z * n", "8 · (−3)"},
                                           {"z - n", "8 − (−3)"},
                                           {"pow<2>(n)", "(−3)²"},
                                           {"-n", "−(−3)"},
                                           {"-x * z", "−(−2 mm) · 8"},
                                           {"x * z", "(−2 mm) · 8"},
                                           {"abs(x)", "|−2 mm|"},
                                           {"e * z", "(1.5 · 10⁻⁵ mm) · 8"},
                                           {"d / mm", "50 mm / mm"},
                                           {"T / d * z", "(600 N·m / 50 mm) · 8"},
                                           {"unknown * d", "unknown · 50 mm"}}) {
      CAPTURE(row.cpp);
      CHECK(plain(parse(row.cpp).value(), numbers) == row.print);
    }
  }

  TEST_CASE("HTML is text of the math font but for fractions, roots and letters with two scripts") {
    for (const Row& row : std::vector<Row>{
             {"a / b", "<math><mfrac><mi>a</mi><mi>b</mi></mfrac></math>"},
             {"2.0 * W", "2\u2009𝑊"},
             {"a * 2.0", "𝑎 ⋅ 2"},
             {"pow<2>(tau_t)", "<math><msubsup><mi>τ</mi><mi>t</mi><mn>2</mn></msubsup></math>"},
             {"tau_t * tau_t", "<math><msubsup><mi>τ</mi><mi>t</mi><mn>2</mn></msubsup></math>"},
             {"pow<2>(h)", "ℎ<sup>2</sup>"},
             {"-h + pi", "−ℎ + π"},
             {"max(a, 1.0)", "max(𝑎,\u20091)"},
             {"sqrt(a)", "<math><msqrt><mi>a</mi></msqrt></math>"},
             {"cbrt(-a)", "<math><mroot><mn>−𝑎</mn><mn>3</mn></mroot></math>"},
             {"sin(a)", "sin(𝑎)"},
             {"exp(a)", "e<sup>𝑎</sup>"},
             {"exp(a - b)", "e<sup>𝑎−𝑏</sup>"},
             {"d / mm", "<math><mfrac><mi>d</mi><mn>mm</mn></mfrac></math>"},
             {"a < b", "𝑎 &lt; 𝑏"},
             {"pi", "π"},
             {"T / (2.0 * W)", "<math><mfrac><mi>T</mi><mn>2\u2009𝑊</mn></mfrac></math>"},
             {"(R_y / x) * z - 1.0",
              "<math><mfrac><msub><mi>R</mi><mi>y</mi></msub><mi>x</mi></mfrac><mn>\u2009𝑧 − 1</mn></math>"},
             {"abs(a / b) - 1.0",
              "<math><mrow><mo>|</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>|</mo></mrow><mn>\u00A0− 1</mn></math>"},
             {"a / b + c / d",
              "<math><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>+</mo><mfrac><mi>c</mi><mi>d</mi></mfrac></math>"},
             {"pow(x, n_1)", "<math><msup><mi>x</mi><mn><i>𝑛<sub>1</sub></i></mn></msup></math>"}}) {
      CAPTURE(row.cpp);
      CHECK(html(parse(row.cpp).value()) == row.print);
    }
  }

  TEST_CASE("TeX has no backslash before punctuation") {
    for (const Row& row : std::vector<Row>{
             {"16.0 * T / (pi * pow<3>(d))", "\\frac{16\\thinspace T}{\\pi\\thinspace d^{3}}"},
             {"a * (b - c)", "a\\thinspace \\left( b - c \\right)"},
             {"abs(F)", "\\left\\vert F \\right\\vert"},
             {"root<4>(a)", "\\sqrt[4]{a}"},
             {"atan(a)", "\\arctan\\left( a \\right)"},
             {"a < b ? c : d", "\\begin{cases}c & \\text{if }a \\lt b \\cr d & \\text{otherwise}\\end{cases}"}}) {
      CAPTURE(row.cpp);
      CHECK(tex(parse(row.cpp).value()) == row.print);
    }
  }

  TEST_CASE("the branch of the values is printed, both where they are unknown") {
    const auto tree = parse("a + (b < 1.0 ? c : d) * k").value();
    const auto known = [](std::string_view name) { return name == "b" ? std::optional(0.5) : std::nullopt; };
    CHECK(plain(tree, {}, known) == "a + c · k");
    const auto nothing = [](std::string_view) { return std::optional<double>(); };
    CHECK(plain(tree, {}, nothing) == "a + (b < 1 ? c : d) · k");
  }

  TEST_CASE("a letter that is a symbol and a unit is a unit only where the symbols are known and it is not one") {
    const auto tree = parse("F / N").value();
    CHECK(html(tree) == "<math><mfrac><mi>F</mi><mi>N</mi></mfrac></math>");
    const auto known = [](std::string_view name) { return name == "F" ? std::optional(5.0) : std::nullopt; };
    CHECK(html(tree, {}, known) == "<math><mfrac><mi>F</mi><mn>N</mn></mfrac></math>");
  }

  TEST_CASE("a ratio of two values has a solidus where it is a term, and a bar in a product") {
    const auto terms = [](std::string_view cpp) { return equation_html(parse(cpp).value(), numbers); };
    CHECK(terms("T / d") == std::vector<std::string>{"= (600\u2009N·m)/(50\u2009mm)"});
    CHECK(terms("z / 2.0") == std::vector<std::string>{"= 8/2"});
    CHECK(terms("1.0 - z / 2.0")[1] == " − 8/2");
    for (const char* stacked : {"z * (T / d)", "T / (z * d)", "z / n"}) {
      CAPTURE(stacked);
      CHECK(terms(stacked)[0].find("<mfrac>") != std::string::npos);
    }
    CHECK(equation_html(parse("T / d").value()) ==
          std::vector<std::string>{"= <math><mfrac><mi>T</mi><mi>d</mi></mfrac></math>"});
    CHECK(tex(parse("T / d").value(), numbers).find("frac") == std::string::npos);
    CHECK(tex(parse("z / 2.0 + 1.0").value(), numbers) == "8/2 + 1");
  }

  TEST_CASE("a sum is split into terms that begin with their signs") {
    const auto terms = equation_html(parse("a - b * c + d / e").value());
    REQUIRE(terms.size() == 3);
    CHECK(terms[0] == "= 𝑎");
    CHECK(terms[1] == " − 𝑏\u2009𝑐");
    CHECK(terms[2] == "<math><mn>\u00A0+\u00A0</mn><mfrac><mi>d</mi><mi>e</mi></mfrac></math>");
    CHECK(equation_html(parse("a * b").value()).size() == 1);
  }

  TEST_CASE("a value is written with sign, power of ten and upright unit") {
    CHECK(equation_html({"27.35", "mm"}) == "= 27.35\u2009mm");
    CHECK(equation_html({"27.35", "mm³"}) == "= 27.35\u2009mm<sup>3</sup>");
    CHECK(equation_html({"-2", ""}) == "= −2");
    CHECK(equation_html({"1e7", ""}) == "= 10<sup>7</sup>");
    CHECK(quantity_plain({"-1e-9", "m"}) == "−10⁻⁹ m");
    CHECK(equation_html({"1.5e9", "Pa"}) == "= 1.5 ⋅ 10<sup>9</sup>\u2009Pa");
    CHECK(equation_html({"not available", ""}) == "= not available");
    CHECK(quantity_tex({"1.5e9", "mm²"}) == "1.5 \\cdot 10^{9}\\thinspace \\mathrm{mm^{2}}");
    CHECK(quantity_tex({"3", "N·m"}) == "3\\thinspace \\mathrm{N{\\cdot}m}");
    CHECK(quantity_tex({"3", "s⁻¹"}) == "3\\thinspace \\mathrm{s^{-1}}");
  }
}
