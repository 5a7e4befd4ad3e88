#include "lib/project/step.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace loadpath::project {

std::vector<std::string> Step::companions_of(const std::string&) const { return {}; }

const FieldInfo* Step::field(const std::string& path) const {
  const Calculator& calculator = *input_.calculator;
  for (const RecordType* type : {calculator.result, calculator.input}) {
    if (type == nullptr) continue;
    if (const FieldInfo* field = find_field_at(type->fields, path)) return field;
  }
  return nullptr;
}

namespace {

/// "pulleys[3].R": element 3 of a list whose elements have names, "pulleys.pump.R"; nothing for any other path.
const Entry* numbered_entry(const std::vector<Entry>& entries, std::string_view path) {
  const std::size_t open = path.find('['), close = path.find("].", open);
  if (close == std::string_view::npos) return nullptr;
  std::size_t left = 0;
  std::from_chars(path.data() + open + 1, path.data() + close, left);
  const std::string list = std::string(path.substr(0, open)) + ".";
  std::string element;  // "pulleys.pump": an open input of an element has no entry, but no element is without any
  for (const Entry& e : entries) {
    if (!e.path.starts_with(list)) continue;
    const std::string here = e.path.substr(0, e.path.find('.', list.size()));
    if (here != element) {
      if (left == 0) return nullptr;
      element = here;
      --left;
    }
    if (left == 0 && e.path == element + std::string(path.substr(close + 1))) return &e;
  }
  return nullptr;
}

}  // namespace

const Value* Step::value(const std::string& path) const {
  for (const auto* entries : {&account_.results, &account_.inputs}) {
    const auto same = std::find_if(entries->begin(), entries->end(), [&](const Entry& e) { return e.path == path; });
    const Entry* found = same == entries->end() ? numbered_entry(*entries, path) : &*same;
    if (found != nullptr && !found->values().si.empty()) return &found->values();
  }
  return nullptr;
}

void Step::solve_without(const std::set<std::string>&, const Known&) {}

std::optional<Value> Step::value_beforehand(const std::string&, bool, const Beforehand&) const { return std::nullopt; }

namespace {

void add_members(std::span<const FieldInfo> fields, const std::string& of, const std::string& prefix,
                 std::vector<Member>& members) {
  for (const FieldInfo& field : fields) {
    const std::string key = prefix + field.key;
    if (field.type == FieldInfo::Type::group) add_members(field.fields, of, key + ".", members);
    if (field.is_leaf()) members.push_back({key, std::string(of).append(".").append(key), field.is_word()});
  }
}

/// Whether the path ends in the list itself, not in one of its elements.
bool is_whole_list(const FieldInfo& field, const std::string& path) {
  return field.type == FieldInfo::Type::list && (path == field.key || path.ends_with("." + std::string(field.key)));
}

}  // namespace

std::vector<Member> Step::members(const std::string& path) const {
  const FieldInfo* const record = field(path);
  std::vector<Member> members;
  if (record != nullptr && record->has_fields() && !is_whole_list(*record, path))
    add_members(record->fields, path, "", members);
  return members;
}

bool Step::has_values(const std::string& path) const {
  const auto all = members(path);
  return std::any_of(all.begin(), all.end(), [&](const Member& member) {
    const Value* const known = member.is_word ? nullptr : value(member.path);
    return known != nullptr &&
           std::any_of(known->si.begin(), known->si.end(), [](double si) { return !std::isnan(si); });
  });
}

std::string Step::word(const std::string& path) const {
  if (const auto found = rows_found_.find(path); found != rows_found_.end()) return found->second;
  if (const auto named = input_.rows.find(path); named != input_.rows.end()) return named->second.text;
  for (const auto* entries : {&account_.results, &account_.inputs}) {
    const auto same = std::find_if(entries->begin(), entries->end(), [&](const Entry& e) { return e.path == path; });
    const Entry* found = same == entries->end() ? numbered_entry(*entries, path) : &*same;
    if (found != nullptr && !found->word.empty()) return found->word;
  }
  return {};
}

std::vector<std::pair<std::string, const Entry*>> Step::within(const std::string& path) const {
  std::vector<std::pair<std::string, const Entry*>> found;
  for (const auto* entries : {&account_.results, &account_.inputs}) {
    for (const Entry& entry : *entries) {
      const bool inside = entry.path.size() > path.size() && entry.path.starts_with(path) &&
                          (entry.path[path.size()] == '.' || entry.path[path.size()] == '[');
      if (inside) found.emplace_back(entry.path.substr(path.size()), &entry);
    }
    if (!found.empty()) break;
  }
  return found;
}

Form form_of(const Step& step, const std::string& path) {
  if (step.input().rows.contains(path)) return Form::row;
  const FieldInfo* const field = step.field(path);
  if (field != nullptr && field->is_word()) return Form::word;
  if (field != nullptr && is_whole_list(*field, path)) return Form::list;
  if (!step.members(path).empty()) return Form::record;
  return step.signature(path) ? Form::number : Form::nothing;
}

