// Rules name every field that they depend on, and modes say that they depend on no load: a sweep asks them again only
// where these vary.
#include "tests/contract/calculators.hpp"
#include "tests/contract/held.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace {

using namespace loadpath;

bool names(const RuleInfo& rule, const FieldInfo& field) {
  const auto fields = listed_keys(rule.fields);
  return fields.empty() || std::find(fields.begin(), fields.end(), field.key) != fields.end();
}

/// Records with other values of a field that its bounds accept.
template <class Visit>
void for_other_values(const Record& example, const FieldInfo& field, Visit&& visit) {
  const double given = field.get(example.data.get());
  for (const double factor : {-1.0, 0.0, 0.01, 0.1, 0.3, 0.6, 0.9, 1.1, 1.6, 3.0, 10.0, 100.0}) {
    const double si = field.type == FieldInfo::Type::count ? std::round(factor * given) : factor * given;
    if (std::isnan(si) || !field.bounds.holds(si)) continue;
    const Record other = example.clone();
    field.set(other.data.get(), si);
    visit(other);
  }
}

/// The rules that another value of a field decides, and that do not name it.
void find_unnamed(const Calculator& c, const Record& example, const FieldInfo& field, std::set<std::string>& found) {
  for_other_values(example, field, [&](const Record& other) {
    for (std::size_t i = 0; i < c.rules.size(); ++i) {
      if (c.rules[i].only_warns || names(c.rules[i], field)) continue;
      if (c.holds(i, example.data.get()) != c.holds(i, other.data.get()))
        found.insert(std::string(c.id) + ": '" + c.rules[i].text + "' depends on " + field.key);
    }
  });
}

/// The modes that are independent of loads, and that another value of a load decides.
void find_dependent(const Calculator& c, const Record& example, const FieldInfo& load, std::set<std::string>& found) {
  for_other_values(example, load, [&](const Record& other) {
    for (std::size_t i = 0; i < c.modes.size(); ++i) {
      if (!c.modes[i].is_independent_of_loads) continue;
      if (c.applies(i, example.data.get()) != c.applies(i, other.data.get()))
        found.insert(std::string(c.id) + ": mode " + c.modes[i].id + " depends on " + load.key);
    }
  });
}

/// What `find` finds for every number of the inputs of all steps.
template <class Find>
void check_numbers(Find&& find) {
  std::set<std::string> found;
  test::for_each_step([&](const project::Step& step, const std::string&) {
    const Calculator& c = *step.input().calculator;
    if (c.result == nullptr) return;
    const Record solved = test::found_input(step);
    for (const FieldInfo& field : c.input->fields)
      if (field.is_number() && field.get != nullptr) find(c, solved, field, found);
  });
  for (const std::string& one : found) FAIL_CHECK(one);
}

}  // namespace

TEST_SUITE("contract fields of rules") {
  TEST_CASE("no rule changes with a number that it does not name") { check_numbers(&find_unnamed); }

  TEST_CASE("modes that are independent of loads change with none") {
    check_numbers([](const Calculator& c, const Record& solved, const FieldInfo& field, std::set<std::string>& found) {
      if (field.is_load) find_dependent(c, solved, field, found);
    });
  }
}
