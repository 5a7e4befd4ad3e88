#include "lib/table/lines.hpp"

#include "lib/table/table.hpp"
#include "lib/text/embedded.hpp"
#include "tests/lib/table/tables.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::table;

namespace {

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  REQUIRE(read_line(line, cells));
  return cells;
}

bool reads(std::string_view line) {
  std::vector<Cell> cells;
  return read_line(line, cells);
}

Library read(const std::string& text) {
  std::vector<Issue> issues;
  Library library = with_file({}, text, "table.toml", issues);
  for (const Issue& issue : issues) {  // the citations of the built-in tables are in a file of their own
    CHECK(issue.message.text().find("unknown source") == 0);
  }
  return library;
}

}  // namespace

TEST_SUITE("table lines") {
  TEST_CASE("a line is an array of texts, numbers and arrays of texts") {
    const auto cells = cells_of("  [\"HEA 100\", [\"HE 100 A\", \"a\"], 96, -0.5, 1e-6, \"\"],");
    REQUIRE(cells.size() == 6);
    CHECK(cells[0].text == "HEA 100");
    CHECK(cells[2].number == 96.0);
    CHECK(cells[3].number == -0.5);
    CHECK(cells[4].number == 1e-6);
    CHECK(cells[5].text.empty());
    std::vector<std::string> texts;
    REQUIRE(read_texts(cells[1], texts));
    CHECK(texts == std::vector<std::string>{"HE 100 A", "a"});
    CHECK(cells_of("[1, 2, ]").size() == 2);
    CHECK(cells_of("[]").empty());
  }

  TEST_CASE("any other form is left to the parser") {
    for (const char* line :
         {"",       "1, 2",  "[1, 2",       "[1 2]",          "[1,, 2]",  "[1] # comment", "[\"a]", "[\"a\\\"b\"]",
          "['a']",  "[007]", "[.5]",        "[5.]",           "[1_000]",  "[+1]",          "[inf]", "[nan]",
          "[true]", "[-]",   "[{ a = 1 }]", "[\"\xc3\xa9\"]", "[[\"a\"]", "[1]]"}) {
      CAPTURE(line);
      CHECK_FALSE(reads(line));
    }
  }

  TEST_CASE("rows are extracted only where they are at the top of a file, and places are unchanged") {
    const auto cut = cut_lines("table = \"a\"\nrows = [\n  [1],\n  [2],\n]\n\n[units]\n");
    REQUIRE(cut);
    CHECK(cut->lines == std::vector<std::string_view>{"  [1],", "  [2],"});
    CHECK(cut->rest == "table = \"a\"\n\n\n\n\n\n[units]\n");
    CHECK_FALSE(cut_lines("table = \"a\"\n[defaults]\nrows = [\n  [1],\n]\n"));
    CHECK_FALSE(cut_lines("table = \"a\"\nrows = [[1]]\n"));
    CHECK_FALSE(cut_lines("table = \"a\"\nrows = [\n  [1],\n"));
  }

  TEST_CASE("every built-in table is the same when its lines are read by the parser") {
    std::size_t tables = 0;
    for (const auto& file : embedded::tables()) {
      std::string text(file.text);
      const std::size_t head = text.find("\nrows = [\n");
      if (head == std::string::npos) continue;
      CAPTURE(file.name);
      const Library quick = read(text);
      text.insert(head + 10, " # not of the form that is read quickly\n");
      const Library slow = read(text);
      REQUIRE(quick.tables.size() == 1);
      REQUIRE(quick.tables[0].rows.size() == slow.tables[0].rows.size());
      for (std::size_t i = 0; i < quick.tables[0].rows.size(); ++i) {
        const Row &a = quick.tables[0].rows[i], &b = slow.tables[0].rows[i];
        CHECK(a.name == b.name);
        CHECK(a.aliases == b.aliases);
        CHECK(a.standard == b.standard);
        CHECK(a.kind == b.kind);
        REQUIRE(a.values.size() == b.values.size());
        for (std::size_t k = 0; k < a.values.size(); ++k) {
          CHECK(a.values[k].key == b.values[k].key);
          CHECK(a.values[k].si == b.values[k].si);
          CHECK(a.values[k].sources == b.values[k].sources);
        }
      }
      ++tables;
    }
    CHECK(tables >= 11);
  }
}
