// Every page of every example, as a browser lays it out.
#include "tests/browser/examples.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

using namespace loadpath::test;

namespace {

/// What overflows its column: of the page where it is wider than the window, of a box that cannot be scrolled.
const std::string beyond = R"((() => {
  const said = [];
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) said.push(`page ${document.documentElement.scrollWidth} > ${width}`);
  const scrolls = (e) => {
    for (; e && e !== document.body; e = e.parentElement) if (/auto|scroll/.test(getComputedStyle(e).overflowX)) return true;
    return false;
  };
  for (const e of document.querySelectorAll("main *")) {
    if (e.closest("svg") && e.tagName !== "svg") continue;
    const box = e.getBoundingClientRect();
    if (box.width === 0 || box.right <= width + 0.5 || scrolls(e)) continue;
    said.push(`${e.tagName}.${e.className} ends at ${Math.round(box.right)}: ${e.textContent.slice(0, 40)}`);
  }
  return said.slice(0, 5).join("\n");
})())";

const std::string broken_links = R"((() => {
  const said = [], ids = new Set();
  for (const e of document.querySelectorAll("[id]")) {
    if (ids.has(e.id)) said.push("twice: " + e.id);
    ids.add(e.id);
  }
  for (const a of document.querySelectorAll("a[href^='#']"))
    if (!ids.has(decodeURIComponent(a.getAttribute("href").slice(1)))) said.push("nowhere: " + a.getAttribute("href"));
  for (const u of document.querySelectorAll("use"))
    if (!ids.has(u.getAttribute("href").slice(1))) said.push("no shape: " + u.getAttribute("href"));
  return said.slice(0, 5).join("\n");
})())";

/// Text in figures that lies over other text of the same figure, or out of it.
const std::string covered_text = R"((() => {
  const said = [];
  for (const svg of document.querySelectorAll("figure svg")) {
    const frame = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll("text")].filter((t) => t.textContent.trim() && getComputedStyle(t).visibility !== "hidden");
    const boxes = texts.map((t) => t.getBoundingClientRect());
    boxes.forEach((a, i) => {
      if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 4 || a.bottom > frame.bottom + 4)
        said.push(`out of the figure: ${texts[i].textContent}`);
      for (let k = i + 1; k < boxes.length; ++k) {
        const b = boxes[k];
        const w = Math.min(a.right, b.right) - Math.max(a.left, b.left), h = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (w > 2 && h > 0.35 * Math.min(a.height, b.height)) said.push(`over each other: ${texts[i].textContent} | ${texts[k].textContent}`);
      }
    });
  }
  return said.slice(0, 8).join("\n");
})())";

/// Reasons next to a formula, letter below letter: half of a word wide.
const std::string squeezed = R"((() => {
  const said = [];
  for (const p of document.querySelectorAll("main p")) {
    const box = p.getBoundingClientRect(), letter = parseFloat(getComputedStyle(p).fontSize);
    const is_broken = box.width < 4 * letter && box.height > 3 * letter;
    if (box.width > 0 && is_broken && p.textContent.length > 8) said.push(p.textContent.slice(0, 40));
  }
  return said.slice(0, 5).join("\n");
})())";

/// Opens the sections of the appendix.
const std::string unfold =
    "(document.querySelectorAll('details').forEach((d) => { d.open = true; }), "
    "document.querySelectorAll('details:not([open])').length + '')";

/// Formulas below 8 points, other text of the page below 6.4, besides subscripts.
const std::string small_text = R"((() => {
  const said = [];
  const tell = (e, least) => {
    const size = parseFloat(getComputedStyle(e).fontSize) * 0.75;
    if (size < least && e.getBoundingClientRect().width > 0) said.push(`${size.toFixed(1)} pt: ${e.textContent.slice(0, 30)}`);
  };
  for (const m of document.querySelectorAll("math, .step > * > i")) tell(m, 7.9);
  for (const e of document.querySelectorAll("main p, main td, main th, main dd, main dt, main h2, main h3, figcaption")) tell(e, 6.4);
  return said.slice(0, 3).join("\n");
})())";

/// Notes next to formulas are left-aligned.
const std::string ragged = R"((() => {
  const lefts = new Set([...document.querySelectorAll(".step .why")].map((e) => Math.round(e.getBoundingClientRect().left)));
  return lefts.size > 1 ? [...lefts].join(", ") : "";
})())";

}  // namespace

TEST_SUITE("pages in a browser" * takes_share) {
  TEST_CASE("nothing overflows the page, overlaps other text or breaks letter by letter, and every link has a target") {
    if (browser_there().empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    Browser browser;
    std::size_t at = 0;
    for (const std::string& name : examples()) {
      if (!is_tried(at++, 3)) continue;
      CAPTURE(name);
      if (!write_report(desk, name, "r.html")) continue;
      for (const int width : {1280, 768, 390}) {
        CAPTURE(width);
        browser.look(width, 900);
        browser.open(address_of(desk, "r.html"));
        CHECK(text_of(browser, beyond) == "");
        CHECK(text_of(browser, unfold) == "0");
        CHECK(text_of(browser, beyond) == "");
        CHECK(text_of(browser, squeezed) == "");
        if (width == 1280) {
          CHECK(text_of(browser, broken_links) == "");
          CHECK(text_of(browser, covered_text) == "");
        }
      }
      browser.look_as_print(662);  // A4 between margins of 20 and 15 mm
      CHECK(text_of(browser, beyond) == "");
      CHECK(text_of(browser, squeezed) == "");
      CHECK(text_of(browser, small_text) == "");
      CHECK(text_of(browser, ragged) == "");
    }
  }

  TEST_CASE("the appendix is folded, and a link into it opens the section that it leads to") {
    if (browser_there().empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    Browser browser;
    REQUIRE(write_report(desk, "line-shaft", "r.html"));
    const std::string open = "document.getElementById('line_shaft').closest('details').open + ''";
    browser.look(1280, 900);
    browser.open(address_of(desk, "r.html"));
    CHECK(text_of(browser, open) == "false");
    CHECK(text_of(browser, "document.querySelector('a[href=\"#line_shaft\"]') === null ? 'none' : 'link'") == "link");
    CHECK(text_of(browser, "(location.hash = 'line_shaft', '')") == "");
    browser.open(address_of(desk, "r.html") + "#line_shaft");
    CHECK(text_of(browser, open) == "true");
  }
}
