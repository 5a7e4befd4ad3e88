// Invariants of the failure modes of every calculator, whatever it computes.
#include "lib/project/modes.hpp"

#include "tests/contract/calculators.hpp"
#include "tests/contract/held.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

namespace {

using namespace loadpath;
using test::for_each_step;

/// Every check and limit with its path, elements of lists without their number: "segments.u_tau".
void add_judges(std::span<const FieldInfo> fields, const std::string& prefix,
                std::vector<std::pair<std::string, const FieldInfo*>>& all) {
  for (const FieldInfo& field : fields) {
    if (field.role == Role::check || field.role == Role::limit) all.emplace_back(prefix + field.key, &field);
    add_judges(field.fields, prefix + field.key + ".", all);
  }
}

std::vector<std::pair<std::string, const FieldInfo*>> judges_of(const Calculator& calculator) {
  std::vector<std::pair<std::string, const FieldInfo*>> all;
  if (calculator.result != nullptr) add_judges(calculator.result->fields, "", all);
  return all;
}

bool is_named(const Calculator& calculator, const std::string& key) {
  return std::any_of(calculator.modes.begin(), calculator.modes.end(), [&](const ModeInfo& mode) {
    const auto keys = listed_keys(mode.checks);
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  });
}

bool takes_records(std::span<const FieldInfo> fields) {
  return std::any_of(fields.begin(), fields.end(), [](const FieldInfo& field) {
    return field.type == FieldInfo::Type::record || takes_records(field.fields);
  });
}

/// A mode left to another calculator names records of this one, and modes of that one, which takes a record.
void check_left(const Calculator& calculator, const ModeInfo& mode) {
  const auto keys = listed_keys(mode.taken);
  CHECK_MESSAGE((*mode.judge == '\0') == keys.empty(), "the judge, and what of it judges");
  const Calculator* const judge = find_calculator(calculators(), mode.judge);
  for (const std::string& key : keys) {
    const std::size_t dot = key.find('.');
    REQUIRE_MESSAGE(dot != std::string::npos, key);
    const FieldInfo* const record = find_field(calculator.result->fields, key.substr(0, dot));
    const bool hands_over = record != nullptr && (record->is_handed_over || record->type == FieldInfo::Type::list);
    CHECK_MESSAGE(hands_over, key, " is no record that is handed over, nor a list of such");
    CHECK_MESSAGE(std::any_of(judge->modes.begin(), judge->modes.end(),
                              [&](const ModeInfo& m) { return key.substr(dot + 1) == m.id; }),
                  key, " is no mode of ", mode.judge);
    CHECK_MESSAGE(takes_records(judge->input->fields), std::string(mode.judge), " takes no record");
  }
}

}  // namespace

TEST_SUITE("contract" * test::by_element) {
  TEST_CASE("a failure mode has a unique id, a title, and checks that exist") {
    for (const Calculator* c : test::calculators_taken()) {
      const auto judges = judges_of(*c);
      std::set<std::string> ids;
      for (const ModeInfo& mode : c->modes) {
        INFO(std::string(c->id), " ", std::string(mode.id));
        CHECK(ids.insert(mode.id).second);
        CHECK(project::is_name(mode.id));
        CHECK(!std::string(mode.title).empty());
        CHECK_MESSAGE((*mode.judge == '\0' || find_calculator(calculators(), mode.judge) != nullptr), mode.judge,
                      " is no calculator");
        check_left(*c, mode);
        if (c->result == nullptr) continue;  // the aspects of a mechanism make its rows
        for (const std::string& key : listed_keys(mode.checks)) {
          const bool known = std::any_of(judges.begin(), judges.end(), [&](const auto& j) { return j.first == key; });
          CHECK_MESSAGE(known, key, " is no check and no limit of it");
        }
        for (const std::string& key : listed_keys(mode.wants))
          CHECK_MESSAGE(find_field(c->input->fields, key.substr(0, key.find_first_of(" ["))) != nullptr, key,
                        " is no input of it");
      }
    }
  }

  TEST_CASE("every check and limit assesses a failure mode, or is declared not to") {
    for (const Calculator* c : test::calculators_taken()) {
      for (const auto& judge : judges_of(*c)) {
        INFO(std::string(c->id), " ", judge.first);
        CHECK_MESSAGE(is_named(*c, judge.first) != judge.second->is_informative,
                      "name it in a mode (.judged_by), or declare it .informative(), not both");
      }
    }
  }

  // The aspects of a mechanism make its rows when it is solved, so that only projects show them.
  TEST_CASE("every row that assesses a mechanism is named by a mode") {
    if (!test::takes("mechanism")) return;
    for_each_step([](const project::Step& step, const std::string& where) {
      const Calculator& calculator = *step.input().calculator;
      if (calculator.result != nullptr) return;
      for (const account::Verdict& row : step.account().verdicts) {
        INFO(where, " ", row.symbol);
        CHECK(std::any_of(calculator.modes.begin(), calculator.modes.end(), [&](const ModeInfo& mode) {
          const auto keys = listed_keys(mode.checks);
          return std::any_of(keys.begin(), keys.end(),
                             [&](const std::string& key) { return project::names_row(key, row.symbol); });
        }));
      }
    });
  }

  TEST_CASE("a calculator without modes assesses nothing") {
    for (const Calculator* c : test::calculators_taken()) {
      INFO(std::string(c->id));
      if (c->modes.empty()) CHECK(judges_of(*c).empty());
    }
  }
}
