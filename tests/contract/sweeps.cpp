// A point of a sweep is the machine with these values typed, to the bit: results, verdicts, the governing mode, what is
// refused. For every calculator, and at 200 points, or 40 of them, of every example, some of their numbers varied at
// random.
#include "calculators/catalogue.hpp"
#include "lib/account/conclusion.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/variants.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/sweep/point/uniform.hpp"
#include "lib/toml/tree.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace loadpath;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_inputs = 4;

/// Numbers that were typed as such, and may be a little larger or smaller.
std::vector<std::pair<std::string, Leaf>> numbers_of(project::Step& step) {
  std::vector<std::pair<std::string, Leaf>> numbers;
  project::Reading& reading = step.input().reading;
  for (Record* record : {&reading.parameters, &reading.record}) {
    if (record->type == nullptr) continue;
    for_each_leaf(*record, [&](const std::string& path, const Leaf& leaf) {
      const auto typed = reading.typed.find(path);
      const bool literal = typed != reading.typed.end() && !typed->second.text.empty() &&
                           typed->second.text.find_first_of("=?{") == std::string::npos;
      if (!literal || leaf.field->type != FieldInfo::Type::quantity || !std::isfinite(leaf.get()) || leaf.get() == 0.0)
        return;
      if (leaf.field->bounds.holds(0.97 * leaf.get()) && leaf.field->bounds.holds(1.03 * leaf.get()))
        numbers.emplace_back(path, leaf);
    });
  }
  return numbers;
}

/// The project with some of its numbers as inputs of a sweep; which of them `seed` says.
project::Project varied(const std::string& text, const std::string& file, std::uint64_t seed) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, file, catalogue(), issues, project::Ranges::taken);
  REQUIRE_MESSAGE(!has_errors(issues), file);
  std::vector<std::pair<project::Step*, std::pair<std::string, Leaf>>> all;
  for (const auto& step : project.steps) {
    for (auto& number : numbers_of(*step)) all.push_back({step.get(), std::move(number)});
  }
  for (std::size_t k = 0; k < most_inputs && !all.empty(); ++k) {
    const auto which = static_cast<std::size_t>(sweep::uniform(seed, k, 0) * static_cast<double>(all.size()));
    auto& [step, number] = all[which];
    const double middle = number.second.get(), wide = 0.03 * std::abs(middle);
    project::Varied input{.path = number.first, .leaf = number.second, .place = {}};
    input.distribution = sweep::Distribution(sweep::Uniform{middle - wide, middle + wide});
    step->input().reading.varied.push_back(std::move(input));
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(which));
  }
  return project;
}

/// Of a mechanism: what its drive and the first of its joints and links give, reduced where they are series.
std::vector<std::string> loads_of(project::Project& project, const project::Step& step) {
  std::vector<std::string> loads;
  std::vector<std::string> things = {"drive"};
  for (const char* list : {"joints.", "links."}) {
    const auto& typed = step.input().reading.typed;
    const auto first = typed.lower_bound(list);
    if (first == typed.end() || !first->first.starts_with(list)) continue;
    things.push_back(first->first.substr(0, first->first.find('.', std::string_view(list).size())));
  }
  for (const std::string& thing : things) {
    for (const project::Member& member : step.members(thing)) {
      const std::string path = step.name() + "." + member.path;
      if (const auto signature = project.signature(path); signature && !member.is_word)
        loads.push_back(signature->axis == nullptr ? path : "peak(" + path + ")");
    }
  }
  return loads;
}

