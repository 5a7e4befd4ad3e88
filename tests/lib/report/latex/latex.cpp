#include "lib/report/latex/letters.hpp"
#include "lib/report/latex/widths.hpp"
#include "tests/lib/report/documents.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <string>

using namespace loadpath;
using namespace loadpath::report;

namespace {

std::string body_of(const Document& document) {
  return between(latex(document), "\\begin{document}", "\\end{document}\n");
}

}  // namespace

TEST_SUITE("report") {
  TEST_CASE("a document reads as LaTeX") {
    CHECK(body_of(shaft_document()) ==
          "\\begin{document}\n"
          "\\thispagestyle{first}\n"
          "\\lptitle{Shaft}\n"
          "\\lpmeta{Project file}{shaft.toml}\n"
          "\\lpmeta{Program}{loadpath 1.0}\n"
          "\n"
          "\\lpconclusion{\\lpstate{lpaccent3}{✓}{PASS}: 1 failure mode: 1 pass. Highest utilisation 0.83: "
          "shaft, yield in torsion.}\n"
          "\n"
          "{\\small\n"
          "\\begin{longtable}{@{}L{0.68\\linewidth}rl@{}}\n"
          "\\toprule\n"
          "failure mode & utilisation & verdict \\\\[1pt]\n"
          "\\midrule\n"
          "\\endhead\n"
          "\\bottomrule\n"
          "\\endfoot\n"
          "\\hyperlink{lp0}{shaft}: yield in torsion\\newline\\lpsmall{u\\_tau} & 0.83 & "
          "\\lpstate{lpaccent3}{✓}{pass} \\\\[1pt]\n"
          "\\end{longtable}}\\lpuncounted\n"
          "\n"
          "\n"
          "\\section{Shaft}\\hypertarget{lp0}{}\n"
          "\n"
          "\n"
          "\\subsection{Calculation}\\hypertarget{lp1}{}\n"
          "\n"
          "\\lpstep{\\tau = \\frac{T}{2\\thinspace W} = \\frac{600\\thinspace \\mathrm{N{\\cdot}m}}{2 \\cdot "
          "24500\\thinspace \\mathrm{mm^{3}}} = 12.24\\thinspace \\mathrm{MPa}}\n"
          "  {\\begin{aligned} \\tau &= \\frac{T}{2\\thinspace W} \\\\ &= \\frac{600\\thinspace "
          "\\mathrm{N{\\cdot}m}}{2 \\cdot 24500\\thinspace \\mathrm{mm^{3}}} = 12.24\\thinspace \\mathrm{MPa} "
          "\\end{aligned}}\n"
          "  {at the surface}\n"
          "\n"
          "\\end{document}\n");
  }

  TEST_CASE("of the letters beyond ASCII those are declared that LaTeX does not know") {
    CHECK(tex::declared_letters("Welle, größer, 30°, 20 µm – “x”") == "");
    CHECK(tex::declared_letters("τ ≤ 3, τ") ==
          "\\DeclareUnicodeCharacter{03C4}{\\ensuremath{\\tau}}\n"
          "\\DeclareUnicodeCharacter{2264}{\\ensuremath{\\le}}\n");
    CHECK(tex::declared_letters("轴🔩") ==
          "\\DeclareUnicodeCharacter{8F74}{\\lpmissing{8F74}}\n"
          "\\DeclareUnicodeCharacter{1F529}{\\lpmissing{1F529}}\n");
    CHECK(tex::declared_letters("Ст3").starts_with("\\IfFileExists{t2aenc.def}{\\usepackage[T2A,T1]{fontenc}}{"));
  }

  TEST_CASE("the paper size is that of the document") {
    Document document = shaft_document();
    CHECK(contains(latex(document), "\n\\documentclass[10pt,a4paper]{article}\n"));
    document.paper = "letter";
    CHECK(contains(latex(document), "\n\\documentclass[10pt,letterpaper]{article}\n"));
  }

  TEST_CASE("columns share a line: numbers are not broken, words are, and what does not fit is set smaller") {
    const tex::Widths all = tex::widths_of({{10.0, 10.0}, {12.0, 40.0}});
    CHECK(all.type == "\\small");
    CHECK(all.shares == std::vector<double>{0.0, 0.0});

    const tex::Widths broken = tex::widths_of({{10.0, 10.0}, {12.0, 300.0}, {12.0, 300.0}});
    CHECK(broken.type == "\\small");
    CHECK(broken.shares[0] == 0.0);
    CHECK(broken.shares[1] == doctest::Approx((105.0 - 3 * 1.6 - 10.0) / 2.0 / 105.0));
    CHECK(broken.shares[2] == doctest::Approx(broken.shares[1]));

    const tex::Widths small = tex::widths_of({{70.0, 70.0}, {60.0, 60.0}});
    CHECK(small.type == "\\scriptsize");
    CHECK(small.shares == std::vector<double>{0.0, 0.0});
  }

  TEST_CASE("the input is in LaTeX as it was typed, and cannot end a block") {
    Document document = shaft_document();
    document.input = "[a]\n\td = \"5 %\"  # \\x\n# \\end{verbatim} {\n";
    CHECK(contains(latex(document),
                   "\\begin{verbatim}\n[a]\n  d = \"5 %\"  # \\x\n\\end{verbatim}\n\\texttt{\\# "
                   "\\textbackslash{}end\\{verbatim\\} \\{}\n\\begin{verbatim}\n\\end{verbatim}\n"));
  }

  TEST_CASE("an entry to be filled in by hand has a line of its own") {
    Document document;
    document.blocks = {
        Table{{}, {say("part"), say("name"), say("signature")}, {{say("checked"), std::string(), std::string()}}}};
    CHECK(contains(latex(document), "part & name & signature \\\\\n\\hline\nchecked &  &  \\\\\n\\hline\n"));
  }

  TEST_CASE("pages are sections before the appendix, whose sections have an A in front") {
    const std::string text = latex(paged_document());
    CHECK(contains(text, "\\lpmeta{Company}{Seiler \\& Co}"));
    CHECK(contains(text, "\\lpmeta{Revision}{not given}"));
    CHECK(contains(text, "\\section*{Chosen sizes}"));
    CHECK(contains(text, "\\textbf{45 mm}*"));
    CHECK(contains(text, "\\section{Input data}"));
    CHECK(text.find("\\section{Input data}") < text.find("\\lpappendix{Appendix}"));
    Document brief = paged_document();
    brief.has_appendix = false;
    CHECK_FALSE(contains(latex(brief), "\\lpappendix{Appendix}"));
  }
}
