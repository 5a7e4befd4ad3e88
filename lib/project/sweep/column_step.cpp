#include "lib/project/sweep/column_step.hpp"

#include "lib/project/accept.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace loadpath::project {

namespace {

using account::State;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// An input that has another value at every point.
struct Fed {
  std::string path;  // full
  const FieldInfo* field;
  const Expression* expression = nullptr;  // null: an input of the sweep
  std::size_t offset = 0;                  // in the record
  bool is_open = false;                    // of a record of another step, which leaves it out
  std::vector<double> si = {};
};

/// A number of the result.
struct Read {
  std::string path;  // full
  const FieldInfo* field;
  std::size_t offset = 0;
  bool is_row = false;  // a check or a limit that is asked for
  bool is_wanted = false;
  std::vector<double> si = {};
};

/// A mode, and which of the numbers that are read judge it.
struct Judging {
  std::size_t mode;
  std::vector<std::size_t> rows = {};
  Fold::Unjudged unjudged = {};
};

std::string head_of(std::string_view path) { return std::string(path.substr(0, path.find_first_of(".["))); }

/// Whether a number of a record lies at a fixed place in it.
bool is_fixed(std::span<const FieldInfo> fields, std::string_view path) {
  const FieldInfo* const head = find_field(fields, head_of(path));
  const FieldInfo* const field = find_field_at(fields, path);
  return head != nullptr && head->type != FieldInfo::Type::list && field != nullptr && field->address != nullptr;
}

std::size_t offset_in(const Record& record, const Leaf& leaf) {
  const char* const start = static_cast<const char*>(record.data.get());
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) - start);
}

bool acts(double si) { return !std::isnan(si) && si != 0.0; }

}  // namespace

const double* PointColumns::of(const std::string& path) {
  const auto known = values.find(path);
  if (known != values.end()) return known->second.data();
  const auto constant = constants.find(path);
  const double same = constant == constants.end() ? nan : constant->second;
  return values.emplace(path, std::vector<double>(count, same)).first->second.data();
}

struct ColumnStep::Parts {
  CalculatorStep& step;
  const Calculator& calculator;
  Record record, result;
  std::vector<Fed> fed;
  std::vector<Read> read;
  std::vector<char> rules;  // of each whether what varies can break it
  std::vector<Judging> judging;
  std::vector<InputColumn> in;
  std::vector<ResultColumn> out;
  std::vector<std::vector<Applies>> applies;  // of each mode, point by point
  std::vector<Applies*> applies_at;
  Fold fold;
  bool is_loaded = false;  // whatever varies
  bool is_load_told = false;

  explicit Parts(CalculatorStep& s)
      : step(s),
        calculator(*s.input().calculator),
        record(s.input().reading.record.clone()),
        result(*calculator.result) {}

  bool lay_out(const std::set<std::string>& wanted);
  [[nodiscard]] bool is_plain() const;
  bool add_fed();
  bool add_input(Fed input, const std::string& path);
  bool add_values_of_rows();
  bool add_read(const std::set<std::string>& wanted);
  [[nodiscard]] bool is_fed(std::string_view field) const;
  void add_rules();
  void add_judging();
  void look_for_loads();
  void feed(PointColumns& points);
  void run(PointColumns& points);
  void check_inputs(PointColumns& points);
  void judge(const PointColumns& points, std::vector<ModeColumns>& modes);
  void leave_unloaded(PointColumns& points) const;
  void fold_rows(const Judging& judged, std::size_t n);
};

bool ColumnStep::Parts::lay_out(const std::set<std::string>& wanted) {
  if (!is_plain() || !add_fed() || !add_values_of_rows() || !add_read(wanted)) return false;
  add_rules();
  add_judging();
  look_for_loads();
  return true;
}

/// Neither positions nor searches, nothing taken whole, nothing that acts and is not taken.
bool ColumnStep::Parts::is_plain() const {
  const Reading& reading = step.input().reading;
  return step.axis() == nullptr && step.searches().empty() && reading.taken.empty() && !step.leaves_loads() &&
         !step.account().results.empty();
}

bool ColumnStep::Parts::is_fed(std::string_view field) const {
  return std::any_of(fed.begin(), fed.end(),
                     [&](const Fed& f) { return std::string_view(f.path).substr(step.name().size() + 1) == field; });
}

bool ColumnStep::Parts::add_input(Fed input, const std::string& path) {
  if (input.field->is_factor || !is_fixed(calculator.input->fields, path)) return false;
  const Leaf leaf = find_leaf(record, path);
  const Value* const now = step.value(path);
  if (now != nullptr && !now->si.empty()) leaf.set(now->si[0]);  // what asks for checks has a value
  input.offset = offset_in(record, leaf);
  fed.push_back(std::move(input));
  return true;
}

