// What was typed beside a row of a table, a record, or a strength that bounds it: another part is refused; what is
// bolder than they say holds back the modes that it decides, until the user says why (lib/project/run/beside.hpp).
#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/because.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::project {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Whether the user typed it: a record may have filled it.
bool is_typed(const Reading& reading, const std::string& path) {
  const auto fills = [&](const auto& taken) { return taken.of_record && taken.path == path; };
  return reading.typed.contains(path) && std::none_of(reading.operands.begin(), reading.operands.end(), fills) &&
         std::none_of(reading.taken.begin(), reading.taken.end(), fills);
}

/// The largest value of a column, which is that of the least size; NaN where the row has none.
double largest_in_row(const table::Entry& row, std::string_view column) {
  if (const auto same = table::property(row, column)) return same->si;
  double most = unknown;
  for (const table::SizedProperty& at : table::values_by_size(row, column)) most = std::fmax(most, at.value.si);
  return most;
}

/// Whether a typed value may be above what a row has at one size and below it at another: not where the row has more
/// at every size.
bool hangs_on_size(const table::Entry& row, std::string_view column, double part, double typed) {
  double least = std::numeric_limits<double>::infinity();
  for (const table::SizedProperty& at : table::values_by_size(row, column)) least = std::fmin(least, at.value.si);
  return !(typed <= part * least);
}

/// The value of largest magnitude of those that are known.
double largest_size(const Value& value) {
  double most = unknown;
  for (const double x : value.si) {
    if (!std::isnan(x) && !(std::abs(x) <= std::abs(most))) most = x;
  }
  return most;
}

Message shown(const FieldInfo& field, double si) {
  if (field.type == FieldInfo::Type::choice) return say("{1}", field.choices[static_cast<std::size_t>(si)].key);
  return say("{1}", field.type == FieldInfo::Type::count ? format_number(si) : format_quantity(si, field.unit, 5));
}

bool is_comparable(const FieldInfo& field) {
  return field.get != nullptr && !field.takes_whole() && (field.is_number() || field.type == FieldInfo::Type::choice);
}

}  // namespace

/// The size that a row is asked at, as it came out: an input, or a result.
double Run::size_of(const FieldInfo& field) const {
  double size = table::no_size;
  for (const std::string& key : listed_keys(field.provider.size)) {
    const Leaf given = find_leaf(record_, key);
    if (given && !std::isnan(given.get())) return given.get();
    for (const Column& column : columns_) {
      if (column.path == key) size = largest_size(value_of(column));
    }
  }
  return size;
}

Value Run::value_at(const std::string& path, const Leaf& leaf) const {
  for (const Input& input : inputs_) {
    if (input.path == path) return input.value;
  }
  return {{leaf.field->dimension, nullptr}, {leaf.get()}};
}

/// Typed fields that a row fills as well, and those that stand in place of one that it would fill.
void Run::add_rows_beside(std::vector<Neighbour>& all) const {
  const Reading& reading = step_.input().reading;
  for (const FieldInfo& field : calculator_.input->fields) {
    const Provider& from = field.provider;
    const auto named = rows_.find(from.table);
    if (from.kind != Provider::Kind::table || named == rows_.end() || named->second.text.empty()) continue;
    const auto row = step_.input().tables->find_row(from.table, named->second.text);
    if (!row) continue;
    const Message source = say("the {1} '{2}'", from.table, named->second.text);
    if (field.is_leaf() && is_typed(reading, field.key) && gives(*row, field)) {
      const double size = size_of(field);
      double si = look_up({field.key, &field, named->second.text, {}, *row}, size).si;
      if (std::isnan(si) && std::isnan(size)) si = largest_in_row(*row, from.column);
      all.push_back({field.key, map_leaf(field.key), {{field.dimension, nullptr}, {si}}, source, beside_of(field)});
      const bool is_capacity = all.back().kind == Beside::capacity;
      const double typed = largest_size(value_at(field.key, all.back().leaf));
      all.back().by_size = *from.size != '\0' && (!is_capacity || hangs_on_size(*row, from.column, 1.0, typed));
      all.back().row_of = from.table;
    }
    const Leaf instead = *from.unless == '\0' ? Leaf{} : map_leaf(from.unless);
    if (!instead || from.unless == std::string_view(field.key) || !is_typed(reading, from.unless) ||
        bound_of(from.unless) != nullptr || beside_of(*instead.field) != Beside::capacity)
      continue;
    const double most = largest_in_row(*row, from.column);
    all.push_back({from.unless, instead, {{instead.field->dimension, nullptr}, {most}}, source, Beside::capacity});
  }
}

