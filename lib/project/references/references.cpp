#include "lib/project/references/references.hpp"

#include "lib/project/read/read_record.hpp"
#include "lib/project/references/paths/result_paths.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::project {

namespace {

using Type = FieldInfo::Type;

/// Whether a field, or the row of a table, takes this form from another step.
bool fits(const FieldInfo* field, Form form) {
  if (field == nullptr || field->is_word()) return form == Form::word || form == Form::row;
  return form == (field->type == Type::list ? Form::list : Form::record);
}

Message noun_of(Form form) {
  switch (form) {
    case Form::number:
      return say("a number");
    case Form::word:
    case Form::row:
      return say("a word");
    case Form::record:
      return say("a record");
    case Form::list:
      return say("a list");
    case Form::nothing:
      break;
  }
  return say("nothing");
}

Message wanted_by(const FieldInfo* field) {
  if (field == nullptr) return say("the name of a row");
  if (field->is_word()) return say("a word");
  return field->type == Type::list ? say("a list") : say("a record");
}

/// "d_1, d_2, L"
void list(std::string& names, std::string_view name) { names += (names.empty() ? "" : ", ") + std::string(name); }

class Settling {
 public:
  Settling(Step& step, const Project& project, std::vector<Issue>& issues)
      : step_(step), reading_(step.input().reading), project_(project), issues_(issues) {}

  void run() {
    const std::vector<Taken> all = std::move(reading_.taken);
    reading_.taken.clear();
    for (const Taken& taken : all) settle(taken);
    take_bodies();
    compare_loads_of_bodies();
    if (refused_ || !reading_.faulty.empty()) return;  // the members of the record are not known
    bool misses = false;
    for (const MissingInput& missing : reading_.missing) {
      if (reading_.typed.count(missing.path) != 0) continue;
      issues_.push_back(issue_of(missing));
      misses = true;
    }
    if (misses) mark_untyped(reading_);
  }

 private:
  /// Required inputs that the records have not filled: reported at the first of them.
  [[nodiscard]] Issue issue_of(const MissingInput& missing) const {
    Issue issue = missing_field(missing, step_.name() + ".");
    if (reading_.records.empty()) return issue;
    const Taken& record = reading_.records.front();
    issue.place = place_in(record.place, record.source, 0, record.source.size());
    issue.message = say("{1}, and '{2}' does not give it", issue.message, record.source);
    const Step* const source = project_.find(split_step(record.source).first);
    const std::string other = source == nullptr ? "" : record_with(*source, record.source, missing.path);
    if (!other.empty()) issue.hint = say("did you mean '={1}'?", other);
    return issue;
  }

  void settle(const Taken& taken) {
    const auto [name, rest] = split_step(taken.source);
    const Step* const source = project_.find(name);
    if (source == nullptr && name == "values") return void(refused_ = true);  // reported at its place
    if (source == nullptr) return refuse(taken, project_.unknown_step(taken.source));
    if (const std::string record = record_for_row(taken, *source, rest); !record.empty()) {
      step_.input().rows.erase(taken.path);
      return fill_from(taken, *source, record);
    }
    const Form form = form_of(*source, rest);
    if (form == Form::nothing) {
      const auto signature = source->signature(rest);
      return refuse(taken, signature ? Fault{} : signature.fault());
    }
    if (!fits(taken.field, form)) {
      return refuse(taken, Fault{0, taken.source.size(),
                                 say("'{1}' takes {2}, and '{3}' is {4}", taken.path, wanted_by(taken.field),
                                     taken.source, noun_of(form)),
                                 form == Form::list ? there_is(elements_of(*source, rest)) : Message{}});
    }
    if (form == Form::record) return fill_from(taken, *source, rest);
    if (form == Form::list && !shares_fields(taken, *source->field(rest))) return;
    reading_.taken.push_back(taken);
    if (form == Form::list) reading_.taken.back().axis = axis_of(taken, *source, rest);
  }

