#include "lib/table/search.hpp"

#include "lib/table/library.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::table;

namespace {

std::vector<const Table*> sections() { return tables_in("sections"); }

std::vector<std::string> names(const std::string& where, const std::string& sort) {
  const auto tables = sections();
  const auto condition = read_condition(where, tables);
  const auto order = read_order(sort, tables);
  REQUIRE(condition);
  REQUIRE(order);
  std::vector<std::string> found;
  for (const Entry& entry : search(tables, *condition, *order)) found.push_back(entry.row->name);
  return found;
}

Fault fault(const std::string& where) {
  const auto read = read_condition(where, sections());
  REQUIRE_FALSE(read);
  return read.fault();
}

}  // namespace

TEST_SUITE("table search") {
  TEST_CASE("the lightest section with a minimum second moment comes first, in descending order the heaviest") {
    const auto found = names("I_min >= 300 cm^4", "mass");
    REQUIRE(found.size() > 100);
    const auto mass = [](const std::string& name) { return searched_value(*(*find_row("section", name)).row, "m"); };
    for (std::size_t i = 1; i < found.size(); ++i) CHECK(mass(found[i - 1]) <= mass(found[i]));
    CHECK(searched_value(*(*find_row("section", found[0])).row, "I_min") >= 300e-8);
    const auto falling = names("I_min >= 300 cm^4", "-m");
    CHECK(mass(falling.front()) >= mass(found.back()));
  }

  TEST_CASE("several conditions apply together, whatever the unit") {
    CHECK(names("h = 200 mm and b = 100 mm and t_f = 8.5 mm", "") == std::vector<std::string>{"IPE 200"});
    CHECK(names("h = 20 cm and b = 0.1 m and t_f < 9 mm and t_f > 8.4 mm", "") == std::vector<std::string>{"IPE 200"});
    CHECK(names("h >= 200 mm and h < 200 mm", "").empty());
    CHECK(names("h != 200 mm and h >= 200 mm and h <= 200 mm", "").empty());
  }

  TEST_CASE("a row without the value does not match") {
    for (const std::string& name : names("e_z >= 0 mm", "")) {
      CAPTURE(name);
      CHECK((name.starts_with("U") || name.starts_with("L") || name.starts_with("C") || name.starts_with("MC")));
    }
  }

  TEST_CASE("a condition that cannot be read is reported with its place") {
    CHECK(fault("I_mni >= 300 cm^4").message.text() == "unknown column 'I_mni' in these tables");
    CHECK(fault("I_mni >= 300 cm^4").hint.text() == "did you mean 'I_min'?");
    CHECK(fault("h > 1 mm and bb > 2 mm").at == 13);
    CHECK(fault("h > 30").message.text().find("30") != std::string::npos);
    CHECK(fault("h > 30 kg").at == 4);
    CHECK(fault("h >").message.text() == "a value is missing after '>'");
    CHECK(fault("h > 30").hint.text() == "write '30 mm'");  // metric, though tables in inches come first
    CHECK(fault("h => 30 mm").message.text() == "unknown sign '=>'");
    CHECK(fault("h => 30 mm").hint.text() == "write >=");
    CHECK(fault("h == 30 mm").hint.text() == "write =");
    CHECK(fault("h").message.text() == "'h' compares nothing");
    CHECK(fault("").message.text() == "'' compares nothing");
    CHECK(fault("h > 1 mm and ").message.text() == "'' compares nothing");
    CHECK_FALSE(read_order("-mas", sections()));
  }

  TEST_CASE("materials are searched by their strength at the smallest size") {
    const auto tables = tables_in("materials");
    const auto condition = read_condition("R_e >= 480 MPa and R_e <= 490 MPa", tables);
    REQUIRE(condition);
    bool found = false;
    for (const Entry& entry : search(tables, *condition, {})) found = found || entry.row->name == "C45E";
    CHECK(found);
  }
}