bool ColumnStep::Parts::add_fed() {
  const Reading& reading = step.input().reading;
  for (const Varied& varied : reading.varied) {
    if (!varied.leaf || !varied.words.empty() ||
        !add_input({step.name() + "." + varied.path, varied.leaf.field}, varied.path))
      return false;
  }
  for (const Operand& operand : reading.operands) {
    if (!add_input({step.name() + "." + operand.path, operand.leaf.field, &operand.expression}, operand.path))
      return false;
    const Value* const now = step.value(operand.path);
    fed.back().is_open = operand.may_lack && (now == nullptr || std::isnan(now->si[0]));
  }
  return true;
}

/// Values of rows, where no size that they are asked at varies or follows from them.
bool ColumnStep::Parts::add_values_of_rows() {
  double size = nan;
  for (const Provided& provided : step.provided()) {
    if (provided.row.empty()) return false;  // what comes along with loads
    for (const std::string& key : listed_keys(provided.field->provider.size)) {
      const Leaf leaf = find_leaf(record, key);
      if (!leaf || is_fed(key)) return false;
      if (std::isnan(size)) size = leaf.get();
    }
  }
  for (const Provided& provided : step.provided()) {
    const double si = look_up(provided, size).si;
    if (std::isnan(si)) return false;
    find_leaf(record, provided.path).set(si);
  }
  return true;
}

/// Checks and limits that are asked for, and what others refer to. Lists must be empty, or judge nothing.
bool ColumnStep::Parts::add_read(const std::set<std::string>& wanted) {
  std::set<std::string> left;
  for (const std::string& path : wanted) {
    if (path.starts_with(step.name() + ".") &&
        find_field_at(calculator.result->fields, path.substr(step.name().size() + 1)))
      left.insert(path);
  }
  for (const account::Verdict& row : step.account().verdicts) {
    if (row.symbol.find_first_of(".[") != std::string::npos) return false;
  }
  for (const FieldInfo& field : calculator.result->fields) {
    const std::string path = step.name() + "." + field.key;
    const bool judges = (field.role == Role::check || field.role == Role::limit) && field.is_leaf();
    const bool is_asked = step.is_asked(field, record);  // else it has no value, whatever the calculator says
    const bool is_row = judges && is_asked;
    const bool is_wanted = left.erase(path) != 0 && is_asked;
    if (!is_row && !is_wanted) continue;
    if (!is_fixed(calculator.result->fields, field.key)) return false;
    read.push_back({path, &field, offset_in(result, find_leaf(result, field.key)), is_row, is_wanted});
  }
  for (const std::string& path : left) {  // of groups
    const std::string within = path.substr(step.name().size() + 1);
    if (!is_fixed(calculator.result->fields, within)) return false;
    const Leaf leaf = find_leaf(result, within);
    read.push_back({path, leaf.field, offset_in(result, leaf), false, true});
  }
  return true;
}

void ColumnStep::Parts::add_rules() {
  rules.assign(calculator.rules.size(), 0);
  for (std::size_t rule = 0; rule < calculator.rules.size(); ++rule) {
    if (calculator.rules[rule].only_warns) continue;
    const auto fields = listed_keys(calculator.rules[rule].fields);
    const bool concerned = std::any_of(fed.begin(), fed.end(), [&](const Fed& f) {
      const std::string head = head_of(std::string_view(f.path).substr(step.name().size() + 1));
      return fields.empty() || std::find(fields.begin(), fields.end(), head) != fields.end();
    });
    rules[rule] = static_cast<char>(concerned);
  }
}

void ColumnStep::Parts::add_judging() {
  for (std::size_t k = 0; k < calculator.modes.size(); ++k) {
    Judging judged{k};
    for (const std::string& key : listed_keys(calculator.modes[k].checks)) {
      const FieldInfo* const field = find_field(calculator.result->fields, key);
      const bool checks = field != nullptr && field->role == Role::check;
      judged.unjudged.needs_checks = judged.unjudged.needs_checks || checks;
      if (checks && *field->asked_by != '\0' && !step.is_asked(*field, record)) judged.unjudged.never = true;
      for (std::size_t i = 0; i < read.size(); ++i) {
        if (read[i].is_row && names_row(key, read[i].field->key)) judged.rows.push_back(i);
      }
    }
    for (const Applies when : {Applies::no, Applies::unseen, Applies::yes}) {
      const State state = state_of(step, calculator.modes[k], when, std::nullopt, false);
      const bool accepted = is_accepted(step.input(), calculator.modes[k].id, state);
      judged.unjudged.state[static_cast<std::size_t>(when)] = static_cast<double>(accepted ? State::accepted : state);
    }
    judging.push_back(std::move(judged));
  }
}

