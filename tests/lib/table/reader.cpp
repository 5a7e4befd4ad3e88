#include "lib/table/library.hpp"
#include "tests/lib/table/tables.hpp"

using namespace loadpath;
using namespace loadpath::table;

namespace {

const std::string head = R"(table = "mine/steels"
group = "material"
units = { E = "GPa", R_e = "ksi", size_max = "in" }
)";

std::vector<Issue> issues_of(const std::string& text) {
  std::vector<Issue> issues;
  with_file(built_in(), text, "mine.toml", issues);
  return issues;
}

/// The one issue of a text, as "line:column: message | hint".
std::string issue_of(const std::string& text) {
  const auto issues = issues_of(text);
  REQUIRE(issues.size() == 1);
  const Issue& issue = issues[0];
  CHECK(issue.place.file == "mine.toml");
  const std::string place = std::to_string(issue.place.line) + ":" + std::to_string(issue.place.column) + ": ";
  return place + issue.message.text() + (issue.hint.empty() ? "" : " | " + issue.hint.text());
}

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("a row replaces an earlier one of the same name, in its own units") {
    std::vector<Issue> issues;
    const Library mine = with_file(built_in(), head + R"([[row]]
name = "C45E"
E = 205
by_size = [{ size_max = 2, R_e = 60 }]
sources = ["certificate"]
[sources]
certificate = "Mill certificate 4711 of 2026-03-02"
)",
                                   "mine.toml", issues);
    CHECK(issues.empty());
    const auto entry = find_row(mine, "material", "c45e");
    REQUIRE(entry);
    CHECK(value_of(*entry, "E") == 205e9);
    CHECK(value_of(*entry, "R_e", 50.8 * mm) == doctest::Approx(413.6854e6).epsilon(1e-6));
    CHECK(covered_size(*entry, "R_e") == 0.0508);
    CHECK(property(*entry, "E")->sources == std::vector<std::string>{"certificate"});
    CHECK(value_of(*find_row(mine, "material", "S235"), "E") == 210e9);
    CHECK(value_of(material("C45E"), "E") == 210e9);
  }

  TEST_CASE("a file may replace rows inside a built-in table") {
    std::vector<Issue> issues;
    const Library mine = with_file(built_in(), R"(table = "materials/titanium"
group = "material"
units = { E = "GPa" }
[[row]]
name = "Ti-6Al-4V"
E = 114
recalled = true
)",
                                   "mine.toml", issues);
    CHECK(issues.empty());
    CHECK(mine.tables.size() == built_in().tables.size());
    CHECK(property(*find_row(mine, "material", "Ti-6Al-4V"), "E")->recalled);
  }

  TEST_CASE("a file may bring a series of its own") {
    std::vector<Issue> issues;
    const Library mine = with_file(built_in(), R"(table = "mine/bars"
unit = "in"
[[series]]
name = "stock"
sizes = [0.5, 0.75, 1]
recalled = true
)",
                                   "mine.toml", issues);
    CHECK(issues.empty());
    CHECK(members_in_si(**find_series(mine, "stock")) == std::vector<double>{0.0127, 0.01905, 0.0254});
  }

  TEST_CASE("a row takes from the file's defaults what it does not state itself") {
    std::vector<Issue> issues;
    const Library mine = with_file(built_in(), R"(table = "mine"
group = "material"
units = { E = "GPa", nu = "-", R_m = "MPa" }
[defaults]
kind = "steel"
E = 210
nu = 0.3
sources = ["Mott"]
recalled = ["nu"]
[[row]]
name = "A"
R_m = 500
[[row]]
name = "B"
kind = "bronze"
nu = 0.35
)",
                                   "mine.toml", issues);
    CHECK(issues.empty());
    const Entry a = *find_row(mine, "material", "A"), b = *find_row(mine, "material", "B");
    CHECK(a.row->kind == "steel");
    CHECK(b.row->kind == "bronze");
    CHECK(value_of(a, "E") == 210e9);
    CHECK(property(a, "R_m")->sources == std::vector<std::string>{"Mott"});
    CHECK(property(a, "nu")->recalled);
    CHECK(value_of(b, "nu") == 0.35);
    CHECK(property(b, "nu")->sources == std::vector<std::string>{"Mott"});
  }

  TEST_CASE("a wrong row is refused at its place") {
    struct Case {
      std::string row;
      const char* issue;
    };
    const std::string row = head + "[[row]]\nname = \"A\"\n";
    const Case cases[] = {
        {"E = 205\n",
         "6:1: E of 'A' has no source | name it in 'sources' or 'cite', or in 'recalled' where none was seen"},
        {"E = \"205 GPa\"\nrecalled = true\n", "6:6: E must be a number | it is read in GPa, as given in 'units'"},
        {"Re = 5\nrecalled = true\n", "6:1: 'Re' has no unit in 'units' | did you mean 'R_e'?"},
        {"E = 205\nsources = [\"Lucefin-C54E\"]\n",
         "7:13: unknown source 'Lucefin-C54E' | did you mean 'Lucefin-C45E'?"},
        {"E = 205\nsources = [\"book\"]\n", "7:13: unknown source 'book' | name it in [sources]"},
        {"E = 205\nrecalled = [\"E\", \"G\"]\n", "4:1: 'A' has no value of G"},
        {"by_size = [{ size_max = 2, R_e = 60 }, { size_max = 2, R_e = 50 }]\nrecalled = true\n",
         "6:40: sizes must be positive and ascending"},
        {"E = 205\nrecalled = true\n[[row]]\nname = \"A\"\nE = 206\nrecalled = true\n", "8:1: there are two rows 'A'"},
        {"E = 205\nrecalled = true\n[[row]]\nE = 206\nrecalled = true\n", "8:1: 'name' is missing"},
        {"standard = 7\nE = 205\nrecalled = true\n", "6:12: 'standard' must be a text"},
    };
    for (const Case& c : cases) CHECK(issue_of(row + c.row) == c.issue);
  }

  TEST_CASE("a wrong head is refused at its place") {
    CHECK(issue_of("table = \"a\"\ngroup = \"b\"\ntitel = \"c\"\n") ==
          "3:1: unknown key 'titel' | did you mean 'title'?");
    CHECK(issue_of("table = \"a\"\ngroup = \"b\"\nunits = { E = \"GPA\" }\nrow = []\n").substr(0, 6) == "3:16: ");
    CHECK(issue_of("table = \"materials/titanium\"\ngroup = \"material\"\nunits = { E = \"mm\" }\nrow = []\n") ==
          "3:16: E of 'materials/titanium' is a stress, not a length");
    CHECK(issue_of("table = \"a\"\nunits = {}\nrow = []\n") == "1:1: 'group' is missing");
  }

  TEST_CASE("a wrong series is refused at its place") {
    const std::string series = "table = \"a\"\nunit = \"mm\"\n[[series]]\nname = \"s\"\n";
    CHECK(issue_of(series + "sizes = [1, 3, 2]\nrecalled = true\n") == "5:9: sizes must be positive and ascending");
    CHECK(issue_of(series + "decade = [1, 2, 5]\nrecalled = true\n") ==
          "3:1: a decade needs its range: within = [0.1, 1000]");
    CHECK(issue_of(series + "sizes = [1, 2]\n") ==
          "3:1: 's' has no source | name it in 'sources', or write recalled = true where none was seen");
    CHECK(issue_of(series + "recalled = true\n") == "3:1: give 'sizes', or a 'decade' and the range 'within'");
    CHECK(issue_of(series + "sizes = [\"1\"]\nrecalled = true\n") == "5:11: 's.sizes' must be an array of numbers");
  }

  TEST_CASE("every wrong row is reported, not only the first") {
    const auto issues = issues_of(head + "[[row]]\nname = \"A\"\nE = 1\n[[row]]\nname = \"B\"\nE = 2\nG = 3\n");
    CHECK(issues.size() == 3);
  }
}
