// Invariants of the reader for every calculator: a record written as text reads back the same, and invalid values are
// refused at their place.
#include "lib/project/solving/read_project.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "tests/contract/calculators.hpp"

namespace {

using namespace loadpath;
using namespace loadpath::test;
using Type = FieldInfo::Type;

/// One step with one field written as `value`.
std::vector<Issue> issues_of(const Calculator& c, const std::string& key, const std::string& value) {
  std::vector<Issue> issues;
  project::read_project("[part]\ncalculator = \"" + std::string(c.id) + "\"\n" + key + " = " + value + "\n",
                        "part.toml", catalogue(), issues);
  return issues;
}

bool has_error(const std::vector<Issue>& issues, const std::string& key) {
  for (const Issue& i : issues) {
    if (i.key == "part." + key && i.place.line == 3 && i.severity == Severity::error) return true;
  }
  return false;
}

/// "3.5 mm"; "3.5" where the unit is none.
std::string written(double number, const char* unit) {
  return format_exact(number) + (std::string_view(unit) == "-" ? "" : " " + std::string(unit));
}

}  // namespace

TEST_SUITE("contract" * by_element) {
  TEST_CASE("a record written as text reads back the same") {
    for (const Calculator* c : plain_calculators()) {
      const SolvedExample s = solved_example(*c);
      for_each_leaf(s.input, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != Type::quantity || std::isnan(leaf.get())) return;
        CAPTURE(path);
        const FieldInfo& f = *leaf.field;
        const auto read =
            parse_literal(written(in_unit(leaf.get(), f.unit), f.unit), Expected{f.dimension, f.kind, f.unit});
        REQUIRE(read);
        CHECK(read->si == doctest::Approx(leaf.get()).epsilon(1e-15));
      });
    }
  }

  TEST_CASE("a choice without a value is the default of its record") {
    for (const Calculator* c : plain_calculators()) {
      const Record blank(*c->input), record(*c->input);
      for_each_leaf(record, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != Type::choice) return;
        CAPTURE(path);
        const double not_chosen = find_leaf(blank, path).get();
        leaf.set(static_cast<double>(leaf.field->choices.size() - 1));
        leaf.set(std::nan(""));
        CHECK(same_bits(leaf.get(), not_chosen));
      });
    }
  }

  TEST_CASE("a quantity of another dimension, or without a unit, is refused at its place") {
    for (const Calculator* c : calculators_taken()) {
      for (const FieldInfo& f : c->input->fields) {
        if (f.type != Type::quantity) continue;
        INFO(std::string(c->id));
        INFO(std::string(f.key));
        CHECK(has_error(issues_of(*c, f.key, "\"3 kg^7\""), f.key));
        if (!f.dimension.is_number()) CHECK(has_error(issues_of(*c, f.key, "3"), f.key));
      }
    }
  }

  TEST_CASE("a value outside its bounds is refused with the bound, the value and the unit") {
    for (const Calculator* c : calculators_taken()) {
      for (const FieldInfo& f : c->input->fields) {
        if (f.type != Type::quantity || std::isinf(f.bounds.low)) continue;
        INFO(std::string(c->id));
        INFO(std::string(f.key));
        const std::string below = written(in_unit(f.bounds.low, f.unit) - 1.0, f.unit);
        CHECK(has_error(issues_of(*c, f.key, "\"" + below + "\""), f.key));
      }
    }
  }

  TEST_CASE("an unknown field is refused with the nearest one") {
    for (const Calculator* c : calculators_taken()) {
      INFO(std::string(c->id));
      const std::string key = c->input->fields[0].key;
      CHECK(has_error(issues_of(*c, key + key, "\"1 mm\""), key + key));
    }
  }
}
