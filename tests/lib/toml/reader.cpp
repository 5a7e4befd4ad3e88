#include "lib/toml/gate.hpp"
#include "lib/toml/tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace loadpath;
using toml::Tree;

namespace {

std::string issues_of(const std::string& text) {
  std::vector<Issue> issues;
  toml::read_toml(text, "a.toml", issues);
  return render(issues, [&](const std::string&) { return text; });
}

Tree tree_of(const std::string& text) {
  std::vector<Issue> issues;
  Tree tree = toml::read_toml(text, "a.toml", issues);
  INFO(issues_of(text));
  REQUIRE(issues.empty());
  return tree;
}

}  // namespace

TEST_SUITE("toml") {
  TEST_CASE("tables and keys keep the order of the file") {
    const Tree tree = tree_of("[z]\nb = 1\na = 2\n[a]\n");
    REQUIRE(tree.entries.size() == 2);
    CHECK(tree.entries[0].key == "z");
    CHECK(tree.entries[0].value.entries[0].key == "b");
    CHECK(tree.entries[1].key == "a");
  }

  TEST_CASE("every kind of value keeps its place; that of a text is inside the quotes") {
    const Tree tree = tree_of("t = \"я\"\nn = -1.5\nb = true\na = [1,  2]\nd = 2026-01-02\n");
    const auto at = [&](const char* key) { return tree.find(key)->value; };
    CHECK(at("t").type == Tree::Type::text);
    CHECK(at("t").place.column == 6);
    CHECK(at("n").number == -1.5);
    CHECK(at("b").text == "true");
    CHECK(at("a").items[1].place.column == 10);
    CHECK(at("d").text == "a date");
  }

  TEST_CASE("a quantity without quotes is reported with how to write it") {
    CHECK(issues_of("[axle]\nT = 900 N*m  # at the gear\n") ==
          R"(a.toml:2:9: error: not valid TOML: expected a comment or whitespace, saw 'N'
2 | T = 900 N*m  # at the gear
  |         ^
  = help: write a quantity in quotes: "900 N*m"
)");
  }

  TEST_CASE("other comment signs, words, names and quotes are reported with the right form") {
    CHECK(issues_of("S = 1.5 ; safety\n").ends_with("help: a comment begins with '#': 1.5 # safety\n"));
    CHECK(issues_of("a = { d = auto }\n").ends_with("help: a value to be found is written \"?\"\n"));
    CHECK(issues_of("l = ?\n").ends_with("help: a value to be found is written in quotes: \"?\"\n"));
    CHECK(issues_of("material = steel\n").ends_with("help: write a text in quotes: \"steel\"\n"));
    CHECK(issues_of("[left\na = 1\n").ends_with("help: write [left]\n"));
    CHECK(issues_of("[Left bearing]\na = 1\n").ends_with("help: write [Left_bearing]\n"));
    CHECK(
        issues_of("T = \"5 N*m\"; d = \"9 mm\"\n").ends_with("help: leave out ';': each key has a line of its own\n"));
    CHECK(issues_of("calculator = shaft.torsion\n").ends_with("help: write a text in quotes: \"shaft.torsion\"\n"));
    CHECK(issues_of("material = \u201CC45E\u201D\n").ends_with("help: these are typographic quotes: write \"C45E\"\n"));
  }

  TEST_CASE("lists and tables in braces are reported with the right form") {
    const auto hint = [](const std::string& lines) {
      const std::string all = issues_of("[a]\nl = [\n" + lines);
      return all.substr(std::min(all.size(), all.find("help: ")));
    };
    const std::string one_line =
        "help: a table in braces is written on one line, { a = 1, b = 2 }; longer ones as [[step.list]] with a line "
        "for "
        "each key\n";
    CHECK(hint("{ a = 1,\n b = 2 },\n]\n") == one_line);
    CHECK(hint("{\n a = 1, b = 2 },\n]\n") == one_line);
    CHECK(hint("{ a = 1, },\n]\n") == "help: remove the comma before '}'\n");
    CHECK(hint("{ a = 1 }\n{ a = 2 },\n]\n") == "help: separate the elements of a list by commas\n");
    CHECK(hint("{ a: 1 },\n]\n") == "help: write '=' between key and value\n");
    CHECK(hint("{ a = 1 },\n\n[b]\n") == "help: a list before this line is not closed: add ']'\n");
  }

  TEST_CASE("a text that is not closed is reported where it would be") {
    CHECK(issues_of("[m]\nmass = \"3 kg\nangle = \"0 deg\"\n") == R"(a.toml:2:13: error: the text is not closed
2 | mass = "3 kg
  |             ^
  = help: add " where it ends
)");
    CHECK(issues_of("a = { b = 'x }") == R"(a.toml:1:15: error: the text is not closed
1 | a = { b = 'x }
  |               ^
  = help: add ' where it ends
)");
    CHECK(issues_of("a = \"x\r\nb = 1\r\n").starts_with("a.toml:1:7: error: the text is not closed\n"));
    CHECK(issues_of("a = \"x\\\"\n").starts_with("a.toml:1:9: error: the text is not closed\n"));
    CHECK(issues_of("a = \"it's\" x # \"\n").starts_with("a.toml:1:12: error: not valid TOML: "));
  }

  TEST_CASE("a Cyrillic key without quotes is reported as needing them") {
    CHECK(issues_of("момент = \"3 N*m\"\n").ends_with("  = help: put a key with non-Latin letters in quotes\n"));
    CHECK(issues_of("I = \"=tables.sections.\"IPE 330\".I_y\"\n")
              .ends_with("  = help: put an expression that contains quotes in single quotes: '=tables.sections.\"IPE "
                         "330\".I_y'\n"));
    CHECK(issues_of("[вал]\n").ends_with("  = help: a name has Latin letters, digits and '_'\n"));
  }

  TEST_CASE("a character outside ASCII is in quotes or in a comment") {
    CHECK(issues_of("# момент\na = 'я' # я\nb = \"\"\"я\\\"\"\" я\"\"\"\nc = \"\\\" я\"\n").empty());
    CHECK(issues_of("\xEF\xBB\xBF"
                    "a = 1\n")
              .empty());
    CHECK(issues_of("T = 900 Н·м\n") ==
          "a.toml:1:9: error: not valid TOML: non-ASCII character outside quotes\n"
          "1 | T = 900 Н·м\n  |         ^\n  = help: write a quantity in quotes: \"900 Н·м\"\n");
    CHECK(issues_of("a = [\"я\", я]\n").starts_with("a.toml:1:11: error: not valid TOML: "));
    CHECK(issues_of("a = 'я\nб = 1\n").starts_with("a.toml:1:7: error: the text is not closed\n"));
    for (const char* fine : {"[a.\"я\".б]\n", "a.\"я\" = 1\n", "a = { b.\"я\" = 1, \"я\" = [1, 'я'] }\n",
                             "a = [\n  \"я\",\n  'я']\n", "a = \"\"\"я\"\"\"\"\"\n\"я\" = 'я'\n"}) {
      const bool is_bare = issues_of(fine).find("outside quotes") != std::string::npos;
      CHECK_MESSAGE(is_bare == (std::string(fine).find(".б") != std::string::npos), fine);
    }
    for (const char* fine : {"\"a\".\"b\" = [{\"c\"=\"\xC3\xA4\"},\"\xC3\xA4\"]\n", "a = '\xC3\xA4' # it's \xC3\xA4\n",
                             "[a.\"b\"]\nc = {'d' = {e.\"f\" = \"\"\"x\"\" \xC3\xA4\"\"\"}, \"g\" = 1}\n"})
      CHECK_MESSAGE(issues_of(fine).empty(), fine);
    // a quote that is glued to a word opens no text
    for (const char* glued : {"a = 0i'\xEF\xBB\xBB\"=n\n", "a = 0=\"\xC9\xA7\n", "a = 0[\"\xC9\xA7\"]\n",
                              "a = 1.'\xEF\xBB\xBB'\n", "a = [1, 2.\"\xEF\xBB\xBB\"]\n", "a'\xEF\xBB\xBB' = 1\n",
                              "a = { b = 1.'\xEF\xBB\xBB' }\n", "a = \"b\"'\xEF\xBB\xBB'\n"}) {
      CHECK_MESSAGE(issues_of(glued).find("non-ASCII character outside quotes") != std::string::npos, glued);
    }
  }

  TEST_CASE("what the parser takes for granted is reported where a text violates it") {
    CHECK(issues_of("[a]\n[.roject]\n") ==
          "a.toml:2:2: error: not valid TOML: expected bare key starting character or string delimiter, saw '.'\n"
          "2 | [.roject]\n  |  ^\n");
    CHECK(issues_of("a = [1, }\n").starts_with("a.toml:1:9: error: not valid TOML: "));
    CHECK(issues_of("a = 1979-05-27TV7:30\n").starts_with("a.toml:1:16: error: not valid TOML: "));
    for (const char* wrong : {"[\n", "[[\r\n", "[[", "[", "[ {a}]\n", "[ [a]]\n", "[[[a]]]\n", "[ # b\n", "[a.=]\n",
                              "a = [\n}]\n", "a = { b = [ } }\n", "a = [[1], # }\n }", "a = 1979-05-2x\n",
                              "a = 1979-05-27 0", "a = 07:3x:01\n", "a = 07:30:01.x\n", "a = 1979-05-27T07:30:01+x\n"})
      CHECK_MESSAGE(issues_of(wrong).find("error: not valid TOML: ") != std::string::npos, wrong);
  }

  TEST_CASE("a duplicate key is refused") {
    CHECK(issues_of("d = 1\nd = 2\n").starts_with("a.toml:2:5: error: 'd' is given twice\n"));
  }

  TEST_CASE("a long line is cut around the caret, and depth has a limit") {
    const std::string said = issues_of("a = " + std::string(5000, '[') + "\n");
    CHECK(said.starts_with("a.toml:1:"));
    CHECK(said.size() < 500);
  }

  TEST_CASE("bytes that are not UTF-8 are reported with their place") {
    CHECK(issues_of("a = \"я\"\nb = \"\xff\"\n").starts_with("a.toml:2:6: error: this byte is not UTF-8\n"));
    for (const char* bytes : {"\x80", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"}) {
      CHECK(issues_of("b = \"" + std::string(bytes) + "\"").starts_with("a.toml:1:6: error: this byte is not UTF-8\n"));
    }
  }

  TEST_CASE("control characters are reported with their code") {
    CHECK(issues_of("a = \"x\x07y\"\n") ==
          "a.toml:1:7: error: control character U+0007\n1 | a = \"x\xEF\xBF\xBDy\"\n  |       ^\n  = help: remove "
          "it; a project is a text file\n");
    CHECK(issues_of("[a\x1b]\n").starts_with("a.toml:1:3: error: control character U+001B\n"));
    CHECK(issues_of("a = \"\xC2\x9B\"\n").starts_with("a.toml:1:6: error: control character U+009B\n"));
    for (const char* escaped :
         {R"(a = "\u001b")", R"("\u001b" = 1)", R"(a = ["\u009b"])", R"(a."\u0000".b = 1)", R"(a = "\r")"})
      CHECK_MESSAGE(issues_of(escaped).find("error: a control character in a text") != std::string::npos, escaped);
    CHECK(issues_of("a = 1 # \x7f\n").starts_with("a.toml:1:9: error: control character U+007F\n"));
    CHECK(issues_of(std::string("a = 1\0b = 2\n", 12)).starts_with("a.toml:1:6: error: control character U+0000\n"));
    CHECK(issues_of("a = 1\t# tab\r\nb = 2\r\n").empty());
  }

  TEST_CASE("a backslash escapes no letter outside ASCII, and may end a line before one") {
    CHECK(issues_of("note = \"one \\\xC3\xA4\"\n") ==
          "a.toml:1:14: error: not valid TOML: a backslash before a letter outside ASCII\n"
          "1 | note = \"one \\\xC3\xA4\"\n  |              ^\n  = help: write a backslash twice\n");
    CHECK(issues_of("note = \"\"\"one \\\xEF\xBA\xBF\"\"\"\n").find("a backslash before a letter outside ASCII") !=
          std::string::npos);
    CHECK_FALSE(issues_of("\n\"\"\"#=\\\t\xC8\xB8\r\"").empty());
    CHECK(issues_of("note = 'C:\\я' # \\я\n").empty());
    CHECK(tree_of("note = \"\"\"one \\\n  two\"\"\"\n").find("note")->value.text == "one two");
    CHECK(tree_of("note = \"\"\"one \\\n  два\"\"\"\n").find("note")->value.text == "one два");
    CHECK(tree_of("note = \"\"\"one \\\\\nдва\"\"\"\n").find("note")->value.text == "one \\\nдва");
  }

  TEST_CASE("letters outside ASCII come back from the parser, with their columns") {
    const Tree tree =
        tree_of("\"ключ\" = { \"б.в\" = \"z0_ля\", z = ['я', '\U0001F529'] } # щ\n[a.'é'] # é\nb = \"ü\"\n");
    CHECK(tree.entries[0].key == "ключ");
    const Tree& inner = tree.entries[0].value;
    CHECK(inner.entries[0].key == "б.в");
    CHECK(inner.entries[0].place.column == 12);
    CHECK(inner.entries[0].value.text == "z0_ля");
    CHECK(inner.entries[0].value.place.column == 21);
    CHECK(inner.entries[0].value.place.length == 5);
    CHECK(inner.entries[1].place.column == 29);
    CHECK(inner.entries[1].value.items[1].text == "\U0001F529");
    CHECK(inner.entries[1].value.items[1].place.column == 40);
    CHECK(tree.find("a")->value.entries[0].key == "é");
    CHECK(tree.find("a")->value.entries[0].value.find("b")->value.text == "ü");
    CHECK(issues_of("'я' = 1\n'я' = 2\n").find("'я'") != std::string::npos);
    CHECK(issues_of("a = [\"яя\", 1 2]\n").starts_with("a.toml:1:14: error: not valid TOML"));
  }

  // where one is glued, what follows may be a text to one and none to the other
  TEST_CASE("texts that a parser would read differently than they look are reported") {
    for (const char* text : {"H=0'{{{{{\"B={{'AA\xEF\xBB\xBD"
                             "BA",
                             "a = b'\nc = \"\xC3\xA4\"\n", "nnz=0nAz={j=\"={j'z=nz=0nzz={j0z\xCB\x8Aj'z=",
                             "a = 0=\"\xC9\xA7\n", "\"\"\"#=\\\t\xC8\xB8\r\""})
      CHECK_MESSAGE(issues_of(text).find(": error: ") != std::string::npos, text);
  }

  TEST_CASE("a file has a maximum size") {
    CHECK(issues_of(std::string(toml::largest_file + 1, '#')) == "a.toml: error: the file is larger than 4 MiB\n");
  }
}
