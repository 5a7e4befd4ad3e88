// Both forms of evaluation, with a trace or without, one by one or swept, give the same results to the bit.
#include "tests/allocations.hpp"
#include "tests/contract/calculators.hpp"
#include "tests/tries.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <random>

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
/// A history is counted, a law is followed from corner to corner, a motion step by step: what they consist of is
/// gathered first. A search sorts its combinations before it rates them.
bool gathers(const Calculator& c) {
  constexpr std::array ids{"fatigue.history", "dynamics.force", "dynamics.impulse", "dynamics.motion",
                           "gear.sizing",     "machine.motion", "motion.point",     "motion.rotation"};
  return std::ranges::find(ids, std::string_view(c.id)) != ids.end();
}

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
    const bool takes_memory = tests::allocations() != before;  // of its own: a message takes some, too
    CHECK_MESSAGE((!takes_memory || gathers(c)), std::string(c.id));
  }
};

void check_sweep(const Calculator& c, const SolvedExample& s, const std::string& path, double value) {
  std::vector<double> values;
  for (int i = 0; i < (test::sanitized ? 3 : 9); ++i) values.push_back(value * (1.0 + 0.001 * i));
  const Sweep swept(c, s, path, values);
  Record single = s.input.clone(), result(*c.result);
  for (std::size_t i = 0; i < values.size(); ++i) {
    find_leaf(single, path).set(values[i]);
    c.evaluate(single.data.get(), result.data.get());
    for (std::size_t k = 0; k < swept.outputs.size(); ++k)
      CHECK(same_bits(swept.columns[k][i], swept.outputs[k]->get(result.data.get())));
  }
}

/// A value of a usual size; or a wild one, which need not be within the bounds of the field.
double some_value(const FieldInfo& f, std::mt19937& random, bool wild) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::array any{0.0, -0.0, -f.factor, 1e-310, inf, std::nan("")};
  if (wild) return any[random() % any.size()];
  const double low = std::isfinite(f.plausible.low) ? f.plausible.low : 0.5 * f.factor;
  const double high = std::isfinite(f.plausible.high) ? f.plausible.high : 2.0 * f.factor;
  return std::uniform_real_distribution<double>(low, high)(random);
}

bool alike(double a, double b) { return same_bits(a, b) || (std::isnan(a) && std::isnan(b)); }

/// A sweep of a form: the varied inputs and the requested results are drawn at random.
class FormSweep {
 public:
  FormSweep(const Calculator& c, const Form& form, std::size_t points, std::mt19937& random)
      : c_(c), input_(*c.input), result_(*c.result), points_(points) {
    detail::any_of(form.given, [&](std::string_view entry) { return give(entry, random), false; });
    for_each_leaf(result_, [&](const std::string& path, const Leaf& leaf) {
      const bool is_asked = *form.asked == '\0' || detail::names(form.asked, path);
      if (leaf.field->type != Type::quantity || !is_asked || random() % 4 == 0) return;
      results_.push_back(leaf);
    });
    swept_.assign(results_.size(), std::vector<double>(points_));
  }

  void check() {
    std::vector<InputColumn> in;
    std::vector<ResultColumn> out;
    for (std::size_t k = 0; k < varied_.size(); ++k) in.push_back({offset_of(input_, varied_[k]), columns_[k].data()});
    for (std::size_t k = 0; k < results_.size(); ++k)
      out.push_back({offset_of(result_, results_[k]), swept_[k].data()});
    const InputColumn nowhere{no_bound, nullptr};
    const bool has_its_own = c_.loop(input_.data.get(), in, out) != c_.loop(input_.data.get(), {&nowhere, 1}, {});
    CHECK(has_its_own);
    const std::size_t before = tests::allocations();
    c_.sweep(input_.data.get(), in, out, points_);
    CHECK(tests::allocations() == before);
    for (std::size_t i = 0; i < points_; ++i) check_point(i);
  }

 private:
  void give(std::string_view entry, std::mt19937& random) {
    const std::string key(entry.substr(0, entry.find(detail::equals)));
    const Leaf leaf = find_leaf(input_, key);
    const std::string_view word = detail::word_in(entry, key);
    if (!word.empty()) CHECK(set_word(leaf, word));
    if (leaf.field->type == Type::choice && word.empty())
      leaf.set(static_cast<double>(random() % leaf.field->choices.size()));
    if (leaf.field->type == Type::count) leaf.set(leaf.field->bounds.low);
    if (leaf.field->type != Type::quantity) return;
    leaf.set(some_value(*leaf.field, random, false));
    if (random() % 3 == 0) return;
    varied_.push_back(leaf);
    std::vector<double>& column = columns_.emplace_back(points_);
    for (double& x : column) x = some_value(*leaf.field, random, random() % 97 == 0);
  }

