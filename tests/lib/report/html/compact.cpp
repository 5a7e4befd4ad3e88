#include "lib/report/html/compact.hpp"

#include "lib/report/html/used_rules.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath::report;

TEST_SUITE("report") {
  TEST_CASE("a compact page has no end tags that the parser supplies") {
    CHECK(compact("<table>\n<thead><tr><th>a</th><th>b</th></tr></thead>\n<tbody>\n<tr><td>1</td><td>2</td></tr>\n"
                  "</tbody></table>") == "<table>\n<thead><tr><th>a<th>b<tbody>\n<tr><td>1<td>2</table>");
    CHECK(compact("<dl><div><dt>a</dt><dd>b</dd></div></dl>") == "<dl><div><dt>a<dd>b</div></dl>");
    CHECK(compact("<ul><li>a</li>\n<li>b</li></ul>") == "<ul><li>a<li>b</ul>");
    CHECK(compact("<div><p>a</p><p>b</p></div>") == "<div><p>a<p>b</div>");
    CHECK(compact("<ul><li><p>a</p></li>\n<li><p>b</p></li>\n</ul>") == "<ul><li><p>a<li><p>b</ul>");
  }

  TEST_CASE("a paragraph before text or inline elements keeps its end tag") {
    CHECK(compact("<p>a</p> b") == "<p>a</p> b");
    CHECK(compact("<p>a</p><span>b</span>") == "<p>a</p><span>b</span>");
    CHECK(compact("<figcaption><p>a</p></figcaption>") == "<figcaption><p>a</p></figcaption>");
  }

  TEST_CASE("values of one word have no quotation marks, others keep them") {
    CHECK(compact("<a class=\"x\" href=\"#y\">") == "<a class=x href=#y>");
    CHECK(compact("<a class=\"x y\" title=\"a=b\" id=\"it's\">") == "<a class=\"x y\" title=\"a=b\" id=\"it's\">");
    CHECK(compact("<use href=\"#shape\"/>") == "<use href=\"#shape\"/>");
    CHECK(compact("<text class=\"\" x=\"1.5\" xmlns=\"http://www.w3.org/2000/svg\">") == "<text x=1.5>");
    CHECK(compact("<img alt=\"\">") == "<img alt=\"\">");
  }

  TEST_CASE("scripts, styles and preformatted text are kept to the byte") {
    for (const char* kept : {"<script>a = \"<td class=\\\"x\\\"></td></tr>\"</script>", "<style>a{b:\"c\"}</style>",
                             "<pre>x </td> \n </td></pre>", "a < b", "<!doctype html>\n"}) {
      CAPTURE(kept);
      CHECK(compact(kept) == kept);
    }
  }

  TEST_CASE("a page has the style rules of its elements and classes only") {
    const std::string page = "<p class=\"a b\"></p>";
    const auto kept = [&](const char* sheet) { return used_rules(sheet, page); };
    CHECK(kept("p{x:1}\n.a{x:1}\n.c{x:1}\n.a.b,.c .a{x:1}\n") == "p{x:1}.a{x:1}.a.b{x:1}\n");
    CHECK(kept("p:not(.c,.d),.a:is(.c,.b){x:1}") == "p:not(.c,.d),.a:is(.c,.b){x:1}");
    CHECK(kept("@media print{\n.c{x:1}\n.b>i{x:1}\n}\n") == "@media print{.b>i{x:1}\n}\n");
    CHECK(kept("@media print{\n.c{x:1}\n}\n") == "@media print{\n}\n");
    CHECK(kept("@page{@top-left{content:\".c{\"}}\n.c{x:url(\"}\")}i{}") == "@page{@top-left{content:\".c{\"}}i{}");
  }
}
