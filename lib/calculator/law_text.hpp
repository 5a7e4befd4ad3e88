// A formula as it was typed: read once, when its text is set, and shared by the copies of the input that holds it.
#pragma once

#include "lib/calculator/list.hpp"
#include "lib/quantity/expression/law.hpp"
#include "lib/quantity/expression/relation.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace loadpath {

/// `Read`: what the text is read as, Law or Relation.
template <class Read>
class ReadText {
 public:
  static constexpr std::size_t capacity = Formula::capacity;

  [[nodiscard]] std::string_view view() const { return text_.view(); }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  /// Null if the text is empty, or cannot be read.
  [[nodiscard]] const Read* read() const { return read_ != nullptr && *read_ ? &**read_ : nullptr; }
  /// The fault that prevents the text from being read; null if there is none.
  [[nodiscard]] const Fault* fault() const { return read_ != nullptr && !*read_ ? &read_->fault() : nullptr; }

 protected:
  ReadText() = default;
  template <class... How>
  explicit ReadText(std::string_view text, const How&... how) : text_(text) {
    if (!empty()) read_ = std::make_shared<const Outcome<Read>>(Read::parse(view(), how...));
  }

 private:
  Formula text_;
  std::shared_ptr<const Outcome<Read>> read_;  // null: the text is empty
};

class LawText : public ReadText<Law> {
 public:
  [[nodiscard]] const Law* law() const { return read(); }

 protected:
  using ReadText<Law>::ReadText;
};

/// A quantity of this unit's dimension as a law of this variable.
template <const auto& unit, const Law::Variable& variable>
class LawOf : public LawText {
 public:
  LawOf() = default;
  LawOf(std::string_view text) : LawText(text, variable, unit.dimension()) {}  // NOLINT(google-explicit-constructor)
  LawOf(const char* text) : LawOf(std::string_view(text)) {}                   // NOLINT(google-explicit-constructor)
};

using RelationText = ReadText<Relation>;

/// A quantity of this unit's dimension as a function of these variables.
template <const auto& unit, const auto& variables>
class RelationOf : public RelationText {
 public:
  RelationOf() = default;
  RelationOf(std::string_view text)
      : RelationText(text, variables, std::optional(unit.dimension())) {}  // NOLINT(google-explicit-constructor)
  RelationOf(const char* text) : RelationOf(std::string_view(text)) {}     // NOLINT(google-explicit-constructor)
};

/// Any quantity as a function of these variables.
template <const auto& variables>
class AnyRelationOf : public RelationText {
 public:
  AnyRelationOf() = default;
  AnyRelationOf(std::string_view text)
      : RelationText(text, variables, std::nullopt) {}                        // NOLINT(google-explicit-constructor)
  AnyRelationOf(const char* text) : AnyRelationOf(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)
};

}  // namespace loadpath
