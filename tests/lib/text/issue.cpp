#include "lib/text/issue.hpp"

#include <doctest/doctest.h>

using namespace loadpath;

namespace {

std::string shaft_file(const std::string& file) {
  if (file == "shaft.toml") return "[shaft]\nd = \"-50 mm\"\nyield = \"350 mpa\"\n";
  if (file == "cyrillic.toml") return "\"име\" = \"5 кH\"\r\n";
  if (file == "long.toml") return "list = [" + std::string(300, '1') + "X" + std::string(300, '2') + "]";
  if (file == "control.toml") return "a\tb = \"\x1b[31m\"";
  return {};
}

Issue issue(std::string file, int line, int column, int length = 1) {
  return {{std::move(file), line, column, length}, "", say("no good"), {}, Severity::error};
}

}  // namespace

TEST_SUITE("issue") {
  TEST_CASE("arguments take the place of their numbers") {
    CHECK(say("'{1}' is {2}, not {2}", "d", "7").text() == "'d' is 7, not 7");
    CHECK(say("a set {3} {x} {", "a").text() == "a set {3} {x} {");
    CHECK(say("{1}", "{2}").text() == "{2}");
  }

  TEST_CASE("a message may be an argument of another") {
    const Message place = say("at {1}", "30 deg");
    CHECK(say("{1}, the longest of {2} ranges", place, "3").text() == "at 30 deg, the longest of 3 ranges");
    CHECK(say("{1}: {2}", say("{1}; {2}", place, "x"), place).text() == "at 30 deg; x: at 30 deg");
  }

  TEST_CASE("an issue shows the line, the place and the remedy") {
    Issue unknown = issue("shaft.toml", 3, 14, 3);
    unknown.message = say("unknown unit '{1}'", "mpa");
    unknown.hint = say("did you mean '{1}'?", "MPa");
    CHECK(render({unknown}, shaft_file) ==
          "shaft.toml:3:14: error: unknown unit 'mpa'\n"
          "3 | yield = \"350 mpa\"\n"
          "  |              ^^^\n"
          "  = help: did you mean 'MPa'?\n");
  }

  TEST_CASE("all issues are shown in the order of the file") {
    const std::string text =
        render({issue("shaft.toml", 3, 1), issue("shaft.toml", 2, 5), issue("shaft.toml", 2, 1)}, shaft_file);
    const std::size_t first = text.find("2:1:"), second = text.find("2:5:"), third = text.find("3:1:");
    CHECK(first < second);
    CHECK(second < third);
    CHECK(third != std::string::npos);
  }

  TEST_CASE("an issue that is found twice is shown once") {
    CHECK(render({issue("shaft.toml", 2, 1), issue("shaft.toml", 2, 1)}, shaft_file) ==
          render({issue("shaft.toml", 2, 1)}, shaft_file));
  }

  TEST_CASE("the caret counts characters, not bytes") {
    CHECK(render({issue("cyrillic.toml", 1, 12, 2)}, shaft_file) ==
          "cyrillic.toml:1:12: error: no good\n"
          "1 | \"име\" = \"5 кH\"\n"
          "  |            ^^\n");
  }

  TEST_CASE("a long line is cut around the caret") {
    const std::string text = render({issue("long.toml", 1, 309)}, shaft_file);
    const std::size_t line = text.find("1 | "), caret_line = text.find("  | ");
    const std::string_view shown = std::string_view(text).substr(line, caret_line - line - 1);
    CHECK(shown.size() == 104);
    CHECK(shown.substr(4, 3) == "...");
    CHECK(shown.ends_with("..."));
    CHECK(shown[text.find('^') - caret_line] == 'X');
    const std::string wide = render({issue("long.toml", 1, 309, 300)}, shaft_file);
    CHECK(wide.ends_with("^\n"));
    CHECK(wide.size() - wide.rfind("\n  | ") - 2 == 104 - 3);  // none below the dots
  }

  TEST_CASE("characters that would move the cursor are not sent to the terminal") {
    const std::string text = render({issue("control.toml", 1, 1)}, shaft_file);
    CHECK(text.find('\x1b') == std::string::npos);
    CHECK(text.find("a b = \"\uFFFD[31m\"") != std::string::npos);
  }

  TEST_CASE("a file as a whole, an unknown file and a place outside the text are shown without a line") {
    Issue whole = issue("shaft.toml", 0, 0);
    whole.key = "shaft.d";
    whole.severity = Severity::warning;
    CHECK(render({whole}, shaft_file) == "shaft.toml: warning: shaft.d: no good\n");
    CHECK(render({issue("", 0, 0)}, shaft_file) == "error: no good\n");
    CHECK(render({issue("none.toml", 7, 5)}, shaft_file) == "none.toml:7:5: error: no good\n");
    CHECK(render({issue("shaft.toml", 9, 5)}, shaft_file) == "shaft.toml:9:5: error: no good\n");
    CHECK(render({issue("shaft.toml", 1, 500, 500)}, shaft_file) ==
          "shaft.toml:1:500: error: no good\n1 | [shaft]\n  |        ^\n");
  }

  TEST_CASE("the nearest word is found within a third of its letters") {
    const std::vector<std::string> words = {"d_bore", "diameter", "length", "MPa", "mPa", "момент"};
    struct Row {
      std::string_view word, expected;
    };
    const Row rows[] = {{"diamter", "diameter"},
                        {"daimeter", "diameter"},
                        {"DIAMETER", "diameter"},
                        {"lenght", "length"},
                        {"mpa", "mPa"},
                        {"mPa", "mPa"},
                        {"МОМЕН", "момент"},
                        {"radius", ""},
                        {"x", ""},
                        {"", ""},
                        {"d_bor", "d_bore"}};
    for (const Row& row : rows) {
      CAPTURE(row.word);
      CHECK(nearest(row.word, words) == row.expected);
    }
  }
}
