#include "lib/report/conclusion.hpp"
#include "tests/lib/report/documents.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::report;

namespace {

std::string body(const std::vector<Block>& blocks) {
  Document document;
  document.title = "t";
  document.blocks = blocks;
  return between(html(document), "</header>\n", "</main>");
}

}  // namespace

TEST_SUITE("report") {
  TEST_CASE("symbols of running text have subscripts; text typed by the user has none") {
    const auto paragraph = [](const char* text) { return body({Paragraph{say("{1}", text)}}); };
    CHECK(contains(paragraph("K_A 1.25; in σ_adm"), "K<sub>A</sub> 1.25; in σ<sub>adm</sub>"));
    for (const char* typed : {"left_seat", "values.K_A", "m_n.x", "stage_1", "x_"}) {
      CAPTURE(typed);
      CHECK(contains(paragraph(typed), typed));
    }
    CHECK(contains(paragraph("in p_adm,1, 40 MPa"), "in p<sub>adm,1</sub>, 40 MPa"));
    CHECK(contains(paragraph("in v_rim,adm"), "in v<sub>rim,adm</sub>"));
    CHECK(contains(paragraph("F_r,M_b"), "F<sub>r</sub>,M<sub>b</sub>"));
    CHECK(contains(paragraph("s^2/(6 h m_n)"), "s<sup>2</sup>/(6 h m<sub>n</sub>)"));
    CHECK(contains(paragraph("give A = \"5 mm^2\""), "5 mm^2"));
    CHECK(contains(paragraph("gear ratio z_2/z_1"), "z<sub>2</sub>/z<sub>1</sub>"));
    CHECK(contains(paragraph("235 MPa/R_e, 1/c_2"), "235 MPa/R<sub>e</sub>, 1/c<sub>2</sub>"));
    CHECK(contains(paragraph("of sections/I_80"), "of sections/I_80"));
    CHECK(contains(paragraph("give K_A = \"z_1\" & more"), "K<sub>A</sub> = &quot;z_1&quot; &amp; more"));
  }

  TEST_CASE("an expression breaks after the dots of its path") {
    const std::string text = body({Table{{}, {say("a"), say("b")}, {{"x", "= left.bearings.F_r + 0.5"}}}});
    CHECK(contains(text, "= left.<wbr>bearings.<wbr>F_r + 0.5"));
  }

  TEST_CASE("a step is its symbol, formula, numbers, value and reason") {
    CHECK(body({Derivation{{torsion_step()}}}) ==
          "</header>\n"
          "<ul class=\"derivation\">\n"
          "<li><p>𝜏</p>"
          "<p>= <math><mfrac><mi>T</mi>"
          "<mn>2\u2009𝑊</mn></mfrac></math></p>"
          "<p>= <math><mfrac><mn>600\u2009N·m</mn>"
          "<mn><i>2 ⋅ 24500\u2009mm<sup>3</sup></i></mn></mfrac></math></p>"
          "<p>= 12.24\u2009MPa</p>"
          "<p>at the surface</p></li>\n"
          "</ul>\n</main>");
  }

  TEST_CASE("a value without a formula is alone, a missing value is marked as missing") {
    Step step{"d", "", {}, {std::numeric_limits<double>::quiet_NaN(), "mm"}, {}};
    CHECK(contains(body({Derivation{{step}}}), "<li class=\"v n\"><p>𝑑</p><p>= not available</p></li>"));
  }

  TEST_CASE("a few values between formulas are lines of the calculation, more of them a table") {
    Table values{{}, {say("symbol"), say("meaning"), say("value")}, {}};
    values.rows.push_back({loadpath::report::Symbol{"d"}, say("as given"), Quantity{0.03, "mm"}});
    const std::string lines = body({Derivation{{torsion_step()}}, values, Derivation{{torsion_step()}}});
    CHECK(contains(lines, "<li class=\"v\"><p>𝑑</p><p>= 30\u2009mm</p><p>as given</p></li>"));
    CHECK(lines.find("<ul") == lines.rfind("<ul"));
    values.rows.resize(4, values.rows.front());
    CHECK(contains(body({values}), "<table class=\"of-values"));
  }

  TEST_CASE("a formula outside the language is shown as written") {
    Step step = torsion_step();
    step.formula = "a >> b";
    CHECK(contains(body({Derivation{{step}}}), "<code>= a &gt;&gt; b</code>"));
  }

  TEST_CASE("a sum may break between its terms") {
    Step step = torsion_step();
    step.formula = "T + W";
    CHECK(contains(body({Derivation{{step}}}), "= 𝑇<wbr> + 𝑊"));
  }

  TEST_CASE("a formula too wide for its column is on a line of its own, its reason stays in its column") {
    Step step = torsion_step();
    step.why = say("shear stress at the surface of the thinner side");
    CHECK(contains(body({Derivation{{step}}}), "<li><p>"));
    step.formula = "T * W * T * W * T";
    CHECK(contains(body({Derivation{{step}}}), "<li class=\"long\">"));
    step.formula = "(T * T * W + T * T * W + T * T * W) * (T * W + W * T)";
    CHECK(contains(body({Derivation{{step}}}), "<li class=\"long wide"));
  }

  TEST_CASE("a table has its numbers flush right, symbols typeset and a numbered caption") {
    const Table table{
        say("Given"),
        {say("{1}", "tau_t"), say("value"), say("{1}", "from")},
        {{Symbol{"d"}, Quantity{0.05, "mm"}, std::string("a & b")}, {say("x"), Quantity{-1.0, "-"}, State::fail}}};
    CHECK(body({table}) ==
          "</header>\n"
          "<div class=\"table\"><p class=\"caption\"><b>Table 1.</b> Given</p><div class=\"scroll\"><table "
          "class=\"n2\">\n"
          "<thead><tr><th><i>𝜏<sub>𝑡</sub></i></th>"
          "<th>value</th><th>from</th></tr></thead>\n"
          "<tbody>\n"
          "<tr><td><i>𝑑</i></td><td>50 mm</td>"
          "<td>a &amp; b</td></tr>\n"
          "<tr><td>x</td><td>−1</td><td>"
          "<span class=\"state fail\">fail</span></td></tr>\n"
          "</tbody></table></div></div>\n</main>");
  }

  TEST_CASE("a table of many columns is set closer, others are not") {
    Table table{say("Extremes"), {say("what")}, {{say("a sentence that breaks")}}};
    for (int columns = 2; columns <= 9; ++columns) {
      table.head.push_back(say("at"));
      table.rows[0].push_back(Quantity{1.0, "N"});
      CAPTURE(columns);
      CHECK(contains(body({table}), "<table class=\"dense of-numbers\">") == (columns >= 7));
    }
  }

  TEST_CASE("a table of many columns has its units in the head, four digits, and overflow below") {
    Table table{say("sections"), {say("no.")}, {{std::string("left")}, {std::string("right")}}};
    for (int i = 0; i < 32; ++i) {
      table.head.push_back(say("{1}", i < 16 ? "M" : "F"));
      for (auto& row : table.rows) row.push_back(Quantity{1234.56, i < 16 ? "N*m" : "N"});
    }
    const std::string out = body({table});
    CHECK(contains(out, "<br><span class=\"unit\">N·m</span></th>"));
    CHECK(contains(out, "<td>1235</td>"));
    CHECK_FALSE(contains(out, "1235 N"));
    std::size_t parts = 0, names = 0;
    for (std::size_t at = 0; (at = out.find("<table", at)) != std::string::npos; ++at) ++parts;
    for (std::size_t at = 0; (at = out.find("<td>left</td>", at)) != std::string::npos; ++at) ++names;
    CHECK(parts == 2);
    CHECK(names == parts);
    table.rows[1][3] = Quantity{1.0, "kN"};  // two units in a column stay with their numbers
    CHECK(contains(body({table}), "<td>1235 N·m</td>"));
  }

  TEST_CASE("a narrow table is next to the following one, its units in the head") {
    const Table narrow{
        say("pieces"), {say("no."), say("d")}, {{"a", Quantity{0.03, "mm"}}, {"b", Quantity{0.04, "mm"}}}};
    CHECK(contains(body({narrow}), "<div class=\"table half\">"));
    CHECK(contains(body({narrow}), "<span class=\"unit\">mm</span>"));
    Table sentences = narrow;
    sentences.rows[0][0] = say("a sentence that breaks");
    CHECK_FALSE(contains(body({sentences}), "table half"));
  }

  TEST_CASE("headings are numbered, tables and figures count through the page") {
    const Table table{say("a"), {}, {}};
    const figure::Figure figure{"", "moment", figure::Plot{}};
    const std::string out = body({Heading{2, "One", "one"}, Heading{3, "Part", "p"}, table, figure,
                                  Heading{2, "Two", "two"}, Heading{3, "Part", "q"}, table, figure});
    for (const char* part :
         {"<h2 id=\"one\"><span class=\"no\">1</span> One</h2>", "<h3 id=\"p\"><span class=\"no\">1.1</span> Part</h3>",
          "<h2 id=\"two\"><span class=\"no\">2</span> Two</h2>", "<h3 id=\"q\"><span class=\"no\">2.1</span> Part</h3>",
          "<b>Table 2.</b> a", "<figcaption><b>Figure 2.</b> moment</figcaption>"}) {
      CAPTURE(part);
      CHECK(contains(out, part));
    }
  }

  TEST_CASE("the verdict is given in words and by a shape") {
    struct Row {
      State state;
      const char *name, *word;
    };
    for (const Row& row : std::vector<Row>{{State::pass, "pass", "PASS"},
                                           {State::fail, "fail", "FAIL"},
                                           {State::not_covered, "not-covered", "INCOMPLETE"},
                                           {State::not_judged, "not-judged", "INCOMPLETE"},
                                           {State::open, "open", "PASS"},
                                           {State::accepted, "pass", "PASS"},
                                           {State::not_available, "not-available", "INCOMPLETE"}}) {
      Document document = shaft_document();
      document.summary[0].state = row.state;
      const std::string conclusion = between(html(document), "<p class=\"conclusion\">", "</p>");
      CHECK(contains(conclusion, "<span class=\"state " + std::string(row.name) + "\">" + row.word + "</span>"));
      CHECK(contains(html(document), ".state." + std::string(row.name) + "{--m:url("));
    }
  }

  TEST_CASE("the conclusion counts the modes by their state and names the highest utilisation") {
    Document document = shaft_document();
    CHECK(contains(html(document), "1 failure mode: 1 pass. Highest utilisation 0.83: shaft, yield in torsion."));
    document.summary.push_back(mode(1.274, State::fail));
    document.summary.push_back(mode(0.5, State::not_covered));
    CHECK(contains(html(document), "3 failure modes: 1 fail, 1 method not valid, 1 pass. Highest utilisation 1.27"));
    document.summary.clear();
    CHECK_FALSE(contains(html(document), "<p class=\"conclusion\""));
  }

  TEST_CASE("modes that were not considered and that nothing would assess are in one line") {
    Document document = shaft_document();
    account::Mode wear = mode(0.0, State::open);
    wear.kind = ModeKind::special;
    wear.title = say("wear");
    wear.governs.clear();
    document.summary.push_back(wear);
    const std::string page = html(document);
    CHECK(contains(page, "Not considered (applicability not stated): shaft: wear."));
    CHECK_FALSE(contains(page, "wear<br>"));
  }

  TEST_CASE("a mode that another step has assessed is counted there") {
    account::Mode there = mode(0.5, State::pass);
    there.judge = "shaft.key";
    there.governs.clear();
    CHECK(tally({there, mode(0.4, State::pass)}).text() ==
          "1 failure mode: 1 pass; 1 more row: assessed by another step, counted there.");
  }

  TEST_CASE("a utilisation draws a bar that ends at the edge") {
    CHECK(contains(body({Verdicts{{check(0.5, State::pass)}}}), "<span class=\"bar\" style=\"--u:41.7%\">"));
    CHECK(contains(body({Verdicts{{check(7.0, State::fail)}}}), "<span class=\"bar over\" style=\"--u:100%\">"));
    Verdict limit = check(0.0, State::pass);
    limit.utilisation.reset();
    CHECK_FALSE(contains(body({Verdicts{{limit}}}), "class=\"bar\""));
  }

  TEST_CASE("a row of the summary leads to the heading of its step") {
    CHECK(contains(html(shaft_document()), "<td><a href=\"#shaft\">shaft</a>: yield in torsion<br>"));
  }

  TEST_CASE("pages come before the appendix, which is folded on the screen and open for printing") {
    const std::string page = html(paged_document());
    const std::size_t first = page.find("<section class=\"sheet\">"),
                      second = page.find("<section class=\"sheet\">", first + 1),
                      appendix = page.find("<section class=\"appendix\">");
    CHECK(first < second);
    CHECK(second < appendix);
    CHECK(appendix != std::string::npos);
    CHECK(contains(page, "<details><summary><h2 id=\"shaft\"><span class=\"no\">A2</span> Shaft</h2>\n</summary>"));
    CHECK_FALSE(contains(page, "<details open>"));
    const std::string printed = html(paged_document(), Folding::open);
    CHECK(contains(printed, "<details open><summary><h2 id=\"shaft\">"));
    CHECK_FALSE(contains(printed, "<details>"));
  }

  TEST_CASE("a short report ends with its pages") {
    Document document = paged_document();
    document.has_appendix = false;
    const std::string page = html(document);
    CHECK(contains(page, "short report"));
    CHECK_FALSE(contains(page, "class=\"appendix\""));
    CHECK_FALSE(contains(page, "<details"));
  }

  TEST_CASE("the title block has an entry for every field, and room for the signatures") {
    Document document = paged_document();
    const std::string block = between(html(document), "<header class=\"title-block\">", "</header>");
    CHECK(contains(block, "<dt>Company</dt><dd>Seiler &amp; Co</dd>"));
    CHECK(contains(block, "<dt>Revision</dt><dd><span class=\"none\">not given</span></dd>"));
    CHECK(contains(block, "<dt>Date</dt><dd><span class=\"none\">not given</span></dd>"));
    CHECK(contains(block, "<th scope=\"row\">Checked</th><td>Ada</td><td></td>"));
    document.heading.printed = "2026-11-28";
    CHECK(contains(html(document), "<dt>Date</dt><dd>2026-11-28</dd>"));
  }

  TEST_CASE("panels are side by side with their shares, numbered where the page is") {
    const std::string page = html(paged_document());
    CHECK(contains(page, "<div class=\"band\" style=\"grid-template-columns:minmax(0,66fr) minmax(0,105fr)\">"));
    CHECK(contains(page, "<h2>Chosen sizes</h2>"));
    CHECK(contains(page, "<h2><span class=\"no\">1</span> Input data <small>given values</small></h2>"));
    CHECK(contains(page, "<b class=\"sized\">45 mm*</b>"));
    CHECK(contains(page, "0.830<span class=\"bar\""));
  }

  TEST_CASE("no text of the user becomes markup") {
    for (const Document& document : {hostile_document(), hostile_pages()}) {
      const std::string text = html(document);
      CHECK_FALSE(contains(text, "<script>alert"));
      CHECK(text.find("<script") == text.rfind("<script"));  // ours, at the end
      CHECK_FALSE(contains(text, "alert(\""));
    }
    const std::string page = html(hostile_document());
    CHECK(contains(page, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;q&#39;"));
    CHECK_FALSE(contains(page, "</style><"));
    CHECK(contains(page, "content:\"\\3c \\2f title\\3e "));
  }

  TEST_CASE("the page contains its font and needs neither the network nor the clock") {
    const std::string page = html(shaft_document());
    CHECK(contains(page, "@font-face{font-family:\"Loadpath Math\";src:url(data:font/woff2;base64,d09GMk9UVE8A"));
    for (const char* part : {"<script src", "fetch(", "http:", "https:", "<link", "@import", "onload"}) {
      CAPTURE(part);
      CHECK_FALSE(contains(page, part));
    }
    CHECK(page == html(shaft_document()));
  }

  TEST_CASE("rare letters in titles add their font") {
    Document document = shaft_document();
    document.title = "Größe 3 µm · Ø 20, η ≥ 0.9";
    CHECK_FALSE(contains(html(document), "unicode-range"));
    for (const char* title : {"Вал редуктора", "Hřídel", "Café"}) {
      CAPTURE(title);
      document.title = title;
      CHECK(contains(html(document), "unicode-range"));
    }
  }

  TEST_CASE("a moving mechanism has one small script in the page, and its data contain no names") {
    figure::Motion motion;
    motion.still.bodies = {{hostile, {{0.0, 0.0}, {1.0, 0.0}}}};
    motion.links = {{{{{0.0, 0.0}, 0.0}, {{0.0, 0.0}, 0.1}}}};
    motion.forces = {{{{1.0, 0.0}, {1.0, 0.0}}}, {{{-1.0, 0.0}, {-1.0, 0.0}}}};
    motion.plans = {{hostile, {{0, 1.0, hostile}, {1, 1.0, hostile}}}};
    motion.axis = {"phi", hostile, "deg", {0.0, 0.1}};
    motion.numbers = {{hostile, hostile, "N", {1.0, 2.0}}};
    const figure::Figure figure{"turn", "It turns", motion};
    Document document;
    document.blocks = {figure, figure};
    const std::string page = html(document);
    CHECK_FALSE(contains(page, "<script>alert"));
    const std::string scripts = page.substr(page.find("</main>"));
    CHECK(scripts.size() < 8800);
    CHECK(contains(scripts, ".motion"));
    CHECK_FALSE(contains(html(shaft_document()), ".motion\""));
    CHECK_FALSE(contains(between(page, "application/json\">", "</script>"), "alert"));
    CHECK(contains(page, "<div class=\"controls\" hidden>"));
  }
}