Issue issue_at(const StepInput& input, const std::string& path, Message message, Message hint) {
  const auto& typed = input.reading.typed;
  std::string nearest_typed = path;
  while (typed.count(nearest_typed) == 0 && !nearest_typed.empty()) {
    const std::size_t end = nearest_typed.find_last_of(".[");
    nearest_typed.resize(end == std::string::npos ? 0 : end);
  }
  const Place& place = nearest_typed.empty() ? input.place : typed.at(nearest_typed).place;
  return {place, path.empty() ? input.name : input.name + "." + path, std::move(message), std::move(hint),
          Severity::error};
}

namespace {

/// A load with a significant sign takes neither a magnitude, nor a force whose sign has another meaning.
FieldFault lost_sign(const Operand& operand, const Declared& declared) {
  if (!operand.leaf.field->signed_load) return {};
  const std::string_view part = operand.expression.unsigned_part(declared);
  if (part.empty()) return {};
  if (part.find('.') != std::string_view::npos)
    return {operand.path,
            say("the sign of '{1}' matters, and that of '{2}' does not distinguish tension from compression",
                operand.path, part),
            say("refer to the N of a link, or give the sign: -{1} for compression, 0 N + {1} for tension", part)};
  return {operand.path, say("the sign of '{1}' matters, and '{2}' is a magnitude", operand.path, part),
          say("take the series itself, its minimum, min(...), or give the sign: -peak(...)")};
}

/// An angle requires its unit, as in a typed value. A value from other steps may have lost its angle in a ratio of
/// lengths.
FieldFault lost_angle(const Operand& operand, const Dimension& given) {
  const Dimension& wanted = operand.leaf.field->dimension;
  if (given == wanted || wanted != Dimension::of(0, 0, 0, 0, 1) || !operand.expression.references().empty()) return {};
  return {operand.path,
          say("'{1}' takes a value of {2}, but this expression is one of {3}", operand.path, name_of(wanted),
              name_of(given)),
          say("write its unit: deg or rad")};
}

/// The axis of one operand after its dimension has been compared with that of its field.
const Axis* check_operand(const Operand& operand, const std::string& step, const Declared& declared,
                          std::vector<Issue>& issues) {
  const std::string key = step + "." + operand.path;
  const auto signature = operand.expression.check(declared);
  if (!signature) {
    const Fault& fault = signature.fault();
    if (fault.message.empty()) return nullptr;
    issues.push_back({place_in(operand.place, operand.text, fault.at, fault.length), key, fault.message, fault.hint,
                      Severity::error});
    return nullptr;
  }
  const Dimension& wanted = operand.leaf.field->dimension;
  if (signature->dimension.without_angle() != wanted.without_angle()) {
    issues.push_back({place_in(operand.place, operand.text, 0, operand.text.size()),
                      key,
                      say("'{1}' is a {2}, but this expression is a {3}", operand.path, name_of(wanted),
                          name_of(signature->dimension)),
                      {},
                      Severity::error});
    return nullptr;
  }
  for (const FieldFault& fault : {lost_sign(operand, declared), lost_angle(operand, signature->dimension)}) {
    if (fault.message.empty()) continue;
    issues.push_back({place_in(operand.place, operand.text, 0, operand.text.size()), key, fault.message, fault.hint,
                      Severity::error});
    return nullptr;
  }
  return signature->axis;
}

}  // namespace

const Axis* check_operands(const Reading& reading, const std::string& step, bool lifted, const Declared& declared,
                           std::vector<Issue>& issues) {
  const Axis* shared = nullptr;  // common axis of the lifted operands
  const Axis* whole = nullptr;   // axis of the entire series taken
  const auto take = [&](const Axis* axis, const std::string& path, const Place& start, const std::string& text,
                        bool takes_whole = false, bool of_record = false) {
    if (axis == nullptr) return;
    const Axis*& other = takes_whole ? whole : shared;
    const auto refuse = [&](Message message, Message hint) {
      issues.push_back({place_in(start, text, 0, text.size()), step + "." + path, std::move(message), std::move(hint),
                        Severity::error});
    };
    if (!lifted && !takes_whole)
      refuse(say("'{1}' takes one value, and this is a series over {2}", path, axis->name()),
             of_record
                 ? say("its record has a series, and this calculator takes one value: type {1}, or use a calculator "
                       "that goes through the cycle",
                       path)
                 : say("reduce it with peak, max, min, mean, rms or at"));
    else if (other != nullptr && other != axis)
      refuse(say("this is a series over {1}, and another input is one over {2}", axis->name(), other->name()),
             say("reduce one of them with peak, max, min, mean, rms or at"));
    else
      other = axis;
  };
  for (const Operand& operand : reading.operands)
    take(check_operand(operand, step, declared, issues), operand.path, operand.place, operand.text,
         operand.leaf.field->takes_whole(), operand.of_record);
  for (const Taken& taken : reading.taken) take(taken.axis, taken.path, taken.place, taken.source);
  return shared;
}

