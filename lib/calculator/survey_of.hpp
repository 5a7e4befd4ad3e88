// The rules and modes of a calculator class at a block of points. Included by the source of a calculator, through
// calculator_of.hpp.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <cstring>
#include <utility>

namespace loadpath::detail {

/// Whether one of the requested rules is violated.
template <class C, std::size_t... rule>
bool breaks_any(const typename C::Input& in, std::span<const char> asked, std::index_sequence<rule...>) {
  return ((asked[rule] != 0 && !C::rules[rule].holds(in)) || ...);
}

template <class C, std::size_t mode>
void ask_mode(const typename C::Input& in, Applies* applies, std::size_t i) {
  if (applies != nullptr) applies[i] = C::modes[mode].applies(in);
}

template <class C, std::size_t... mode>
void ask_modes(const typename C::Input& in, Applies* const* applies, std::size_t i, std::index_sequence<mode...>) {
  (ask_mode<C, mode>(in, applies[mode], i), ...);
}

/// As defined by Calculator::survey: the rules and modes are known at compile time. A mode without a column is left
/// out.
template <class C>
void survey(void* input, std::span<const InputColumn> in, std::span<const char> rules, std::span<Applies* const> modes,
            std::size_t count, char* other) {
  char* const base = static_cast<char*>(input);
  const auto& point = *static_cast<const typename C::Input*>(input);
  for (std::size_t i = 0; i < count; ++i) {
    if (other[i] != 0) continue;
    for (const InputColumn& column : in) std::memcpy(base + column.offset, column.si + i, sizeof(double));
    if (breaks_any<C>(point, rules, std::make_index_sequence<C::rules.size()>{})) other[i] = 1;
    if constexpr (requires { C::modes; }) {
      if (!modes.empty()) ask_modes<C>(point, modes.data(), i, std::make_index_sequence<C::modes.size()>{});
    }
  }
}

}  // namespace loadpath::detail
