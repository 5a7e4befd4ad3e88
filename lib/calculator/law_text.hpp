// A law as it was typed: read once, when its text is set, and shared by the copies of the input that holds it.
#pragma once

#include "lib/calculator/list.hpp"
#include "lib/quantity/expression/law.hpp"

#include <memory>
#include <string_view>

namespace loadpath {

class LawText {
 public:
  static constexpr std::size_t capacity = Formula::capacity;

  [[nodiscard]] std::string_view view() const { return text_.view(); }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  /// Null if the text is empty, or no law.
  [[nodiscard]] const Law* law() const { return read_ != nullptr && *read_ ? &**read_ : nullptr; }
  /// The fault that prevents the text from being a law; null if there is none.
  [[nodiscard]] const Fault* fault() const { return read_ != nullptr && !*read_ ? &read_->fault() : nullptr; }

 protected:
  LawText() = default;
  LawText(std::string_view text, const Law::Variable& variable, const Dimension& result);

 private:
  Formula text_;
  std::shared_ptr<const Outcome<Law>> read_;  // null: the text is empty
};

/// A quantity of this unit's dimension as a law of this variable.
template <const auto& unit, const Law::Variable& variable>
class LawOf : public LawText {
 public:
  LawOf() = default;
  LawOf(std::string_view text) : LawText(text, variable, unit.dimension()) {}  // NOLINT(google-explicit-constructor)
  LawOf(const char* text) : LawOf(std::string_view(text)) {}                   // NOLINT(google-explicit-constructor)
};

}  // namespace loadpath