  /// The record that a step hands over in place of a row of a table, section = "=box" or "=box.section"; empty if it
  /// has none.
  static std::string record_for_row(const Taken& taken, const Step& source, const std::string& rest) {
    const RecordType* const result = source.input().calculator->result;
    if (taken.field != nullptr || result == nullptr || (!rest.empty() && rest != taken.path)) return {};
    const FieldInfo* const field = find_field(result->fields, taken.path);
    return field != nullptr && field->is_handed_over ? taken.path : "";
  }

  /// The axis of the series among the values of a list's elements that are taken one by one.
  static const Axis* axis_of(const Taken& taken, const Step& source, const std::string& rest) {
    for (const FieldInfo& field : taken.field->fields) {
      if (field.takes_whole()) continue;
      const auto signature = source.signature(rest + "[1]." + field.key);
      if (signature && signature->axis != nullptr) return signature->axis;
    }
    return nullptr;
  }

  void refuse(const Taken& taken, const Fault& fault) {
    refused_ = true;
    mark_untyped(reading_);
    if (fault.message.empty()) return;  // errors of the other step, already reported
    issues_.push_back({place_in(taken.place, taken.source, fault.at, fault.length), step_.name() + "." + taken.path,
                       fault.message, fault.hint, Severity::error});
  }

  /// Elements of a list are filled by key: each that must be there has to come.
  bool shares_fields(const Taken& taken, const FieldInfo& given) {
    for (const FieldInfo& field : taken.field->fields) {
      const FieldInfo* const same = find_field(given.fields, field.key);
      const bool alike = same != nullptr && same->type == field.type && same->dimension == field.dimension;
      if (field.optional ? same == nullptr || alike : alike) continue;
      refuse(taken, Fault{0,
                          taken.source.size(),
                          say("'{1}' needs {2} of each element, and '{3}' has none like it", taken.path, field.key,
                              taken.source),
                          {}});
      return false;
    }
    return true;
  }

  /// An operand, or a word, for every field that is not typed and that the record has.
  void fill_from(const Taken& taken, const Step& source, const std::string& rest) {
    const bool is_record = taken.field == nullptr || taken.field->type == Type::record;
    const std::string base = is_record ? taken.path.substr(0, taken.path.rfind('.') + 1) : taken.path + ".";
    const std::vector<Member> members = source.members(rest);
    std::string filled, kept;
    for_each_leaf(reading_.record, [&](const std::string& path, const Leaf& leaf) {
      if (!path.starts_with(base) || leaf.field->is_own) return;
      const auto given = std::find_if(members.begin(), members.end(), [&](const Member& member) {
        return member.key == std::string_view(path).substr(base.size()) && is_like(source, member, *leaf.field);
      });
      if (given == members.end()) return;
      if (reading_.typed.count(path) != 0) {
        const FieldInfo* const field = source.field(given->path);
        reading_.kept.push_back(
            {path, source.name() + "." + given->path, given->is_word, field != nullptr && field->is_load});
        return list(kept, given->key);
      }
      fill(taken, path, leaf, {given->key, source.name() + "." + given->path, given->is_word},
           may_be_incomplete(source, *given, path));
      list(filled, given->key);
    });
    if (filled.empty()) {
      const Message repeated = say("'{1}' and '{2}' both give {3}", taken.source, step_.name(), kept);
      const Message unlike = say("'{1}' provides no input of '{2}'", taken.source, step_.name());
      return refuse(taken,
                    Fault{0, taken.source.size(), kept.empty() ? unlike : repeated,
                          kept.empty() ? say("`loadpath describe {1}` lists the inputs", step_.input().calculator->id)
                                       : say("delete here what '{1}' is to provide", taken.source)});
    }
    reading_.records.push_back(taken);
    step_.remark(kept.empty() ? say("taken from {1}: {2}", taken.source, filled)
                              : say("taken from {1}: {2}; given here and not taken: {3}", taken.source, filled, kept));
  }

  /// Dimensions of the component, given with a single load, "=gears.gear_1.T": root circle, rim.
  void take_bodies() {
    std::vector<Taken> singles;  // path: of the load
    for (const Operand& operand : reading_.operands) {
      const std::string record = operand.of_record || !operand.leaf.field->is_load ? "" : record_behind(operand);
      if (!record.empty()) singles.push_back({operand.path, nullptr, record, operand.place, true});
    }
    for (const Taken& single : singles) {
      if (!is_fastened_elsewhere(single.source)) take_body(single);
    }
  }

