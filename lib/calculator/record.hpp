// Fields without their C++ types, for every reader, writer, search and test. Made from the lists of fields by
// lib/calculator/record_of.hpp, once per calculator; everything that uses it is ordinary code.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/dimension.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

struct ChoiceInfo {
  const char* key;
  const char* doc;
  const char* also;
};

/// One field. Which of the accessors are set depends on the type; `owner` points to the aggregate that holds it.
struct FieldInfo {
  enum class Type {
    quantity,
    count,
    choice,
    name,
    formula,
    group,
    list,
    record  // record of another step: without a value of its own
  };

  Type type = Type::quantity;
  const char* key = "";
  const char* doc = "";
  const char* also_called = "";
  Role role = Role::input;
  bool optional = false;
  bool is_load = false;
  bool is_informative = false;
  bool is_of_body = false;
  const char* shared_as = "";
  bool is_chosen = false;
  bool is_as_given = false;
  bool positional = false;  // group, list of groups: may be written as an array

  // quantity
  const char* unit = "-";
  double factor = 1.0;  // SI value of one unit
  Dimension dimension;
  Kind kind = Kind::plain;
  Range bounds;     // SI; count: its range
  Range plausible;  // SI
  Range customary;  // SI
  Provider provider;
  const char* asked_by = "";
  bool infinite = false;
  bool where_set = false;
  bool is_criterion = false;
  bool is_sizeless = false;
  const char* searched_in = "";
  bool sought_unasked = false;
  bool is_own = false;
  const char* same_as_source = "";
  const char* most_of_source = "";
  const char* least_of_source = "";
  const char* near_source = "";
  const char* made_for = "";
  bool larger_is_better = false;
  bool kept = false;
  const char* companions = "";
  bool signed_load = false;
  const char* factors = "";
  bool is_factor = false;
  bool is_peak = false;
  bool is_of_step = false;
  bool is_handed_over = false;  // group

  std::span<const ChoiceInfo> choices;  // choice
  std::span<const FieldInfo> fields;    // group, list
  std::size_t capacity = 0;             // list: elements, or no_bound; name, formula: bytes

  double* (*address)(void* owner) = nullptr;                // quantity
  double (*get)(const void* owner) = nullptr;               // quantity, count, choice (its index)
  void (*set)(void* owner, double si) = nullptr;            // quantity, count, choice
  void (*set_series)(void* owner, Value series) = nullptr;  // quantity that takes an entire series
  const Value* (*series)(const void* owner) = nullptr;      // the same; null if it is one value
  std::string_view (*text)(const void* owner) = nullptr;    // name, formula
  void (*set_text)(void* owner, std::string_view text) = nullptr;
  std::size_t (*size)(const void* owner) = nullptr;        // list; a group has size 1
  void* (*element)(void* owner, std::size_t i) = nullptr;  // list, group
  void (*reserve)(void* owner, std::size_t n) = nullptr;   // list: up to n elements, none moves another
  void* (*push)(void* owner) = nullptr;                    // list: adds a blank element

  [[nodiscard]] bool is_leaf() const { return !has_fields() && type != Type::record; }
  [[nodiscard]] bool has_fields() const { return type == Type::group || type == Type::list; }
  /// Whether a series comes at once, and not position by position.
  [[nodiscard]] bool takes_whole() const { return set_series != nullptr; }
  [[nodiscard]] bool is_number() const { return type == Type::quantity || type == Type::count; }
  /// Whether "?" finds the largest value that passes: of a load without a sign, and where more is better.
  [[nodiscard]] bool can_be_largest() const {
    return type == Type::quantity && (larger_is_better || (is_load && !signed_load));
  }
  [[nodiscard]] bool is_word() const { return type == Type::choice || type == Type::name || type == Type::formula; }
};

/// An aggregate type without its name.
struct RecordType {
  std::span<const FieldInfo> fields;
  std::shared_ptr<void> (*make)() = nullptr;
  void (*copy)(const void* from, void* to) = nullptr;
};

/// An aggregate and its fields.
struct Record {
  const RecordType* type = nullptr;
  std::shared_ptr<void> data;

  Record() = default;
  explicit Record(const RecordType& t) : type(&t), data(t.make()) {}
  [[nodiscard]] Record clone() const {
    Record r(*type);
    type->copy(data.get(), r.data.get());
    return r;
  }
};

/// A leaf of a record: the field and the aggregate that holds it.
struct Leaf {
  const FieldInfo* field = nullptr;
  void* owner = nullptr;
  explicit operator bool() const { return field != nullptr; }
  [[nodiscard]] double get() const { return field->get(owner); }
  void set(double si) const { field->set(owner, si); }
};

/// The keys of a list: "N, P".
std::vector<std::string> listed_keys(std::string_view list);

const FieldInfo* find_field(std::span<const FieldInfo> fields, std::string_view key);

/// The input that a project means by this word: of that key, else called so, too.
const FieldInfo* find_input(std::span<const FieldInfo> fields, std::string_view word);

/// The field at a path, of any type, and the aggregate that contains it.
Leaf find_member(std::span<const FieldInfo> fields, void* data, std::string_view path);

/// The leaf at a path: "d", "segments[2].tau" (from 1) or "segments.journal.tau" (by the element's name).
Leaf find_leaf(std::span<const FieldInfo> fields, void* data, std::string_view path);
inline Leaf find_leaf(const Record& record, std::string_view path) {
  return find_leaf(record.type->fields, record.data.get(), path);
}

/// The field at a path of a record; which elements its lists have is known later. Null if there is none.
const FieldInfo* find_field_at(std::span<const FieldInfo> fields, std::string_view path);

/// Whether a field that must be given has no value.
bool is_missing(const FieldInfo& field, void* owner);

/// The text of a choice, a name or a formula.
std::string word_of(const Leaf& leaf);
/// Gives a choice, a name or a formula its text; false if a choice has no such word, or a name is too long.
bool set_word(const Leaf& leaf, std::string_view word);

/// Every leaf with its path, in order.
using VisitLeaf = std::function<void(const std::string& path, const Leaf& leaf)>;
void for_each_leaf(std::span<const FieldInfo> fields, void* data, const VisitLeaf& visit);
inline void for_each_leaf(const Record& record, const VisitLeaf& visit) {
  for_each_leaf(record.type->fields, record.data.get(), visit);
}

/// The name of element i of a list, or its number from 1 in brackets: ".journal" or "[2]".
std::string element_path(const FieldInfo& list, void* owner, std::size_t i);

}  // namespace loadpath