  void check_point(std::size_t i) {
    for (std::size_t k = 0; k < varied_.size(); ++k) varied_[k].set(columns_[k][i]);
    c_.evaluate(input_.data.get(), result_.data.get());
    for (std::size_t k = 0; k < results_.size(); ++k) {
      CAPTURE(results_[k].field->key);
      CAPTURE(i);
      CHECK(alike(swept_[k][i], results_[k].get()));
    }
  }

  const Calculator& c_;
  Record input_, result_;
  std::size_t points_;
  std::vector<Leaf> varied_, results_;
  std::vector<std::vector<double>> columns_, swept_;
};

/// Several leaves at once, and some of the results.
void check_subsets(const Calculator& c, const SolvedExample& s, std::mt19937& random) {
  constexpr std::size_t points = 5;
  Record input = s.input.clone(), single = s.input.clone(), result(*c.result);
  std::vector<Leaf> leaves, outputs;
  std::vector<std::vector<double>> columns, swept;
  for_each_leaf(single, [&](const std::string&, const Leaf& leaf) {
    if (leaf.field->type != Type::quantity || std::isnan(leaf.get()) || random() % 3 != 0) return;
    leaves.push_back(leaf);
    for (double& x : columns.emplace_back(points, leaf.get())) x *= 1.0 + 1e-3 * static_cast<double>(random() % 10);
  });
  for (const FieldInfo& f : c.result->fields) {
    if (f.type == Type::quantity && random() % 2 == 0) outputs.push_back({&f, result.data.get()});
  }
  swept.assign(outputs.size(), std::vector<double>(points));
  std::vector<InputColumn> in;
  std::vector<ResultColumn> out;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    // its place inside of the record, or inside of a list's own memory, which a sweep does not reach
    const auto place = reinterpret_cast<std::size_t>(leaves[k].field->address(leaves[k].owner)) -
                       reinterpret_cast<std::size_t>(single.data.get());
    if (place < (std::size_t{1} << 20U)) in.push_back({place, columns[k].data()});
  }
  if (in.size() != leaves.size()) return;
  for (std::size_t k = 0; k < outputs.size(); ++k) out.push_back({offset_of(result, outputs[k]), swept[k].data()});
  c.sweep(input.data.get(), in, out, points);
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t k = 0; k < leaves.size(); ++k) leaves[k].set(columns[k][i]);
    c.evaluate(single.data.get(), result.data.get());
    for (std::size_t k = 0; k < outputs.size(); ++k) CHECK(alike(swept[k][i], outputs[k].get()));
  }
}

}  // namespace

TEST_SUITE("contract: evaluation" * by_element) {
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

  TEST_CASE("a limit that is declared independent of the sizes has the same bits at every size that is searched for") {
    std::size_t seen = 0;
    for (const Calculator* c : plain_calculators()) {
      SolvedExample s = solved_example(*c);
      for_each_leaf(s.input, [](const std::string&, const Leaf& leaf) {
        if (leaf.field->provider.kind == Provider::Kind::companion) leaf.set(leaf.field->factor);
      });
      for_each_leaf(s.input, [&](const std::string& path, const Leaf& leaf) {
        if (leaf.field->type != FieldInfo::Type::quantity || *leaf.field->searched_in == '\0') return;
        const Sweep swept(*c, s, path, {1e-3, 0.02, 0.05, 1.0});
        for (std::size_t k = 0; k < swept.outputs.size(); ++k) {
          if (!swept.outputs[k]->is_sizeless) continue;
          CAPTURE(c->id);
          CAPTURE(swept.outputs[k]->key);
          ++seen;
          for (const double si : swept.columns[k]) CHECK(same_bits(si, swept.columns[k][0]));
          CHECK((std::isfinite(swept.columns[k][0]) || swept.outputs[k]->where_set));
        }
      });
    }
    if (!is_part()) CHECK(seen >= 3);
  }

  TEST_CASE("a sweep of several inputs gives some of the results, to the bit") {
    for (const Calculator* c : plain_calculators()) {
      std::mt19937 random(1);
      CAPTURE(c->id);
      const SolvedExample s = solved_example(*c);
      check_subsets(*c, s, random);
    }
  }

  TEST_CASE("a sweep that is compiled for its form equals single points to the bit") {
    for (const Calculator* c : plain_calculators()) {
      std::mt19937 random(2);
      for (const Form& form : c->forms) {
        CAPTURE(c->id);
        CAPTURE(form.given);
        for (const std::size_t points : {1U, 3U, 255U, 256U, 700U}) FormSweep(*c, form, points, random).check();
      }
    }
  }
}