/// Results that are one number.
std::vector<std::string> columns_of(project::Project& project) {
  std::vector<std::string> columns;
  const auto add = [&](const std::string& text) {
    columns.push_back("r" + std::to_string(columns.size()) + " = " + text);
  };
  for (const auto& step : project.steps) {
    if (step->input().calculator->result == nullptr) {
      for (const std::string& path : loads_of(project, *step)) add(path);
      continue;
    }
    for (const FieldInfo& field : step->input().calculator->result->fields) {
      const std::string path = step->name() + "." + field.key;
      const auto signature = field.is_number() ? project.signature(path) : Outcome<Signature>(Fault{});
      if (signature && signature->axis == nullptr) add(path);
    }
  }
  return columns;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

/// Value of a column from a design of its own.
double alone(project::Project& project, const project::SweptResult& column, bool refused) {
  using Kind = project::SweptResult::Kind;
  if (refused) return column.kind == Kind::state ? account::refused_state : std::nan("");
  if (column.kind == Kind::expression) {
    static const Value none{{}, {std::nan("")}};
    const Value value = column.expression.evaluate([&](const std::string& path) -> const Value& {
      const Value* const known = project.value(path);
      return known == nullptr ? none : *known;
    });
    return value.si[0];
  }
  account::Modes modes;
  for (const account::Mode& mode : project::modes(project)) {
    if ((column.step.empty() || mode.step == column.step) && (column.mode.empty() || mode.id == column.mode))
      modes.push_back(mode);
  }
  if (column.kind == Kind::state) {
    if (modes.empty()) return column.mode.empty() ? static_cast<double>(account::State::open) : account::absent_state;
    return static_cast<double>(column.mode.empty() ? account::overall(modes) : account::worst(modes));
  }
  double most = std::nan("");
  for (const account::Mode& mode : modes) {
    if (mode.utilisation && !(most >= *mode.utilisation)) most = *mode.utilisation;
  }
  return most;
}

/// The mode with the highest utilisation by the columns of a point. Which of them are limits of shape, that govern only
/// where they fail, the machine knows.
std::string governing_in(const std::vector<project::SweptResult>& columns, const account::Modes& modes,
                         const std::vector<std::vector<double>>& out, std::size_t point) {
  std::string governing;
  double most = -1.0;
  for (const account::Mode& known : modes) {
    const auto value = [&](project::SweptResult::Kind kind) {
      for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k].kind == kind && columns[k].step == known.step && columns[k].mode == known.id)
          return out[k][point];
      }
      return std::nan("");
    };
    const double state = value(project::SweptResult::Kind::state);
    if (!(state >= 0.0)) continue;
    account::Mode mode = known;
    mode.state = account::state_of(state);
    const double used = value(project::SweptResult::Kind::utilisation);
    if (!account::is_ranked(mode) || !numerics::exceeds(used, most)) continue;
    most = used;
    governing = mode.step + ": " + mode.id;
  }
  return governing;
}

/// As a report of the machine names it.
std::string governing_of(const account::Modes& modes) {
  const account::Mode* const mode = report::most_utilised(modes);
  return mode == nullptr ? std::string() : mode->step + ": " + mode->id;
}

double value_of(const project::SweptInput& input, std::size_t point, double p) {
  return input.distribution ? input.distribution->quantile(p) : input.axis.at(point % input.axis.size());
}

/// Numbers alone: pictures and formulas are not compared, and take nine tenths of the time of a machine.
project::Wanted numbers_alone(const project::Project& project, const std::vector<project::SweptResult>& columns) {
  project::Wanted wanted{
      .pictures = false, .formulas = false, .unused = false, .words = false, .series = project::SeriesChoice::none()};
  for (const project::SweptResult& column : columns) {
    for (const auto& reference : column.expression.references()) wanted.compared.insert(reference.path);
  }
  return project::with_references(project, std::move(wanted));
}

struct Points {
  std::size_t all;         // that are compared
  std::size_t as_run = 1;  // of them, the first ones: with all that `run` makes of a machine
};

