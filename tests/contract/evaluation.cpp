// What the two ways of evaluating share: with a trace or without, one by one or swept, results are the same to the bit.
#include "tests/allocations.hpp"
#include "tests/contract/calculators.hpp"

namespace {

using namespace loadpath;
using namespace loadpath::test;
using Type = FieldInfo::Type;

/// Where a leaf lies inside its record.
std::size_t offset_of(const Record& record, const Leaf& leaf) {
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) -
                                  static_cast<const char*>(record.data.get()));
}

/// Whether it counts a series of any length, which takes memory of its own.
bool counts_a_history(const Calculator& c) { return std::string_view(c.id) == "fatigue.history"; }

/// Every result over values of one input, swept; takes no memory while it runs.
struct Sweep {
  std::vector<const FieldInfo*> outputs;
  std::vector<std::vector<double>> columns;

  Sweep(const Calculator& c, const SolvedExample& s, const std::string& path, const std::vector<double>& values) {
    for (const FieldInfo& f : c.result->fields) {
      if (f.type == Type::quantity) outputs.push_back(&f);
    }
    columns.assign(outputs.size(), std::vector<double>(values.size()));
    std::vector<ResultColumn> out;
    for (std::size_t k = 0; k < outputs.size(); ++k)
      out.push_back({offset_of(s.result, {outputs[k], s.result.data.get()}), columns[k].data()});
    Record input = s.input.clone();
    const InputColumn in{offset_of(input, find_leaf(input, path)), values.data()};
    const std::size_t before = tests::allocations();
    c.sweep(input.data.get(), {&in, 1}, out, values.size());
    CHECK_MESSAGE((tests::allocations() == before || counts_a_history(c)), c.id);
  }
};

void check_sweep(const Calculator& c, const SolvedExample& s, const std::string& path, double value) {
  std::vector<double> values;
  for (int i = 0; i < 9; ++i) values.push_back(value * (1.0 + 0.001 * i));
  const Sweep swept(c, s, path, values);
  Record single = s.input.clone(), result(*c.result);
  for (std::size_t i = 0; i < values.size(); ++i) {
    find_leaf(single, path).set(values[i]);
    c.evaluate(single.data.get(), result.data.get());
    for (std::size_t k = 0; k < swept.outputs.size(); ++k)
      CHECK(same_bits(swept.columns[k][i], swept.outputs[k]->get(result.data.get())));
  }
}

}  // namespace

TEST_SUITE("contract") {
  TEST_CASE("with and without a trace the results are the same to the bit") {
    for (const Calculator* c : plain_calculators()) {
      const SolvedExample s = solved_example(*c);
      Record plain(*c->result);
      c->evaluate(s.input.data.get(), plain.data.get());
      for_each_leaf(s.result, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->get == nullptr) return;
        CAPTURE(path);
        CHECK(same_bits(leaf.get(), find_leaf(plain, path).get()));
      });
    }
  }

  TEST_CASE("a sweep equals single points to the bit and takes no memory") {
    for (const Calculator* c : plain_calculators()) {
      const SolvedExample s = solved_example(*c);
      for_each_leaf(s.input, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != Type::quantity || std::isnan(leaf.get()) || leaf.get() == 0.0) return;
        CAPTURE(path);
        check_sweep(*c, s, path, leaf.get());
      });
    }
  }
}