void ColumnStep::Parts::look_for_loads() {
  for_each_leaf(record, [&](const std::string& path, const Leaf& leaf) {
    if (!leaf.field->is_load) return;
    is_load_told = is_load_told || step.input().reading.typed.contains(path);
    if (!is_fed(path) && (leaf.field->get == nullptr || acts(leaf.get()))) is_loaded = true;
  });
}

void ColumnStep::Parts::feed(PointColumns& points) {
  in.clear();
  for (Fed& input : fed) {
    input.si.resize(points.count);
    if (input.expression == nullptr) {
      input.si = points.values.find(input.path)->second;
    } else if (!input.expression->evaluate([&](const std::string& path) { return points.of(path); }, input.si)) {
      std::fill(points.is_other.begin(), points.is_other.end(), char{1});
    }
    if (input.is_open || !all_within(input.field->bounds, input.si)) {
      for (std::size_t i = 0; i < points.count; ++i) {
        const bool known = !std::isnan(input.si[i]);
        if (known == input.is_open || (known && !input.field->bounds.holds(input.si[i]))) points.is_other[i] = 1;
      }
    }
    if (!input.is_open) in.push_back({input.offset, input.si.data()});
    if (input.expression != nullptr) points.values[input.path] = input.si;
  }
}

/// Where every load is zero.
void ColumnStep::Parts::leave_unloaded(PointColumns& points) const {
  if (is_loaded || !is_load_told) return;
  if (std::any_of(fed.begin(), fed.end(), [](const Fed& f) { return f.field->is_load && all_act(f.si); })) return;
  for (std::size_t row = 0; row < points.count; ++row) {
    const auto loads = [&](const Fed& f) { return f.field->is_load && acts(f.si[row]); };
    if (std::none_of(fed.begin(), fed.end(), loads)) points.is_other[row] = 1;
  }
}

/// Rules, loads that are all zero, and which modes concern the part.
void ColumnStep::Parts::check_inputs(PointColumns& points) {
  leave_unloaded(points);
  applies.resize(calculator.modes.size());
  applies_at.clear();
  for (std::vector<Applies>& of_mode : applies) {
    of_mode.assign(points.count, Applies::no);
    applies_at.push_back(of_mode.data());
  }
  calculator.survey(record.data.get(), in, rules, applies_at, points.count, points.is_other.data());
}

void ColumnStep::Parts::run(PointColumns& points) {
  out.clear();
  for (Read& number : read) {
    number.si.resize(points.count);
    out.push_back({number.offset, number.si.data()});
  }
  calculator.sweep(record.data.get(), in, out, points.count);
  for (Read& number : read) {
    if (!sweep::all_finite(number.si)) {
      for (std::size_t i = 0; i < points.count; ++i) {
        if (std::isinf(number.si[i]) && !number.field->infinite) number.si[i] = nan;
        if (number.is_row && std::isnan(number.si[i]) && !number.field->where_set) points.is_other[i] = 1;
      }
    }
    if (number.is_wanted) points.values[number.path] = number.si;
  }
}

void ColumnStep::Parts::fold_rows(const Judging& judged, std::size_t n) {
  fold.clear(n);
  for (const std::size_t which : judged.rows) {
    const FieldInfo& field = *read[which].field;
    if (field.role == Role::check)
      fold.take_check(read[which].si);
    else
      fold.take_limit(field.bounds, field.is_criterion, read[which].si);
  }
}

void ColumnStep::Parts::judge(const PointColumns& points, std::vector<ModeColumns>& modes) {
  modes.resize(calculator.modes.size());
  for (const Judging& judged : judging) {
    if (judged.rows.empty()) {
      leave_mode(applies[judged.mode], judged.unjudged, modes[judged.mode]);
    } else {
      fold_rows(judged, points.count);
      fold.judge(applies[judged.mode], judged.unjudged, modes[judged.mode]);
    }
  }
}

ColumnStep::ColumnStep(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ColumnStep::~ColumnStep() = default;

std::unique_ptr<ColumnStep> ColumnStep::of(CalculatorStep& step, const std::set<std::string>& wanted) {
  auto parts = std::make_unique<Parts>(step);
  if (!parts->lay_out(wanted)) return nullptr;
  return std::unique_ptr<ColumnStep>(new ColumnStep(std::move(parts)));
}

void ColumnStep::evaluate(PointColumns& points, std::vector<ModeColumns>& modes) {
  parts_->feed(points);
  parts_->check_inputs(points);
  parts_->run(points);
  parts_->judge(points, modes);
}

}  // namespace loadpath::project