  /// Whether a shaft has the component of the record on one seat, and fastens another one with this step: the torque is
  /// that of the component, the hub is not.
  [[nodiscard]] bool is_fastened_elsewhere(const std::string& record) const {
    return std::any_of(project_.steps.begin(), project_.steps.end(), [&](const auto& shaft) {
      std::set<std::string> own, of_record;  // "seats[2]."
      const Reading& reading = shaft->input().reading;
      for (const auto* all : {&reading.taken, &reading.records}) {
        for (const Taken& taken : *all) {
          if (taken.source == step_.name() + ".connection") own.insert(prefix_of(taken.path));
          if (taken.source == record) of_record.insert(prefix_of(taken.path));
        }
      }
      for (const Operand& operand : reading.operands) {
        for (const auto& reference : operand.expression.references())
          if (reference.path.starts_with(record + ".")) of_record.insert(prefix_of(operand.path));
      }
      const auto is_other = [&](const std::string& seat) { return !of_record.contains(seat); };
      return !of_record.empty() && !own.empty() && std::all_of(own.begin(), own.end(), is_other);
    });
  }

  /// Once, though several loads are taken singly.
  void keep(TypedOverride typed) {
    const auto same = [&](const TypedOverride& kept) { return kept.path == typed.path && kept.source == typed.source; };
    if (std::none_of(reading_.kept.begin(), reading_.kept.end(), same)) reading_.kept.push_back(std::move(typed));
  }

  void take_body(const Taken& taken) {
    const std::string base = taken.path.substr(0, taken.path.rfind('.') + 1);
    const std::string name = split_step(taken.source).first, rest = split_step(taken.source).second;
    const Step& source = *project_.find(name);
    const std::vector<Member> members = source.members(rest);
    std::string filled;
    for_each_leaf(reading_.record, [&](const std::string& path, const Leaf& leaf) {
      if (!leaf.field->is_of_body || !path.starts_with(base) || is_of_record(reading_, path)) return;
      const auto given = std::find_if(members.begin(), members.end(), [&](const Member& member) {
        return member.key == std::string_view(path).substr(base.size()) && is_like(source, member, *leaf.field);
      });
      if (given == members.end()) return;
      const std::string from = std::string(name).append(".").append(given->path);
      if (reading_.typed.contains(path)) return keep({path, from, given->is_word, false});
      fill(taken, path, leaf, {given->key, from, given->is_word}, true);
      list(filled, given->key);
    });
    if (!filled.empty()) step_.remark(say("taken from {1} with {2}: {3}", taken.source, taken.path, filled));
  }

  /// A dimension of the component of a load, "=chain.shaft_1.d_f", shows which shaft the step is on: its own loads are
  /// compared with those of that component.
  void compare_loads_of_bodies() {
    for (const Operand& operand : reading_.operands) {
      if (operand.of_record || operand.leaf.field->is_load || !operand.expression.is_reference()) continue;
      const std::string record = record_behind(operand);
      if (!record.empty()) compare_loads(operand.path, record);
    }
  }

  void compare_loads(const std::string& prefix, const std::string& record) {
    const std::string base = prefix.substr(0, prefix.rfind('.') + 1);
    const auto [name, rest] = split_step(record);
    const Step& source = *project_.find(name);
    for (const Member& member : source.members(rest)) {
      const std::string path = base + member.key, there = name + "." + member.path;
      const Leaf leaf = find_leaf(reading_.record, path);
      const FieldInfo* const field = source.field(member.path);
      const bool is_load = leaf && leaf.field->is_load && is_like(source, member, *leaf.field);
      if (!is_load || !reading_.typed.contains(path) || is_of_record(reading_, path)) continue;
      keep({path, there, false, true, field == nullptr ? "" : field->factors});
    }
  }

