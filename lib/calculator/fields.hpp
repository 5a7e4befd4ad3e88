// A list of fields of different types, for the declarations of a calculator. std::tuple and std::tuple_cat would do the
// same at several times the compile time.
#pragma once

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

}  // namespace loadpath
