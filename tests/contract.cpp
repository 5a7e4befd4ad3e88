// What every calculator of the catalogue keeps: its fields are complete, its example runs, its readers refuse what they
// must, a sweep equals single points, and the text of every STEP says what the code computes.
#include "calculators/catalogue.hpp"
#include "lib/formula/formula.hpp"
#include "lib/project/project.hpp"
#include "lib/project/run/derivation.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/report/build.hpp"
#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"
#include "tests/allocations.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

namespace {

using namespace loadpath;
using Type = FieldInfo::Type;

project::Project example_of(const Calculator& c, std::vector<Issue>& issues) {
  return project::read_project(c.example, "example.toml", catalogue(), issues);
}

/// The input and result of a calculator's example, as they were traced.
struct Solved {
  Record input, result;
  Trace trace;
};

Solved solved_example(const Calculator& c) {
  std::vector<Issue> issues;
  project::Project p = example_of(c, issues);
  REQUIRE(issues.empty());
  Solved s{p.steps[0]->input().reading.record.clone(), Record(*c.result), {}};
  project::solve(p, issues);
  for (const account::Entry& e : p.steps[0]->account().inputs) {  // what rows of tables filled
    const Leaf leaf = find_leaf(s.input, e.path);
    if (leaf && leaf.field->get != nullptr && std::isnan(leaf.get()) && e.value.si.size() == 1) leaf.set(e.value.si[0]);
  }
  c.explain(s.input.data.get(), s.result.data.get(), s.trace);
  return s;
}

std::vector<const Calculator*> plain_calculators() {
  std::vector<const Calculator*> plain;
  for (const Calculator* c : calculators()) {
    if (c->evaluate != nullptr) plain.push_back(c);
  }
  return plain;
}

void check_fields(std::span<const FieldInfo> fields, const std::string& where) {
  std::set<std::string> keys;
  for (const FieldInfo& f : fields) {
    CAPTURE(where);
    INFO(std::string(f.key));
    CHECK(keys.insert(f.key).second);
    CHECK(std::strlen(f.doc) > 3);
    if (f.type == Type::quantity) {
      const auto unit = parse_unit(f.unit);
      REQUIRE(unit);
      CHECK(unit->dimension == f.dimension);
      CHECK(unit->factor == doctest::Approx(f.factor).epsilon(1e-15));
      CHECK(f.bounds.low < f.bounds.high);
      CHECK(f.plausible.low < f.plausible.high);
    }
    if (f.type == Type::choice) CHECK(f.choices.size() >= 2);
    if (f.has_fields()) check_fields(f.fields, where + "." + f.key);
  }
}

/// One step with one field written as `value`.
std::vector<Issue> issues_of(const Calculator& c, const std::string& key, const std::string& value) {
  std::vector<Issue> issues;
  project::read_project("[part]\ncalculator = \"" + std::string(c.id) + "\"\n" + key + " = " + value + "\n",
                        "part.toml", catalogue(), issues);
  return issues;
}

bool has_issue(const std::vector<Issue>& issues, const std::string& key, int line) {
  for (const Issue& i : issues) {
    if (i.key == key && i.place.line == line && i.severity == Severity::error) return true;
  }
  return false;
}

/// Whether no two names of a formula print alike, as in.b and r.b would.
bool prints_apart(const formula::Node& tree) {
  std::set<std::string_view> symbols;
  const auto names = formula::names(tree);
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return symbols.insert(formula::symbol_of(name)).second; });
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Where a leaf lies inside its record.
std::size_t offset_of(const Record& record, const Leaf& leaf) {
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) -
                                  static_cast<const char*>(record.data.get()));
}

}  // namespace

