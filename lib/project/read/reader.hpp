// The reader behind read_record (lib/project/read/read_record.hpp): a tree of a project file into the fields of a
// record.
#pragma once

#include "lib/project/read/reading.hpp"
#include "lib/project/read/spread.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

using toml::Tree;

/// Fields, and the aggregate that holds them.
struct Part {
  std::span<const FieldInfo> fields;
  void* owner = nullptr;
};

class Reader {
 public:
  Reader(Reading& reading, std::vector<Issue>& issues, std::string prefix)
      : reading_(reading), issues_(issues), prefix_(std::move(prefix)) {}

  /// Each key goes to the part that has a field of that name.
  void read_fields(const Tree& table, const std::vector<Part>& parts, const std::string& path,
                   const std::vector<std::string>& reserved);

 private:
  void read_value(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  /// Takes a record, list or word of another step where the text refers to it.
  bool takes(const Tree& tree, const FieldInfo& field, const std::string& path);
  void read_expression(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_text_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_search(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_special(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_history_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  /// Refuses keys of a table other than these.
  void refuse_others(const toml::Tree& tree, const std::vector<std::string>& keys, const std::string& path);
  void read_grid_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_uncertain_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  Refuse refusing(const std::string& path);
  void read_stock(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_words(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  bool read_one(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path, double& si);
  void read_literal(const std::string& text, const Tree& tree, const FieldInfo& field, void* owner,
                    const std::string& path);
  void read_count(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_choice(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_name(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_formula(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_list(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  /// A list, and how many of its elements a template has laid out.
  struct Target {
    const FieldInfo& list;
    void* owner;
    std::size_t given;
    [[nodiscard]] std::vector<std::string> given_names() const;
    [[nodiscard]] void* find_given(const std::string& name) const;
  };
  void read_element(const Tree& tree, const Target& target, const std::string& path, const Tree::Entry* named);
  void read_aggregate(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path);
  void read_array(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path);
  void require(std::span<const FieldInfo> fields, void* owner, const std::string& path, const Place& place);
  void check_names(const FieldInfo& list, void* owner, const std::string& path, const Place& place);

  void say_at(const Place& place, const std::string& path, Message message, Message hint = {},
              Severity severity = Severity::error, KeyFault key_fault = KeyFault::none) {
    issues_.push_back({place, prefix_ + path, std::move(message), std::move(hint), severity, key_fault});
    if (severity == Severity::error) reading_.faulty.insert(path.substr(0, path.find_first_of(".[")));
  }
  void fault_at(const Place& start, std::string_view text, const std::string& path, const Fault& fault) {
    say_at(place_in(start, text, fault.at, fault.length), path, fault.message, fault.hint);
  }

  Reading& reading_;
  std::vector<Issue>& issues_;
  std::string prefix_;
  bool in_step_ = false;  // whether the fields being read take several synchronous series, sample by sample
};

/// "links.rod" and "mass": "links.rod.mass".
std::string joined(const std::string& path, std::string_view key);
std::vector<std::string> keys_of(const std::vector<Part>& parts);
/// The nearest candidate, or all of them.
Message one_of(const std::string& word, const std::vector<std::string>& candidates);
/// The nearest word of a choice, or all that state something, with their aliases.
Message word_near(const std::string& word, const FieldInfo& choice);

}  // namespace loadpath::project
