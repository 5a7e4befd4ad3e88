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

  TEST_CASE("MathML has fractions, roots, powers, products") {
    for (const Row& row :
         std::vector<Row>{{"a / b", "<mfrac><mi>a</mi><mi>b</mi></mfrac>"},
                          {"2.0 * W", "<mn>2</mn><mspace width=\"0.17em\"/><mi>W</mi>"},
                          {"a * 2.0", "<mi>a</mi><mo>⋅</mo><mn>2</mn>"},
                          {"pow<2>(tau_t)", "<msubsup><mi>τ</mi><mi>t</mi><mn>2</mn></msubsup>"},
                          {"tau_t * tau_t", "<msubsup><mi>τ</mi><mi>t</mi><mn>2</mn></msubsup>"},
                          {"sqrt(a)", "<msqrt><mi>a</mi></msqrt>"},
                          {"cbrt(-a)", "<mroot><mrow><mo form=\"prefix\">−</mo><mi>a</mi></mrow><mn>3</mn></mroot>"},
                          {"sin(a)",
                           "<mi>sin</mi><mo>\u2061</mo><mrow><mn>(</mn><mi>a</mi>"
                           "<mn>)</mn></mrow>"},
                          {"exp(a)", "<msup><mi mathvariant=\"normal\">e</mi><mi>a</mi></msup>"},
                          {"d / mm", "<mfrac><mi>d</mi><mi>mm</mi></mfrac>"},
                          {"a < b", "<mi>a</mi><mo>&lt;</mo><mi>b</mi>"},
                          {"pi", "<mi mathvariant=\"normal\">π</mi>"}}) {
      CAPTURE(row.cpp);
      CHECK(mathml(parse(row.cpp).value()) == row.print);
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
    CHECK(mathml(tree) == "<mfrac><mi>F</mi><mi>N</mi></mfrac>");
    const auto known = [](std::string_view name) { return name == "F" ? std::optional(5.0) : std::nullopt; };
    CHECK(mathml(tree, {}, known) == "<mfrac><mi>F</mi><mi mathvariant=\"normal\">N</mi></mfrac>");
  }

  TEST_CASE("a ratio of two values has a solidus where it is a term, and a bar in a product") {
    const auto terms = [](std::string_view cpp) { return mathml_terms(parse(cpp).value(), numbers); };
    CHECK(terms("T / d") == std::vector<std::string>{"<mn>(600\u2009N·m)</mn><mn>/</mn><mn>(50\u2009mm)</mn>"});
    CHECK(terms("z / 2.0") == std::vector<std::string>{"<mn>8</mn><mn>/</mn><mn>2</mn>"});
    CHECK(terms("1.0 - z / 2.0")[1] == "<mo form=\"infix\">−</mo><mn>8</mn><mn>/</mn><mn>2</mn>");
    for (const char* stacked : {"z * (T / d)", "T / (z * d)", "z / n"}) {
      CAPTURE(stacked);
      CHECK(terms(stacked)[0].find("<mfrac>") != std::string::npos);
    }
    CHECK(mathml_terms(parse("T / d").value()) == std::vector<std::string>{"<mfrac><mi>T</mi><mi>d</mi></mfrac>"});
    CHECK(tex(parse("T / d").value(), numbers).find("frac") == std::string::npos);
    CHECK(tex(parse("z / 2.0 + 1.0").value(), numbers) == "8/2 + 1");
  }

  TEST_CASE("a sum is split into terms that begin with their signs") {
    const auto terms = mathml_terms(parse("a - b * c + d").value());
    REQUIRE(terms.size() == 3);
    CHECK(terms[0] == "<mi>a</mi>");
    CHECK(terms[1] == "<mo form=\"infix\">−</mo><mi>b</mi><mspace width=\"0.17em\"/><mi>c</mi>");
    CHECK(terms[2] == "<mo form=\"infix\">+</mo><mi>d</mi>");
    CHECK(mathml_terms(parse("a * b").value()).size() == 1);
  }

  TEST_CASE("a value is written with sign, power of ten and upright unit") {
    CHECK(quantity_mathml({"27.35", "mm"}) == "<mn>27.35\u2009mm</mn>");
    CHECK(quantity_mathml({"27.35", "mm³"}) ==
          "<mn>27.35</mn><mspace width=\"0.2em\"/><msup><mi>mm</mi><mn>3</mn></msup>");
    CHECK(quantity_mathml({"-2", ""}) == "<mo form=\"prefix\">−</mo><mn>2</mn>");
    CHECK(quantity_mathml({"not available", ""}) == "<mtext>not available</mtext>");
    CHECK(quantity_tex({"1.5e9", "mm²"}) == "1.5 \\cdot 10^{9}\\thinspace \\mathrm{mm^{2}}");
    CHECK(quantity_tex({"3", "N·m"}) == "3\\thinspace \\mathrm{N{\\cdot}m}");
    CHECK(quantity_tex({"3", "s⁻¹"}) == "3\\thinspace \\mathrm{s^{-1}}");
  }
}