void compare(const std::string& text, const std::string& file, Points points_asked, std::uint64_t seed) {
  CAPTURE(file);
  const std::size_t points = points_asked.all;
  project::Project swept = varied(text, file, seed);
  const std::vector<std::string> results = columns_of(swept);
  project::Variants variants(std::move(swept), results);
  const std::size_t inputs = variants.inputs();
  std::vector<std::vector<double>> in(inputs, std::vector<double>(points)),
      out(variants.outputs(), std::vector<double>(points));
  std::vector<const double*> given;
  std::vector<double*> taken;
  for (std::size_t k = 0; k < inputs; ++k) {
    for (std::size_t i = 0; i < points; ++i) in[k][i] = value_of(variants.axes()[k], i, sweep::uniform(seed + 1, i, k));
    given.push_back(in[k].data());
  }
  for (std::vector<double>& column : out) taken.push_back(column.data());
  variants.evaluate(given, taken, points);
  for (std::size_t i = 0; i < points; ++i) {
    project::Project machine = varied(text, file, seed);
    const auto axes = project::swept_inputs(machine);
    std::vector<Issue> issues;
    for (std::size_t k = 0; k < inputs; ++k) project::set_input(machine, axes[k], in[k][i], issues);
    const bool as_run = i < points_asked.as_run;
    if (issues.empty())
      project::solve(machine, issues, as_run ? project::Wanted{} : numbers_alone(machine, variants.columns()));
    for (std::size_t k = 0; k < variants.outputs(); ++k) {
      const project::SweptResult& column = variants.columns()[k];
      const double here = alone(machine, column, has_errors(issues));
      CHECK_MESSAGE(same(out[k][i], here), column.text, " at point ", i, ": ", out[k][i], " and ", here);
      if (!same(out[k][i], here)) return;
    }
    if (has_errors(issues)) continue;
    const account::Modes modes = project::modes(machine);
    CHECK_MESSAGE(governing_in(variants.columns(), modes, out, i) == governing_of(modes), "at point ", i);
  }
}

/// A machine of many steps, or whose sizes are searched, takes tenths of a second where no size passes.
std::size_t fewer_where_slow(std::size_t points, const std::string& text) {
  std::size_t steps = 0;
  for (std::size_t at = text.find("calculator = "); at != std::string::npos; at = text.find("calculator = ", at + 1))
    ++steps;
  const bool is_searched = text.find("\"?\"") != std::string::npos;
  return steps > 12 || (is_searched && !test::in_full()) ? std::max<std::size_t>(test::in_full() ? 3 : 1, points / 8)
                                                         : points;
}

/// The examples of which `taken(name, text)` says that this run covers them.
template <class Taken>
void compare_examples(Points points, std::uint64_t seed, const Taken& taken) {
  for (const auto& entry : fs::directory_iterator(LOADPATH_ROOT "/examples")) {
    std::string text;
    const fs::path file = entry.path() / "project.toml";
    if (!fs::exists(file)) continue;
    REQUIRE(toml::read_file(file.string(), text));
    if (!taken(entry.path().filename().string(), text)) continue;
    compare(text, file.string(), {fewer_where_slow(points.all, text), points.as_run}, seed);
  }
}

}  // namespace

TEST_SUITE("sweeps and machines of their own" * test::by_element) {
  TEST_CASE("every calculator with its example, some numbers varied") {
    for (const Calculator* calculator : test::calculators_taken()) {
      for (int seed = 1; seed <= (test::sanitized ? 1 : 2); ++seed)
        compare(calculator->example, calculator->id, {5}, static_cast<std::uint64_t>(seed));
    }
  }

  // Without sanitizers more points of each are compared below.
  TEST_CASE("every example, some numbers varied" * doctest::skip(!test::sanitized)) {
    compare_examples({1}, 3, [](const std::string&, const std::string& text) {
      return test::takes(test::elements_of_project(text).front());
    });
  }
}

TEST_SUITE("two hundred points of every example" * test::by_example * test::takes_share) {
  TEST_CASE("a point of a sweep equals its machine solved alone" * doctest::skip(test::sanitized)) {
    const auto points = static_cast<std::size_t>(test::tries(200, 5));
    compare_examples({points, 3}, 4, [](const std::string& name, const std::string&) { return test::takes(name); });
  }
}
