// Rules name every field that they depend on: a sweep asks a rule again only where one of its fields varies.
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

/// The rules that another value of a field decides, and that do not name it.
std::set<std::string> unnamed(const Calculator& c, const Record& example, const FieldInfo& field) {
  std::set<std::string> found;
  const double given = field.get(example.data.get());
  for (const double factor : {-1.0, 0.01, 0.1, 0.3, 0.6, 0.9, 1.1, 1.6, 3.0, 10.0, 100.0}) {
    const double si = field.type == FieldInfo::Type::count ? std::round(factor * given) : factor * given;
    if (std::isnan(si) || !field.bounds.holds(si)) continue;
    const Record other = example.clone();
    field.set(other.data.get(), si);
    for (std::size_t i = 0; i < c.rules.size(); ++i) {
      if (c.rules[i].only_warns || names(c.rules[i], field)) continue;
      if (c.holds(i, example.data.get()) != c.holds(i, other.data.get()))
        found.insert(std::string(c.id) + ": '" + c.rules[i].text + "' depends on " + field.key);
    }
  }
  return found;
}

}  // namespace

TEST_SUITE("contract fields of rules") {
  TEST_CASE("no rule changes with a number that it does not name") {
    std::set<std::string> found;
    test::for_each_step([&](const project::Step& step, const std::string&) {
      const Calculator& c = *step.input().calculator;
      if (c.result == nullptr) return;
      const Record solved = test::found_input(step);
      for (const FieldInfo& field : c.input->fields) {
        if (field.is_number() && field.get != nullptr) found.merge(unnamed(c, solved, field));
      }
    });
    for (const std::string& one : found) FAIL_CHECK(one);
  }
}
