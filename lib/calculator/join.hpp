// Lists that calculators share, put together: of fields, rules and modes.
#pragma once

#include "lib/calculator/fields.hpp"

#include <array>

namespace loadpath {

namespace detail {

/// Which list a field of a concatenation comes from, and its index there.
struct Origin {
  std::size_t list;
  std::size_t index;
};

template <std::size_t... count>
inline constexpr auto origins = [] {
  std::array<Origin, (0 + ... + count)> all{};
  std::size_t list = 0;
  std::size_t end = 0;
  const auto append = [&](std::size_t fields) {
    for (std::size_t i = 0; i < fields; ++i) all[end++] = {list, i};
    ++list;
  };
  (append(count), ...);
  return all;
}();

}  // namespace detail

/// Lists of fields in one.
template <ListOfFields... List>
constexpr auto join(const List&... lists) {
  constexpr auto& from = detail::origins<List::count...>;
  const detail::FieldPlaces<std::index_sequence_for<List...>, const List*...> all{&lists...};
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Fields{detail::field_at<from[I].index>(*detail::field_at<from[I].list>(all))...};
  }
  (std::make_index_sequence<from.size()>{});
}

/// Lists of rules or of modes in one.
template <class Item, std::size_t... N>
constexpr auto join(const std::array<Item, N>&... lists) {
  constexpr auto& from = detail::origins<N...>;
  const Item* const starts[] = {lists.data()...};
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return std::array{starts[from[I].list][from[I].index]...}; }
  (std::make_index_sequence<from.size()>{});
}

}  // namespace loadpath
