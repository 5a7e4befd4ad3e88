// Lists of rules that calculators share, put together.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>
#include <tuple>

namespace loadpath {

/// Lists of rules in one.
template <class Input, std::size_t... N>
constexpr auto join(const std::array<Rule<Input>, N>&... parts) {
  return std::apply([](const auto&... rule) { return std::array{rule...}; }, std::tuple_cat(parts...));
}

}  // namespace loadpath