  /// The record that all references of a load belong to, "gears.gear_1", also for "gears.T_1"; empty if there is none.
  std::string record_behind(const Operand& operand) const {
    std::string found;
    for (const auto& reference : operand.expression.references()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project_.find(name);
      if (source == nullptr) continue;
      const std::string record = record_of(*source, rest);
      if (record.empty()) continue;
      const std::string whole = std::string(name).append(".").append(record);
      if (!found.empty() && found != whole) return {};
      found = whole;
    }
    return found;
  }

  /// The record of a value: the one that contains it, or the one handed over with it and its index, "gear_1" for T_1.
  static std::string record_of(const Step& source, const std::string& path) {
    const auto is_record = [&](const std::string& c) { return form_of(source, c) == Form::record; };
    if (path.find('.') != std::string::npos) {
      const std::string record = prefix_of(path).substr(0, path.rfind('.'));
      return is_record(record) ? record : "";
    }
    if (path.size() < 3 || path[path.size() - 2] != '_' || source.input().calculator->result == nullptr) return {};
    for (const FieldInfo& field : source.input().calculator->result->fields) {
      const bool is_alike = field.is_handed_over && std::string_view(field.key).ends_with(path.substr(path.size() - 2));
      if (!is_alike || !is_record(field.key)) continue;
      const std::vector<Member> members = source.members(field.key);
      const auto is_it = [&](const Member& member) { return member.key == path.substr(0, path.size() - 2); };
      if (std::any_of(members.begin(), members.end(), is_it)) return field.key;
    }
    return {};
  }

  static bool is_like(const Step& source, const Member& member, const FieldInfo& field) {
    if (member.is_word || field.is_word()) return member.is_word && field.is_word();
    const auto signature = source.signature(member.path);
    return field.is_number() && signature && signature->dimension == field.dimension;
  }

  /// `given`: with the full path of its value.
  void fill(const Taken& taken, const std::string& path, const Leaf& leaf, const Member& given,
            bool may_be_incomplete) {
    reading_.typed[path] = {"=" + given.path, taken.place};
    if (given.is_word)
      return reading_.taken.push_back({path, leaf.field, given.path, taken.place, true, may_be_incomplete});
    auto expression = Expression::parse(given.path);
    reading_.operands.push_back({path, leaf, std::move(*expression), given.path, taken.place, true, may_be_incomplete});
  }

  /// Inputs missing in the record stay open in the step, except for those that the step requires and for loads: an
  /// unknown load is not zero.
  [[nodiscard]] bool may_be_incomplete(const Step& source, const Member& given, const std::string& path) const {
    const FieldInfo* const field = source.field(given.path);
    const bool needed = std::any_of(reading_.missing.begin(), reading_.missing.end(),
                                    [&](const MissingInput& missing) { return missing.path == path; });
    return !needed && (field == nullptr || !field->is_load);
  }

  bool refused_ = false;
  Step& step_;
  Reading& reading_;
  const Project& project_;
  std::vector<Issue>& issues_;
};

}  // namespace

void settle_references(Step& step, const Project& project, std::vector<Issue>& issues) {
  Settling(step, project, issues).run();
}

bool is_reduction(const Meaning& meaning) {
  const std::string_view what = meaning.what;
  return what == "mean" || what == "amplitude" || what == "max" || what == "min" || what == reverses_in_turns ||
         what == steady_part || what == paired_amplitude || what == paired_middle;
}

std::string prefix_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot + 1);
}

namespace {

/// The value of an operand whose sources are solved; NaN where it is a series, or a source is not.
double value_of(const Operand& operand, const Project& project) {
  static const Value none{{}, {std::nan("")}};
  const Value value = operand.expression.evaluate([&](const std::string& path) -> const Value& {
    const Value* const known = project.value(path);
    return known == nullptr || known->si.empty() ? none : *known;
  });
  return value.is_series() ? std::nan("") : value.si[0];
}

}  // namespace

bool has_reversed_ratio(const Step& step, const std::string& prefix, const Project& project) {
  const Reading& reading = step.input().reading;
  const std::string path = prefix + "r";
  if (const Operand* const operand = reading.operand(path))
    return operand->early == -1.0 || value_of(*operand, project) == -1.0;
  const Leaf r = find_leaf(reading.record, path);
  return r && r.get() == -1.0;
}

}  // namespace loadpath::project
