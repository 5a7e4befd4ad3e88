#include "lib/table/library.hpp"
#include "tests/lib/table/tables.hpp"

#include <algorithm>
#include <set>

using namespace loadpath;
using namespace loadpath::table;

namespace {

template <class Visit>
void each_row(Visit visit) {
  for (const Table& table : built_in().tables) {
    for (const Row& row : table.rows) visit(Entry{&table, &row});
  }
}

template <class Visit>
void each_material(Visit visit) {
  each_row([&](const Entry& entry) {
    if (entry.table->group == "material") visit(entry);
  });
}

template <class Visit>
void each_value(const Row& row, Visit visit) {
  for (const Value& value : row.values) visit(value);
  for (const Step& step : row.by_size) {
    for (const Value& value : step.values) visit(value);
  }
}

double sizes_of_thin_extrusions(const Row& row) { return row.name == "EN AW-6082-T6" ? 20.0 * mm : 0.0; }

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("the elastic constants of every material are consistent") {
    each_material([](const Entry& entry) {
      CAPTURE(entry.row->name);
      const double E = value_of(entry, "E"), G = value_of(entry, "G"), nu = value_of(entry, "nu");
      CHECK(std::abs(2.0 * G * (1.0 + nu) / E - 1.0) < 0.025);
    });
  }

  TEST_CASE("every constant of every material is plausible") {
    each_material([](const Entry& entry) {
      CAPTURE(entry.row->name);
      CHECK(value_of(entry, "E") > 60e9);
      CHECK(value_of(entry, "E") < 220e9);
      CHECK(value_of(entry, "rho") > 2600.0);
      CHECK(value_of(entry, "rho") < 9000.0);
      CHECK(value_of(entry, "alpha") > 9e-6);
      CHECK(value_of(entry, "alpha") <= 25e-6);
    });
  }

  TEST_CASE("a thicker part is never stronger, but for thin extrusions") {
    each_material([](const Entry& entry) {
      CAPTURE(entry.row->name);
      for (const char* key : {"R_e", "R_m"}) {
        double last = 1e12;
        for (const Step& step : entry.row->by_size) {
          const double strength = value_of(entry, key, step.size_max);
          if (std::isnan(strength) || step.size_max <= sizes_of_thin_extrusions(*entry.row)) continue;
          CHECK(strength <= last);
          last = strength;
        }
      }
    });
  }

  TEST_CASE("no material yields above its tensile strength") {
    each_material([](const Entry& entry) {
      CAPTURE(entry.row->name);
      std::vector<double> sizes = {0.0};
      for (const Step& step : entry.row->by_size) sizes.push_back(step.size_max);
      for (const double size : sizes) {
        const double R_e = value_of(entry, "R_e", size);
        CHECK((std::isnan(R_e) || R_e < value_of(entry, "R_m", size)));
      }
    });
  }

  TEST_CASE("every material has a tensile strength, a standard and a kind") {
    each_material([](const Entry& entry) {
      CAPTURE(entry.row->name);
      CHECK(covered_size(entry, "R_m") > 0.0);
      CHECK_FALSE(entry.row->standard.empty());
      CHECK_FALSE(entry.row->kind.empty());
    });
  }

  TEST_CASE("a name or an alias means one material") {
    std::map<std::string, int> count;
    each_material([&](const Entry& entry) {
      ++count[entry.row->name];
      for (const std::string& alias : entry.row->aliases) ++count[alias];
    });
    for (const auto& times : count) {
      CAPTURE(times.first);
      CHECK(times.second == 1);
    }
  }

  TEST_CASE("every source that a value cites exists, and every source is cited") {
    std::set<std::string> cited;
    each_row([&](const Entry& entry) {
      each_value(*entry.row, [&](const Value& v) { cited.insert(v.sources.begin(), v.sources.end()); });
    });
    for (const Series& series : built_in().series) cited.insert(series.sources.begin(), series.sources.end());
    for (const auto& known : built_in().citations) {
      CAPTURE(known.first);
      CHECK(known.second.text.size() > 20);
      CHECK(known.second.of_method != (cited.count(known.first) == 1));
    }
    for (const std::string& key : cited) CHECK(built_in().citations.count(key) == 1);
  }

  TEST_CASE("the audit names every value without a source, and no other") {
    std::size_t recalled = 0;
    each_row([&](const Entry& entry) {
      each_value(*entry.row, [&](const Value& v) { recalled += v.sources.empty() ? 1 : 0; });
    });
    for (const Series& series : built_in().series) recalled += series.recalled.size();
    const auto found = audit(built_in());
    CHECK(found.size() == recalled);
    const auto names = [&](const char* row, const char* key) {
      return std::any_of(found.begin(), found.end(), [&](const Recalled& r) { return r.row == row && r.key == key; });
    };
    CHECK(names("50CrMo4", "R_e"));
    CHECK(names("34CrNiMo6", "rho"));
    CHECK(names("Ra20", ""));
    CHECK_FALSE(names("C45E", "R_e"));
    CHECK_FALSE(names("S235", "rho"));
    CHECK_FALSE(names("R20", ""));
  }

  TEST_CASE("the audit states the size") {
    const auto found = audit(built_in());
    const auto at = std::find_if(found.begin(), found.end(),
                                 [](const Recalled& r) { return r.row == "34CrNiMo6" && r.key == "R_e"; });
    REQUIRE(at != found.end());
    CHECK(at->size_max == 40.0 * mm);
    CHECK(at->si == 900.0 * MPa);
    CHECK(at->unit == "MPa");
    CHECK(at->table == "materials/steel_heat_treatable");
  }
}
