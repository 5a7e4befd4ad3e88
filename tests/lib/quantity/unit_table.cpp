#include "lib/quantity/unit_table.hpp"

#include "lib/quantity/literal.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string_view>

using namespace loadpath;

TEST_SUITE("quantity") {
  TEST_CASE("every unit parses with every prefix that it takes") {
    for (const UnitName& name : all_unit_names(false)) {
      CAPTURE(name.text);
      const Outcome<UnitValue> unit = parse_unit(name.text);
      REQUIRE(unit);
      CHECK(unit->dimension == name.row->dimension);
      CHECK(unit->offset == name.row->offset);
      const double power_of_ten = std::log10(unit->factor / name.row->factor);
      CHECK(std::fabs(power_of_ten - (name.ten + name.row->ten)) <= 1e-12);
    }
  }

  TEST_CASE("no two units, prefixed or not, share a name") {
    std::map<std::string, const UnitRow*> seen;
    for (const UnitName& name : all_unit_names(false)) {
      CAPTURE(name.text);
      CHECK(seen.emplace(name.text, name.row).second);
    }
    CHECK(seen.size() > 500);
  }

  TEST_CASE("a prefix joins names of its own script only") {
    for (const auto* name : {"кN", "kН", "kнewton", "kilonewton", "kilo", "kiloN", "knewton", "кньютон"}) {
      CAPTURE(name);
      CHECK((find_unit(name).row != nullptr) == (std::string_view(name) == "kilonewton"));
    }
  }

  TEST_CASE("words have a plural, symbols have none") {
    CHECK(find_unit("newtons").row == find_unit("N").row);
    CHECK(find_unit("kilometers").row == find_unit("m").row);
    CHECK(find_unit("lbs").row == nullptr);
    CHECK(find_unit("bars").row == nullptr);
  }
}