namespace {

/// Rounds counts to integers; an issue if one is not an integer.
std::optional<Issue> broken_count(const Operand& operand, const std::string& step, Value& value) {
  constexpr double rounding = 1e-9;
  for (double& n : value.si) {
    const double whole = std::round(n);
    if (std::abs(n - whole) > rounding * std::max(1.0, std::abs(n)))
      return Issue{place_in(operand.place, operand.text, 0, operand.text.size()), step + "." + operand.path,
                   say("{1} = {2} is not an integer", operand.path, format_number(n)),
                   say("a count is used as given, without rounding"), Severity::error};
    if (!std::isnan(n)) n = whole;
  }
  return std::nullopt;
}

/// Warnings and errors of a literal, for values that were typed as an expression.
std::optional<Issue> doubt_of(const Operand& operand, const std::string& step, const std::vector<double>& si) {
  const FieldInfo& field = *operand.leaf.field;
  const auto issue = [&](Message message, Message hint, Severity severity) {
    return Issue{place_in(operand.place, operand.text, 0, operand.text.size()), step + "." + operand.path,
                 std::move(message), std::move(hint), severity};
  };
  if (field.type != FieldInfo::Type::quantity || operand.of_record) return std::nullopt;
  for (const double x : si) {
    if (std::isfinite(x) && is_out_of_proportion(x))
      return issue(out_of_proportion(operand.path, field, x), say("check the unit and the power of ten"),
                   Severity::error);
  }
  const auto rare =
      std::find_if(si.begin(), si.end(), [&](double x) { return !std::isnan(x) && !field.plausible.holds(x); });
  if (rare == si.end()) return std::nullopt;
  return issue(unusual(operand.path, field, *rare), unusual_hint(field), Severity::warning);
}

}  // namespace

std::optional<Value> evaluate_operand(const Operand& operand, const std::string& step, const Known& known,
                                      std::vector<Issue>& issues) {
  const FieldInfo& field = *operand.leaf.field;
  Value value = operand.expression.evaluate(known.value);
  if (field.type == FieldInfo::Type::count) {
    if (auto issue = broken_count(operand, step, value)) {
      issues.push_back(std::move(*issue));
      return std::nullopt;
    }
  }
  const auto refused = std::find_if(value.si.begin(), value.si.end(),
                                    [&](double x) { return !std::isnan(x) && !field.bounds.holds(x); });
  if (refused == value.si.end()) {
    auto issue = doubt_of(operand, step, value.si);
    const bool wrong = issue && issue->severity == Severity::error;
    if (issue) issues.push_back(std::move(*issue));
    return wrong ? std::nullopt : std::optional(std::move(value));
  }
  issues.push_back({place_in(operand.place, operand.text, 0, operand.text.size()),
                    step + "." + operand.path,
                    say("{1} = {2}: {3}", operand.path, format_quantity(*refused, field.unit), bounds_message(field)),
                    {},
                    Severity::error});
  return std::nullopt;
}

std::vector<Entry> input_entries(const Record& record,
                                 const std::function<Origin(const std::string&, const Leaf&)>& origin) {
  std::vector<Entry> entries;
  for_each_leaf(record, [&](const std::string& path, const Leaf& leaf) {
    const FieldInfo& field = *leaf.field;
    Entry entry{path, field.doc, field.unit, Role::input, {{field.dimension, nullptr}, {}}, origin(path, leaf), ""};
    const bool is_text = field.type == FieldInfo::Type::name || field.type == FieldInfo::Type::formula;
    if (is_text) entry.word = field.text(leaf.owner);
    if (field.type == FieldInfo::Type::choice) entry.word = word_of(leaf);
    entry.is_factor = field.is_factor;
    if (field.get != nullptr) entry.value.si = {leaf.get()};
    if (const Value* const series = field.takes_whole() ? field.series(leaf.owner) : nullptr) {
      entry.value = {series->signature, {}, series->rounding};
      entry.series = std::shared_ptr<const Value>(record.data, series);  // as long as the record, which has it
    }
    const bool unnamed = (is_text || field.type == FieldInfo::Type::choice) && entry.word.empty();
    const bool open = field.type == FieldInfo::Type::quantity && entry.origin.text.empty();
    if (!unnamed && !open) entries.push_back(std::move(entry));
  });
  return entries;
}

Origin plain_origin(const Reading& reading, const std::string& path, const Leaf& leaf) {
  const auto typed = reading.typed.find(path);
  if (typed != reading.typed.end()) {
    if (typed->second.of_point) return {say("given, value of this point of the sweep"), {}, false};
    if (!typed->second.shared.empty()) return {say("given as {1}", typed->second.shared), {}, false};
    if (typed->second.mean_of_uncertain) return {say("given, middle value"), {}, false};
    const bool quantity = leaf.field->type == FieldInfo::Type::quantity && !typed->second.text.empty();
    const bool as_shown =
        !quantity || pretty_unit(typed->second.text) == format_quantity(leaf.get(), leaf.field->unit, 5);
    return {as_shown ? say("given") : say("given as {1}", typed->second.text), {}, false};
  }
  const bool open = leaf.field->type == FieldInfo::Type::quantity && std::isnan(leaf.get());
  return {open ? Message{} : say("default"), {}, false, false, !open};
}

}  // namespace loadpath::project
