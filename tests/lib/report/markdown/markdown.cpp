#include "lib/draw/svg.hpp"
#include "tests/lib/report/documents.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using namespace loadpath::report;

TEST_SUITE("report") {
  TEST_CASE("a document reads as plain text") {
    CHECK(markdown(shaft_document(), "shaft").text ==
          "# Shaft\n"
          "\n"
          "- Project file: shaft.toml\n"
          "- Program: loadpath 1.0\n"
          "\n"
          "✓ PASS: 1 failure mode: 1 pass. Highest utilisation 0.83: shaft, yield in torsion.\n"
          "\n"
          "| failure mode                   | utilisation | verdict |\n"
          "| :----------------------------- | ----------: | :------ |\n"
          "| shaft: yield in torsion; u_tau |        0.83 | ✓ pass  |\n"
          "\n"
          "## 1 Shaft\n"
          "\n"
          "### 1.1 Calculation\n"
          "\n"
          "at the surface:\n"
          "\n"
          "$$\n"
          "\\begin{aligned}\n"
          "\\tau &= \\frac{T}{2\\thinspace W} \\cr\n"
          "&= \\frac{600\\thinspace \\mathrm{N{\\cdot}m}}{2 \\cdot 24500\\thinspace \\mathrm{mm^{3}}} = "
          "12.24\\thinspace \\mathrm{MPa}\n"
          "\\end{aligned}\n"
          "$$\n"
          "\n");
  }

  TEST_CASE("pages are sections before the appendix") {
    const std::string text = markdown(paged_document(), "x").text;
    CHECK(
        text.starts_with("# Shaft\n\n"
                         "- Company: Seiler \\& Co\n"
                         "- Revision: not given\n"
                         "- Date: not given\n"
                         "- Input: da4e7fac\n"
                         "- Checked: Ada\n\n"
                         "✓ PASS: 1 failure mode assessed.\n\n"
                         "## Chosen sizes\n\n"
                         "| Component | Size        |\n"
                         "| :-------- | :---------- |\n"
                         "| shaft     | **45 mm**\\* |\n\n"
                         "## Governing failure modes\n\n"
                         "| Failure mode | Utilisation |\n"
                         "| :----------- | ----------: |\n"
                         "| yield        |       0.830 |\n\n"
                         "## 1 Input data (given values)\n\nnone\n\n"
                         "# Appendix\n\n"));
    CHECK(contains(text, "## A1 Failure modes\n\n1 failure mode: 1 pass.\n\n"));
    CHECK(contains(text, "## A2 Shaft\n\n### A2.1 Calculation\n\n"));
    Document brief = paged_document();
    brief.has_appendix = false;
    CHECK(text.starts_with(markdown(brief, "x").text));
  }

  TEST_CASE("words are never read as markup") {
    struct Row {
      std::string_view words, written;
    };
    for (const Row& row : std::vector<Row>{{"lever_1.toml, [B19] (2)", "lever_1.toml, [B19] (2)"},
                                           {"_a_ *b* `c` $d$ e|f", "\\_a\\_ \\*b\\* \\`c\\` \\$d\\$ e\\|f"},
                                           {"<b>&amp;", "&lt;b>\\&amp;"},
                                           {"[a](b) [c]: d", "[a]\\(b) [c]\\: d"},
                                           {"# a", "\\# a"},
                                           {"- a", "\\- a"},
                                           {"1. a", "1\\. a"},
                                           {"1.5 mm", "1.5 mm"},
                                           {"a\nb", "a b"}}) {
      Document document;
      document.blocks = {Paragraph{say("{1}", row.words)}};
      CAPTURE(row.words);
      CHECK(contains(markdown(document, "x").text, "\n\n" + std::string(row.written) + "\n\n"));
    }
  }

  TEST_CASE("a table without headings is still a table") {
    Document document;
    document.title = "t";
    document.blocks = {Table{{}, {}, {{std::string("a"), Quantity{0.001, "mm"}}, {std::string("long")}}}};
    CHECK(markdown(document, "x").text ==
          "# t\n\n"
          "|      |      |\n"
          "| :--- | ---: |\n"
          "| a    | 1 mm |\n"
          "| long |      |\n\n");
  }

  TEST_CASE("figures are files next to the text, numbered so that their names differ") {
    Document document;
    const figure::Figure figure{"moment", "Drive moment", figure::Plot{}};
    document.blocks = {figure, figure};
    const Markdown out = markdown(document, "my report");
    REQUIRE(out.figures.size() == 2);
    CHECK(out.figures[0].first == "my report-1-moment.svg");
    CHECK(out.figures[1].first == "my report-2-moment.svg");
    CHECK(out.figures[0].second == draw::svg(figure));
    CHECK(contains(out.text, "![Drive moment](my%20report-1-moment.svg)\n\n**Figure 1.** Drive moment\n"));
  }

  TEST_CASE("no text of the user becomes markup; a formula outside the language is code") {
    std::string text = markdown(hostile_document(), "x").text;
    const std::string formula = "`` " + std::string(hostile) + " ``\n";
    const std::size_t at = text.find(formula);
    REQUIRE(at != std::string::npos);
    CHECK_FALSE(contains(text.erase(at, formula.size()), "<script"));
  }
}
