#include "lib/calculator/law_text.hpp"

namespace loadpath {

LawText::LawText(std::string_view text, const Law::Variable& variable, const Dimension& result) : text_(text) {
  if (!empty()) read_ = std::make_shared<const Outcome<Law>>(Law::parse(view(), variable, result));
}

}  // namespace loadpath