/// Typed fields that a record has as well.
void Run::add_records_beside(std::vector<Neighbour>& all) const {
  for (const TypedBeside& kept : step_.input().reading.kept) {
    const Leaf leaf = map_leaf(kept.path);
    if (!leaf || !is_comparable(*leaf.field)) continue;
    Value value{{leaf.field->dimension, nullptr}, {unknown}};
    if (kept.is_word) {
      const std::string word = known_.word(kept.source);
      for (std::size_t k = 0; k < leaf.field->choices.size(); ++k) {
        if (word == leaf.field->choices[k].key) value.si = {static_cast<double>(k)};
      }
    } else {
      value = known_(kept.source);
    }
    all.push_back({kept.path, leaf, std::move(value), say("'{1}'", kept.source),
                   kept.is_load ? Beside::demand : beside_of(*leaf.field)});
    all.back().by_size = true;  // at another point the record has another value
  }
}

/// What a material bounds of a field, by its meaning; null: nothing.
const StrengthBound* Run::bound_of(const std::string& path) const {
  for (const Meaning& meaning : calculator_.meanings) {
    const auto keys = listed_keys(meaning.fields);
    if (std::none_of(keys.begin(), keys.end(), [&](const std::string& key) { return names_row(key, path); })) continue;
    const StrengthBound* const bound = strength_bound_of(meaning.what);
    if (bound == nullptr || *meaning.choice == '\0') return bound;
    const Leaf choice = map_leaf(meaning.choice);
    const auto words = listed_keys(meaning.words);
    if (std::find(words.begin(), words.end(), word_of(choice)) != words.end()) return bound;
  }
  return nullptr;
}

/// A strength of the part: of the input, else of the material that the step names.
double Run::strength_of_part(const char* key) const {
  const Leaf own = map_leaf(key);
  const double si = own && own.field->is_number() ? largest_size(value_at(key, own)) : unknown;
  if (!std::isnan(si)) return si;
  const auto named = rows_.find("material");
  if (named == rows_.end() || named->second.text.empty()) return unknown;
  const auto row = step_.input().tables->find_row("material", named->second.text);
  return row ? largest_in_row(*row, key) : unknown;
}

/// Whether at another size, or with another strength of the part, a stress may be on the other side of its bound.
bool Run::may_change(const char* column, double part, double typed) const {
  const Leaf own = map_leaf(column);
  if (!own || std::isnan(largest_size(value_at(column, own)))) return false;  // the largest of the row stands there
  const auto provided = std::find_if(provided_.begin(), provided_.end(), [&](const Provided& p) {
    return p.path == column && p.field->provider.table == std::string_view("material");
  });
  return provided == provided_.end() || hangs_on_size(provided->entry, column, part, typed);
}

/// Typed stresses that the strength of the material bounds.
void Run::add_strengths_beside(std::vector<Neighbour>& all) const {
  const auto named = rows_.find("material");
  const Message of = named == rows_.end() || named->second.text.empty() ? say("the part")
                                                                        : say("the material '{1}'", named->second.text);
  for_each_leaf(record_, [&](const std::string& path, const Leaf& leaf) {
    const StrengthBound* const bound = is_typed(step_.input().reading, path) ? bound_of(path) : nullptr;
    if (bound == nullptr || !is_comparable(*leaf.field)) return;
    const double strength = strength_of_part(bound->column), whole = strength_of_part("R_m");
    const bool lacks = std::isnan(strength);
    if (lacks && std::isnan(whole)) return;
    const double most = lacks ? whole : bound->part * strength;
    all.push_back({path,
                   leaf,
                   {{leaf.field->dimension, nullptr}, {most}},
                   say("{1} of {2}", lacks ? "R_m" : bound->text, of),
                   Beside::capacity});
    const char* const column = lacks ? "R_m" : bound->column;
    const double typed = largest_size(value_at(path, leaf));
    all.back().by_size = may_change(column, lacks ? 1.0 : bound->part, typed);
  });
}

std::vector<Run::Neighbour> Run::neighbours() const {
  std::vector<Neighbour> all;
  add_rows_beside(all);
  add_records_beside(all);
  add_strengths_beside(all);
  std::erase_if(all, [](const Neighbour& beside) { return std::isnan(largest_size(beside.value)); });
  return all;
}

/// The part is that of the row, or of the record: what was typed may not make another one of it.
bool Run::refuse_other_parts(std::vector<Issue>& issues) const {
  const std::size_t before = issues.size();
  for (const Neighbour& beside : neighbours()) {
    if (beside.kind != Beside::identity && beside.kind != Beside::modulus) continue;
    const double typed = largest_size(value_at(beside.path, beside.leaf)), other = largest_size(beside.value);
    const auto text = step_.input().reading.typed.find(beside.path);
    if (std::isnan(typed) || is_equal(beside.kind, typed, other, relative_rounding(text->second.text))) continue;
    const FieldInfo& field = *beside.leaf.field;
    issues.push_back(issue_at(
        step_.input(), beside.path,
        say("{1} = {2} contradicts {3}, which has {4}", beside.path, shown(field, typed), beside.source,
            shown(field, other)),
        beside.row_of.empty()
            ? say("leave out {1}, or what has it", field.key)
            : say("leave out {1}; another part is a row of your own: [tables.{2}s.NAME]", field.key, beside.row_of)));
  }
  return issues.size() == before;
}