TEST_SUITE("contract") {
  TEST_CASE("every field has a key of its own, a meaning, a unit that fits its dimension, and sound bounds") {
    for (const Calculator* c : calculators()) {
      check_fields(c->input->fields, c->id);
      if (c->result != nullptr) check_fields(c->result->fields, c->id);
    }
  }

  TEST_CASE("ids are an element and a case, and their sources are in the bibliography") {
    std::set<std::string> ids;
    for (const Calculator* c : calculators()) {
      INFO(std::string(c->id));
      CHECK(ids.insert(c->id).second);
      CHECK(std::string(c->id).find('.') != std::string::npos);
      CHECK(project::is_name(std::string(c->element())));
      const auto keys = report::keys_in(c->source);
      CHECK(!keys.empty());
      for (const std::string& key : keys) CHECK(!table::citation(key).empty());
      for (const std::string& key : c->used_sources()) {
        CHECK_MESSAGE(!table::citation(key).empty(), key);
        CHECK_MESSAGE(keys.count(key) == 0, key);
      }
    }
  }

  TEST_CASE("the example of a calculator runs and passes") {
    for (const Calculator* c : calculators()) {
      INFO(std::string(c->id));
      std::vector<Issue> issues;
      project::Project p = example_of(*c, issues);
      project::solve(p, issues);
      CHECK_MESSAGE(issues.empty(), (issues.empty() ? "" : issues[0].message.text()));
      REQUIRE(p.steps.size() == 1);
      CHECK(p.steps[0]->input().calculator == c);
      CHECK(account::worst(project::verdicts(p)) == account::State::pass);
    }
  }

  TEST_CASE("a record written as text reads back the same") {
    for (const Calculator* c : plain_calculators()) {
      const Solved s = solved_example(*c);
      for_each_leaf(s.input, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != Type::quantity || std::isnan(leaf.get())) return;
        CAPTURE(path);
        const auto read =
            parse_literal(format_exact(in_unit(leaf.get(), leaf.field->unit)) +
                              (std::string_view(leaf.field->unit) == "-" ? "" : " " + std::string(leaf.field->unit)),
                          Expected{leaf.field->dimension, leaf.field->kind, leaf.field->unit});
        REQUIRE(read);
        CHECK(read->si == doctest::Approx(leaf.get()).epsilon(1e-15));
      });
    }
  }

  TEST_CASE("a quantity of another dimension, or without a unit, is refused at its place") {
    for (const Calculator* c : calculators()) {
      for (const FieldInfo& f : c->input->fields) {
        if (f.type != Type::quantity) continue;
        INFO(std::string(c->id));
        INFO(std::string(f.key));
        CHECK(has_issue(issues_of(*c, f.key, "\"3 kg^7\""), std::string("part.") + f.key, 3));
        if (!f.dimension.is_number()) CHECK(has_issue(issues_of(*c, f.key, "3"), std::string("part.") + f.key, 3));
      }
    }
  }

  TEST_CASE("a value outside of its bounds is refused with the bound, the value and the unit") {
    for (const Calculator* c : calculators()) {
      for (const FieldInfo& f : c->input->fields) {
        if (f.type != Type::quantity || std::isinf(f.bounds.low)) continue;
        INFO(std::string(c->id));
        INFO(std::string(f.key));
        const double below = in_unit(f.bounds.low, f.unit) - 1.0;
        const std::string unit = std::string_view(f.unit) == "-" ? "" : " " + std::string(f.unit);
        const auto issues = issues_of(*c, f.key, "\"" + format_exact(below) + unit + "\"");
        CHECK(has_issue(issues, std::string("part.") + f.key, 3));
      }
    }
  }

  TEST_CASE("an unknown field is refused with the nearest one") {
    for (const Calculator* c : calculators()) {
      const std::string key = c->input->fields[0].key;
      const std::string typo = key + key;
      bool found = false;
      for (const Issue& i : issues_of(*c, typo, "\"1 mm\""))
        found = found || (i.key == "part." + typo && i.place.line == 3);
      CHECK_MESSAGE(found, c->id);
    }
  }

  TEST_CASE("with and without a trace the results are the same to the bit") {
    for (const Calculator* c : plain_calculators()) {
      const Solved s = solved_example(*c);
      Record plain(*c->result);
      c->evaluate(s.input.data.get(), plain.data.get());
      for_each_leaf(s.result, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->get == nullptr) return;
        CAPTURE(path);
        CHECK(same_bits(leaf.get(), find_leaf(plain, path).get()));
      });
    }
  }

  TEST_CASE("the text of every step, evaluated over the printed symbols, is the value of the code") {
    for (const Calculator* c : plain_calculators()) {
      const Solved s = solved_example(*c);
      project::Names names(s.input, s.result);
      for (const Line& line : s.trace.lines()) {
        INFO(std::string(c->id));
        INFO(std::string(line.symbol));
        INFO(std::string(line.formula));
        if (*line.formula != '\0') {
          const auto tree = formula::parse(line.formula);
          REQUIRE(tree);
          CHECK(prints_apart(*tree));
          const double value =
              formula::value(*tree, [&](std::string_view name) { return names.si_of(line.scope, name); });
          CHECK(std::abs(value - line.si) <= 1e-12 * std::abs(line.si));
        }
        for (const std::string& key : report::keys_in(line.why)) CHECK_MESSAGE(!table::citation(key).empty(), key);
        names.add(line, names.unit_of(line));
      }
    }
  }

  TEST_CASE("a sweep equals single points to the bit and takes no memory") {
    for (const Calculator* c : plain_calculators()) {
      const Solved s = solved_example(*c);
      for_each_leaf(s.input, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != Type::quantity || std::isnan(leaf.get()) || leaf.get() == 0.0) return;
        CAPTURE(path);
        std::vector<double> values;
        for (int i = 0; i < 9; ++i) values.push_back(leaf.get() * (1.0 + 0.001 * i));
        std::vector<const FieldInfo*> outputs;
        std::vector<std::vector<double>> columns;
        std::vector<ResultColumn> out;
        for (const FieldInfo& f : c->result->fields) {
          if (f.type == Type::quantity) outputs.push_back(&f);
        }
        columns.assign(outputs.size(), std::vector<double>(values.size()));
        for (std::size_t k = 0; k < outputs.size(); ++k)
          out.push_back({offset_of(s.result, {outputs[k], s.result.data.get()}), columns[k].data()});
        Record swept = s.input.clone(), single = s.input.clone(), result(*c->result);
        const Leaf here = find_leaf(swept, path);
        const InputColumn in{offset_of(swept, here), values.data()};
        const std::size_t before = tests::allocations();
        c->sweep(swept.data.get(), {&in, 1}, out, values.size());
        CHECK(tests::allocations() == before);
        for (std::size_t i = 0; i < values.size(); ++i) {
          find_leaf(single, path).set(values[i]);
          c->evaluate(single.data.get(), result.data.get());
          for (std::size_t k = 0; k < outputs.size(); ++k)
            CHECK(same_bits(columns[k][i], outputs[k]->get(result.data.get())));
        }
      });
    }
  }
}
