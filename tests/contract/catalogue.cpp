// Invariants of the catalogue: fields are complete, ids and sources are sound, every example runs.
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/report/appendix.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "tests/contract/calculators.hpp"

#include <set>

namespace {

using namespace loadpath;
using namespace loadpath::test;

void check_quantity(const FieldInfo& f) {
  const auto unit = parse_unit(f.unit);
  REQUIRE(unit);
  CHECK(unit->dimension == f.dimension);
  CHECK(unit->factor == doctest::Approx(f.factor).epsilon(1e-15));
  CHECK(f.bounds.low < f.bounds.high);
  CHECK(f.plausible.low < f.plausible.high);
}

void check_fields(std::span<const FieldInfo> fields, const std::string& where) {
  std::set<std::string> keys;
  for (const FieldInfo& f : fields) {
    CAPTURE(where);
    INFO(std::string(f.key));
    CHECK(keys.insert(f.key).second);
    CHECK(std::strlen(f.doc) > 3);
    if (f.type == FieldInfo::Type::quantity) check_quantity(f);
    if (f.type == FieldInfo::Type::choice) CHECK(f.choices.size() >= 2);
    if (f.has_fields()) check_fields(f.fields, where + "." + f.key);
  }
}

}  // namespace

TEST_SUITE("contract" * by_element) {
  TEST_CASE("every field has a key of its own, a meaning, a unit that fits its dimension, and sound bounds") {
    for (const Calculator* c : calculators_taken()) {
      check_fields(c->input->fields, c->id);
      if (c->result != nullptr) check_fields(c->result->fields, c->id);
    }
  }

  TEST_CASE("a required life is an optional input") {
    for (const Calculator* c : calculators_taken()) {
      const FieldInfo* const life = *c->life == '\0' ? nullptr : find_field(c->input->fields, c->life);
      if (*c->life != '\0') CHECK_MESSAGE((life != nullptr && life->optional), std::string(c->id));
    }
  }

  TEST_CASE("ids are an element and a case, and their sources are in the bibliography") {
    std::set<std::string> ids;
    for (const Calculator* c : calculators_taken()) {
      INFO(std::string(c->id));
      CHECK(ids.insert(c->id).second);
      CHECK(std::string(c->id).find('.') != std::string::npos);
      CHECK(project::is_name(std::string(c->element())));
      const auto keys = report::keys_in(c->source);
      CHECK(!keys.empty());
      for (const std::string& key : keys)
        CHECK_MESSAGE(!table::citation(key).empty(), key, " is no source: add a row to tables/sources.toml");
      for (const std::string& key : c->used_sources()) {
        CHECK_MESSAGE(!table::citation(key).empty(), key, " is no source: add a row to tables/sources.toml");
        CHECK_MESSAGE(keys.count(key) == 0, key, " is cited already");
      }
    }
  }

  TEST_CASE("the example of a calculator runs, and none of its checks or modes fails") {
    for (const Calculator* c : calculators_taken()) {
      INFO(std::string(c->id));
      std::vector<Issue> issues;
      project::Project p = example_of(*c, issues);
      project::solve(p, issues);
      CHECK_MESSAGE(issues.empty(), (issues.empty() ? "" : issues[0].message.text()));
      REQUIRE(p.steps.size() == 1);
      CHECK(p.steps[0]->input().calculator == c);
      CHECK(account::worst(project::verdicts(p)) == account::State::pass);
      for (const account::Mode& mode : project::modes(p)) {
        INFO(mode.id);
        CHECK(account::rank(mode.state) <= account::rank(account::State::not_judged));
      }
    }
  }
}
