#include "lib/table/rows.hpp"

#include "lib/table/library.hpp"
#include "tests/lib/table/tables.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::table;

namespace {

struct Bar {
  [[maybe_unused]] static constexpr auto group = "bar";
  Length d = unset<Length>;
  Area A = unset<Area>;
  double price = unset<double>;
  static constexpr Fields fields{Field{&Bar::d, "d", loadpath::mm, "diameter"}, Field{&Bar::A, "A", mm2, "area"},
                                 Field{&Bar::price, "price", ratio, "price"}};
};

struct Steel {
  static constexpr auto group = "material";
  Stress E = unset<Stress>;
  static constexpr Fields fields{Field{&Steel::E, "E", GPa, "modulus of elasticity"}};
};

const std::string head = "group = \"bar\"\nunits = { d = \"mm\", A = \"cm^2\", price = \"-\" }\n";
const std::string lines = "table = \"bars/a\"\n" + head + R"(columns = ["name", "kind", "d", "A", "price"]
rows = [
  ["B1", "bright", 10, 0.785, 3],
  ["B2", "bright", 20, 3.14, ""],
]
[defaults]
sources = ["list"]
[sources]
list = "Price list"
)";

Library read(const std::string& text, std::vector<Issue>& issues, Library base = {}) {
  return with_file(std::move(base), text, "bars.toml", issues);
}

std::vector<const Table*> all_of(const Library& library) {
  std::vector<const Table*> tables;
  for (const Table& table : library.tables) tables.push_back(&table);
  return tables;
}

std::string first_of(const std::string& text) {
  std::vector<Issue> issues;
  read(text, issues);
  return issues.empty() ? "" : issues[0].message.text();
}

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("rows that are written as lines are read like any others, in order, and missing values stay unset") {
    std::vector<Issue> issues;
    const Library library = read(lines, issues);
    REQUIRE(issues.empty());
    const auto bars = typed_rows<Bar>(all_of(library));
    REQUIRE(bars.size() == 2);
    CHECK(bars[0].name() == "B1");
    CHECK(bars[0].kind() == "bright");
    CHECK(in_si(bars[0].d) == 0.01);
    CHECK(in_si(bars[1].A) == doctest::Approx(3.14e-4).epsilon(1e-15));
    CHECK(bars[0].price == 3.0);
    CHECK_FALSE(is_set(bars[1].price));
    CHECK(property(bars[1].entry, "A")->sources == std::vector<std::string>{"list"});
  }

  TEST_CASE("a row of a later table replaces those of its name") {
    std::vector<Issue> issues;
    Library library = read(lines, issues);
    library = read("table = \"mine/bars\"\n" + head + "[[row]]\nname = \"B1\"\nd = 11\nrecalled = true\n", issues,
                   std::move(library));
    REQUIRE(issues.empty());
    const auto bars = typed_rows<Bar>(all_of(library));
    REQUIRE(bars.size() == 2);
    CHECK(bars[0].name() == "B2");
    CHECK(in_si(bars[1].d) == 0.011);
  }

  TEST_CASE("a line of another length, lines without columns, and a key of two meanings are refused") {
    CHECK(first_of("table = \"a\"\n" + head + "columns = [\"name\", \"d\"]\nrows = [[\"B1\"]]\n") ==
          "a line of 'rows' is an array of 2 values, as listed in 'columns'");
    CHECK(first_of("table = \"a\"\n" + head + "rows = [[\"B1\"]]\n") == "'columns' is missing");
    std::vector<Issue> issues;
    Library library = read(lines, issues);
    read("table = \"b\"\ngroup = \"bar\"\nunits = { d = \"kg\" }\n[[row]]\nname = \"B\"\nd = 1\nrecalled = true\n",
         issues, std::move(library));
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].message.text() == "d of 'b' is a length, not a mass");
  }

  TEST_CASE("the rows of a group in use are read once, and completely") {
    const auto& steels = rows_of<Steel>();
    CHECK(&steels == &rows_of<Steel>());
    std::size_t all = 0;
    for (const Table& table : built_in().tables) all += table.group == "material" ? table.rows.size() : 0;
    CHECK(steels.size() == all);
    for (const auto& steel : steels) {
      CAPTURE(steel.name());
      CHECK(in_si(steel.E) == property(steel.entry, "E")->si);
    }
  }
}
