// Lists of fields of different types, for the declarations of a calculator, and lists put together. std::tuple and
// std::tuple_cat would do the same at several times the compile time.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace loadpath {

namespace detail {

template <std::size_t I, class FieldType>
struct FieldPlace {
  FieldType field;
};

template <class Indices, class... FieldType>
struct FieldPlaces;
template <std::size_t... I, class... FieldType>
struct FieldPlaces<std::index_sequence<I...>, FieldType...> : FieldPlace<I, FieldType>... {
  explicit constexpr FieldPlaces(const FieldType&... field) : FieldPlace<I, FieldType>{field}... {}
};

/// The field at place I: the compiler finds the base class by I.
template <std::size_t I, class FieldType>
constexpr const FieldType& field_at(const FieldPlace<I, FieldType>& place) {
  return place.field;
}

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

template <class... FieldType>
struct Fields : detail::FieldPlaces<std::index_sequence_for<FieldType...>, FieldType...> {
  using Base = detail::FieldPlaces<std::index_sequence_for<FieldType...>, FieldType...>;
  static constexpr std::size_t count = sizeof...(FieldType);
  static constexpr bool is_list_of_fields = true;

  explicit constexpr Fields(const FieldType&... field) : Base{field...} {}
};

template <class List>
concept ListOfFields = List::is_list_of_fields;

/// visit(field...) with all fields of the list.
template <class Visit, class... FieldType>
constexpr decltype(auto) apply(Visit&& visit, const Fields<FieldType...>& fields) {
  return [&]<std::size_t... I>(std::index_sequence<I...>)->decltype(auto) {
    return visit(detail::field_at<I>(fields)...);
  }
  (std::index_sequence_for<FieldType...>{});
}

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
