#include "lib/table/library.hpp"
#include "tests/lib/table/tables.hpp"

#include <map>
#include <utility>

using namespace loadpath;
using namespace loadpath::table;

namespace {

struct Pick {
  const char* material;
  double d;    // mm
  double R_e;  // MPa; 0: not covered
  const char* source;
};

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("a size picks its strength, up to and including the step") {
    const Pick picks[] = {
        {"C45E", 15, 490, "EN 10083-2"},    {"C45E", 16, 490, "EN 10083-2"},   {"C45E", 17, 430, "EN 10083-2"},
        {"C45E", 40, 430, "EN 10083-2"},    {"C45E", 41, 370, "EN 10083-2"},   {"C45E", 100, 370, "EN 10083-2"},
        {"C45E", 101, 0, "EN 10083-2"},     {"S235", 16, 235, "EN 10025-2"},   {"S235", 16.01, 225, "EN 10025-2"},
        {"S235", 63, 215, "EN 10025-2"},    {"S235", 100, 215, "EN 10025-2"},  {"S235", 250, 175, "EN 10025-2"},
        {"S235", 251, 0, "EN 10025-2"},     {"S355", 40.5, 335, "EN 10025-2"}, {"S355", 80, 325, "EN 10025-2"},
        {"42CrMo4", 60, 650, "EN 10083-3"}, {"16MnCr5", 30, 0, "EN 10084"},    {"40Kh", 25, 785, "GOST 4543-71"},
    };
    for (const Pick& pick : picks) {
      CAPTURE(pick.material);
      CAPTURE(pick.d);
      CAPTURE(pick.source);
      const auto found = property(material(pick.material), "R_e", pick.d / 1000.0);
      CHECK(static_cast<bool>(found) == (pick.R_e > 0.0));
      if (found) CHECK(found->si == pick.R_e * MPa);
    }
  }

  TEST_CASE("a property has its unit and its sources") {
    const auto R_e = property(material("C45E"), "R_e", 16.0 * mm);
    REQUIRE(R_e);
    CHECK(R_e->unit == "MPa");
    CHECK(R_e->sources == std::vector<std::string>{"Lucefin-C45E", "Saarstahl-C45"});
    CHECK_FALSE(R_e->recalled);
    CHECK(citation("Lucefin-C45E") == "Lucefin Group: Technical card C45E, EN 10083-2:2006");
    CHECK(citation("nowhere").empty());
    const auto rho = property(material("C50E"), "rho");
    REQUIRE(rho);
    CHECK(rho->recalled);
    CHECK(rho->sources.empty());
  }

  TEST_CASE("constants are in SI to the last bit") {
    CHECK(value_of(material("S355"), "E") == 210e9);
    CHECK(value_of(material("S355"), "alpha") == 12e-6);
    CHECK(value_of(material("S355"), "rho") == 7850.0);
    CHECK(value_of(material("S355"), "nu") == 0.3);
    CHECK(value_of(material("AISI 1045 HR"), "G") == 79.3e9);
  }

  TEST_CASE("a material is found by its number, its old name and its Cyrillic name") {
    CHECK(material("1.1191").row->name == "C45E");
    CHECK(material("ck45").row->name == "C45E");
    CHECK(material("S 235").row->name == "S235");
    CHECK(material("40X").row->name == "40Kh");
    CHECK(material("40Х").row->name == "40Kh");
    CHECK(material("сталь 45").row->name == "Steel 45");
    CHECK(material("6082-T6").row->name == "EN AW-6082-T6");
  }

  TEST_CASE("the beginning of names is answered with the rows that begin with it") {
    const auto fault = [](const char* name) { return find_row("section", name).fault().hint.text(); };
    CHECK(fault("ipe") == "rows that begin with it: IPE 80, IPE 100, IPE 120 and 15 more");
  }

  TEST_CASE("the tables in use give the same as the full library") {
    for (const char* name : {"C45E", "1.0038", "ck45", "сталь 45"}) {
      const auto found = find_row("material", name);
      REQUIRE(found);
      CHECK(found->row->name == material(name).row->name);
      CHECK(value_of(*found, "R_m", 0.0) == value_of(material(name), "R_m", 0.0));
    }
    const auto unknown = find_row("material", "42CrMo5");
    CHECK(unknown.fault().hint.text() == "did you mean '42CrMo4'?");
    CHECK((*find_series("R40"))->members.size() == 201);
    CHECK_FALSE(find_series("R21"));
  }

  TEST_CASE("the first file that has a row is the only one of its group") {
    std::map<std::pair<std::string, std::string>, std::string> homes;
    for (const Table& table : built_in().tables) {
      for (const Row& row : table.rows) {
        std::vector<std::string> names = row.aliases;
        names.push_back(row.name);
        for (const std::string& name : names) {
          const std::string& home = homes.emplace(std::pair(table.group, name), table.name).first->second;
          CHECK_MESSAGE(home == table.name, name);
        }
      }
    }
  }

  TEST_CASE("a table and a series are found by their names, or do not exist") {
    CHECK(first_table_in("materials/steel_aisi")->name == "materials/steel_aisi");
    CHECK(first_table_in("materials")->group == "material");
    CHECK(first_table_in("material") == nullptr);
    CHECK(series_named("R40") == *find_series("R40"));
    CHECK(series_named("R4") == nullptr);
  }

  TEST_CASE("a citation is the same as from the full library") {
    for (const auto& [key, known] : built_in().citations) CHECK(citation(key) == known.text);
    CHECK(citation("nobody").empty());
  }

  TEST_CASE("the size range of a property can be queried") {
    CHECK(covered_size(material("C45E"), "R_e") == 100.0 * mm);
    CHECK(std::isinf(covered_size(material("C45E"), "E")));
    CHECK(covered_size(material("16MnCr5"), "R_e") == 16.0 * mm);
    CHECK(covered_size(material("EN-GJL-250"), "R_e") == 0.0);
  }

  TEST_CASE("a look-up that finds nothing states why") {
    const auto why = [](const Outcome<Property>& found) { return found.fault().message.text(); };
    CHECK(why(property(material("C45E"), "R_e", 101.0 * mm)) == "R_e of 'C45E' is given up to 100 mm, not for 101 mm");
    CHECK(why(property(material("C45E"), "R_e")) == "R_e of 'C45E' depends on the size, which is not given");
    CHECK(why(property(material("EN-GJL-250"), "R_e", 10.0 * mm)) == "'EN-GJL-250' has no value of R_e");
    const auto misspelt = property(material("C45E"), "Re");
    CHECK(why(misspelt) == "the table 'materials/steel_heat_treatable' has no property 'Re'");
    CHECK(misspelt.fault().hint.text() == "did you mean 'R_e'?");
    const auto unknown = find_row(built_in(), "material", "42CrMo5");
    CHECK(unknown.fault().message.text() == "no material '42CrMo5' in the tables");
    CHECK(unknown.fault().hint.text() == "did you mean '42CrMo4'?");
    CHECK(find_row(built_in(), "material", "unobtainium").fault().hint.text() ==
          "`loadpath tables materials` lists them");
    CHECK(find_row(built_in(), "synchronous_belt", "HTD 8M").fault().hint.text() ==
          "available: XL, L, H, XH, XXH; `loadpath tables belt/synchronous` lists them");
  }
}
