#include "lib/project/references/meanings.hpp"

#include "lib/calculator/strength_bounds.hpp"
#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

namespace loadpath::project {

namespace {

using WordOf = std::function<std::string(const std::string& choice)>;

/// The meaning of a value, and the choice that defines it.
struct Said {
  std::string_view what;
  std::string choices;  // "loading = \"bending\""
};

bool has_key(std::string_view list, const std::string& key) {
  const auto keys = listed_keys(list);
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The words of the choices that decide together: "bending/grey-iron".
std::string words_of(const char* choices, const WordOf& word_of) {
  std::string words;
  for (const auto& choice : listed_keys(choices)) words += (words.empty() ? "" : "/") + word_of(std::string(choice));
  return words;
}

/// The meaning declared by the calculator for a field if its choices have these words; null if there is none.
const Meaning* declared(const Calculator& calculator, const std::string& field, const WordOf& word_of) {
  const auto said = [&](const Meaning& meaning) {
    if (is_reduction(meaning) || !has_key(meaning.fields, field)) return false;
    return *meaning.choice == '\0' || has_key(meaning.words, words_of(meaning.choice, word_of));
  };
  const auto found = std::find_if(calculator.meanings.begin(), calculator.meanings.end(), said);
  return found == calculator.meanings.end() ? nullptr : &*found;
}

/// The choices that decided, as they are typed.
std::string typed_choices(const Meaning& meaning, const WordOf& word_of) {
  std::string text;
  for (const auto& choice : listed_keys(meaning.choice)) {
    const std::string name(choice);
    text += (text.empty() ? "" : ", ") + name + " = \"" + word_of(name) + "\"";
  }
  return text;
}

/// The word of a choice in a step that is not solved yet: taken from another, typed, or its default.
std::string word_before(const Step& step, const Project& project, const std::string& choice) {
  for (const Taken& taken : step.input().reading.taken) {
    if (taken.path != choice) continue;
    const auto [name, rest] = split_step(taken.source);
    const Step* const source = project.find(name);
    return source == nullptr ? "" : source->word(rest);
  }
  const Leaf leaf = find_leaf(step.input().reading.record, choice);
  const bool is_choice = leaf && leaf.field->type == FieldInfo::Type::choice;
  return is_choice ? word_of(leaf) : "";
}

/// The meaning required of the input, as its calculator declares it.
Said wanted_by(const Step& step, const Operand& operand, const Project& project) {
  const WordOf word_of = [&](const std::string& choice) { return word_before(step, project, choice); };
  const Meaning* const meaning = declared(*step.input().calculator, operand.path, word_of);
  return meaning == nullptr || is_allowable(meaning->what) ? Said{} : Said{meaning->what, {}};
}

/// The meaning of a value of another step.
Said given_by(const Step& source, const std::string& path) {
  const WordOf word_of = [&](const std::string& choice) { return source.word(choice); };
  const Calculator* const calculator = source.input().calculator;
  const Meaning* const meaning = declared(*calculator, path, word_of);
  return meaning == nullptr ? Said{} : Said{meaning->what, typed_choices(*meaning, word_of)};
}

class Checking {
 public:
  Checking(const Step& step, const Project& project, std::vector<Issue>& issues)
      : step_(step), project_(project), issues_(issues) {}

  void run() {
    const std::size_t before = issues_.size();
    for (const TypedOverride& kept : step_.input().reading.kept) {
      if (kept.is_word) compare(kept);
    }
    if (issues_.size() > before) return;  // the required meaning of the values is not known
    for (const Operand& operand : step_.input().reading.operands) check(operand);
    for (const Operand& operand : step_.input().reading.whole) check(operand);
  }

 private:
  void check(const Operand& operand) {
    const Said wanted = wanted_by(step_, operand, project_);
    if (wanted.what.empty()) return;
    for (const auto& reference : operand.expression.handed_on()) {
      const auto [name, rest] = split_step(reference.path);
      const Step* const source = project_.find(name);
      if (source == nullptr) continue;
      const Said given = given_by(*source, rest);
      if (given.what.empty() || given.what == wanted.what) continue;
      if (wanted.what == limit_in_shear && given.what == limit_in_normal && is_by_distortion_energy(operand)) continue;
      if (operand.of_record && !reported_.insert(name).second) continue;  // several values of one record
      refuse(operand, reference, wanted, given);
    }
  }

  /// Whether a value is that of another step times at most 1/sqrt(3), written 0.577 or 0.58: a limit in shear by the
  /// distortion energy.
  bool is_by_distortion_energy(const Operand& operand) const {
    constexpr double largest_rounded = 0.58;
    static const Value none{{}, {std::nan("")}};
    if (operand.expression.references().size() != 1) return false;
    const auto value_at = [&](const std::string& path) -> const Value& {
      const Value* const value = project_.value(path);
      return value == nullptr ? none : *value;
    };
    const double normal = largest(value_at(operand.expression.references().front().path)).value;
    return largest(operand.expression.evaluate(value_at)).value <= largest_rounded * normal * (1.0 + 1e-9);
  }

  void refuse(const Operand& operand, const Expression::Reference& reference, const Said& wanted, const Said& given) {
    Message hint =
        given.choices.empty() ? Message{} : say("'{1}' has {2}", split_step(reference.path).first, given.choices);
    if (given.what == mean_strength) hint = say("use the strength for the required probability of survival P_s");
    issues_.push_back({place_in(operand.place, operand.text, reference.at, reference.path.size()),
                       step_.name() + "." + operand.path,
                       say("'{1}' takes {2}, and '{3}' is {4}", operand.path, wanted.what, reference.path, given.what),
                       std::move(hint), Severity::error});
  }

  /// Compares a typed word with that of a record.
  void compare(const TypedOverride& typed) {
    const auto [name, rest] = split_step(typed.source);
    const Step* const source = project_.find(name);
    if (source == nullptr) return;
    const std::string there = source->word(rest), here = word_before(step_, project_, typed.path);
    if (there.empty() || here.empty() || there == here) return;
    issues_.push_back({step_.input().reading.typed.at(typed.path).place, step_.name() + "." + typed.path,
                       say("'{1}' is \"{2}\" here, and '{3}' is \"{4}\"", typed.path, here, typed.source, there),
                       say("omit it: the record includes it"), Severity::error});
  }

  const Step& step_;
  const Project& project_;
  std::vector<Issue>& issues_;
  std::set<std::string> reported_;  // steps whose record is refused
};

}  // namespace

void check_meanings(const Step& step, const Project& project, std::vector<Issue>& issues) {
  Checking(step, project, issues).run();
}

}  // namespace loadpath::project