/// How a value is bolder than it should be: "R_e = 960 MPa, above 225 MPa of the material 'S235JR'".
Message Run::excess_of(const Neighbour& beside) const {
  const FieldInfo& field = *beside.leaf.field;
  const double typed = largest_size(value_at(beside.path, beside.leaf)), other = largest_size(beside.value);
  return beside.kind == Beside::capacity
             ? say("{1} = {2}, above {3} of {4}", beside.path, shown(field, typed), shown(field, other), beside.source)
             : say("{1} = {2}, below {3} of {4}", beside.path, shown(field, typed), shown(field, other), beside.source);
}

/// Those that are bolder than what stands beside them.
std::vector<Run::Neighbour> Run::bolder_ones() {
  std::vector<Neighbour> bolder;
  for (Neighbour& beside : neighbours()) {
    compared_.push_back(beside.path);
    compared_by_size_ = compared_by_size_ || beside.by_size;
    if (beside.kind == Beside::identity || beside.kind == Beside::modulus) continue;
    const double typed = largest_size(value_at(beside.path, beside.leaf)), other = largest_size(beside.value);
    const std::string& text = step_.input().reading.typed.at(beside.path).text;
    if (std::isnan(typed) || is_equal(beside.kind, typed, other, relative_rounding(text))) continue;
    if (is_bolder(beside.kind, typed, other)) bolder.push_back(std::move(beside));
  }
  return bolder;
}

void Run::set_value(const Neighbour& beside, const Value& value) {
  for (Input& input : inputs_) {
    if (input.path == beside.path) return void(input.value = value);
  }
  beside.leaf.set(largest_size(value));
}

/// The checks and limits that come out otherwise with what stands beside the value.
void Run::mark_decided(const Neighbour& beside, const Bolder& bolder) {
  const std::vector<Column> before = columns_;
  const std::vector<Applies> applied = applies_;
  const Value typed = value_at(beside.path, beside.leaf);
  Value instead = beside.value;
  if (instead.is_series() && instead.signature.axis != axis_)
    instead = {{instead.signature.dimension, nullptr}, {largest_size(instead)}};
  set_value(beside, instead);
  evaluate();
  const auto is_same = [&](const Column& column) {
    const auto after =
        std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.path == column.path; });
    return after != columns_.end() && std::equal(column.si.begin(), column.si.end(), after->si.begin(), after->si.end(),
                                                 [](double x, double y) { return x == y || (x != x && y != y); });
  };
  bool decides = false, changes = false;
  for (const Column& column : before) {
    if (is_same(column)) continue;
    changes = true;
    if (column.field->role != Role::check && column.field->role != Role::limit) continue;
    decides = true;
    bolder_.emplace(column.path, bolder);
  }
  if (changes && !decides && !bolder.wants.empty()) handed_on_.push_back(bolder);
  set_value(beside, typed);
  columns_ = before, applies_ = applied;
}

/// Whether a reason may be about a load that is less than its series (lib/project/references/reductions.hpp).
bool Run::answers_for_reduction(const std::string& path) const {
  const auto& operands = step_.input().reading.operands;
  return std::any_of(operands.begin(), operands.end(), [&](const Operand& o) {
    return o.path == path && !o.of_record && !o.expression.references().empty();
  });
}

void Run::weigh_typed_values(bool tells, std::vector<Issue>& issues) {
  std::set<const Typed*> used;
  std::vector<Neighbour> all = bolder_ones();
  const auto reason_of = [&](const Neighbour& beside) { return reason_for(step_.input(), beside.path); };
  // What holds a mode back is told before what does not.
  std::stable_partition(all.begin(), all.end(), [&](const Neighbour& beside) { return reason_of(beside) == nullptr; });
  for (const Neighbour& beside : all) {
    const Typed* const reason = reason_of(beside);
    const Message excess = excess_of(beside);
    if (reason != nullptr) {
      used.insert(reason);
      reasons_.emplace(beside.path, say("{1}: {2}", excess, reason->text));
    }
    holds_back_ = holds_back_ || (reason == nullptr && !columns_.empty());
    if (columns_.empty() || (reason != nullptr && !tells)) continue;
    mark_decided(beside, reason != nullptr ? Bolder{"", reasons_.at(beside.path)}
                                           : Bolder{"because." + beside.path,
                                                    say("{1}; say why: because.{2} = \"...\"", excess, beside.path)});
  }
  if (!all.empty() && !columns_.empty()) evaluate();
  if (!tells || columns_.empty() || !step_.input().reading.varied.empty()) return;
  for (const auto& [key, reason] : step_.input().because) {
    if (used.contains(&reason) || answers_for_reduction(key)) continue;
    issues.push_back({reason.place, step_.name() + ".because." + key,
                      say("because.{1} is not needed: no row or record says less of {1}", key),
                      say("leave it out; what a mode of failure needs is accept.MODE"), Severity::error});
  }
}

Bolder Run::bolder_in(const std::vector<const account::Verdict*>& rows) const {
  for (const account::Verdict* row : rows) {
    if (const auto found = bolder_.find(row->symbol); found != bolder_.end()) return found->second;
  }
  return {};
}

}  // namespace loadpath::project
