// The quantities of an aggregate, through its groups, as types: so that a loop over them is unrolled by the compiler.
#pragma once

#include "lib/calculator/field.hpp"

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace loadpath::detail {

template <class FieldType>
inline constexpr bool is_quantity = false;
template <class Owner, class Quantity>
inline constexpr bool is_quantity<Field<Owner, Quantity, Quantity>> = true;
template <class FieldType>
inline constexpr bool is_group = false;
template <class Owner, class Part>
inline constexpr bool is_group<Group<Owner, Part>> = true;
template <class FieldType>
struct PartOf;
template <class Owner, class Part>
struct PartOf<Group<Owner, Part>> {
  using type = Part;
};
template <class FieldType>
inline constexpr bool is_list = false;
template <class Owner, class Items>
inline constexpr bool is_list<ListField<Owner, Items>> = true;
template <class FieldType>
inline constexpr bool is_choice = false;
template <class Owner, class Enum>
inline constexpr bool is_choice<Choice<Owner, Enum>> = true;
template <class FieldType>
inline constexpr bool is_count = false;
template <class Owner>
inline constexpr bool is_count<Count<Owner>> = true;
template <class FieldType>
inline constexpr bool is_record = false;
template <class Owner>
inline constexpr bool is_record<RecordField<Owner>> = true;

template <const auto& fields, std::size_t I>
using FieldAt = std::remove_cvref_t<decltype(field_at<I>(fields))>;
template <const auto& fields>
inline constexpr std::size_t fields_in = std::remove_cvref_t<decltype(fields)>::count;

template <const auto& fields, std::size_t I>
inline constexpr auto member_at = field_at<I>(fields).at;

/// A member of an aggregate.
template <const auto& fields, std::size_t I>
struct Member {
  static constexpr std::string_view key = field_at<I>(fields).key;
  static constexpr auto& in(auto& owner) { return owner.*member_at<fields, I>; }
  static constexpr bool is_at(std::string_view path) { return path == key; }
};
/// A quantity of a group.
template <class Part, class Leaf>
struct Through {
  static constexpr auto& in(auto& owner) { return Leaf::in(Part::in(owner)); }
  static constexpr bool is_at(std::string_view path) {
    return path.starts_with(Part::key) && path.size() > Part::key.size() && path[Part::key.size()] == '.' &&
           Leaf::is_at(path.substr(Part::key.size() + 1));
  }
};

template <class... Leaf>
struct Leaves {
  static constexpr std::size_t count = sizeof...(Leaf);
};

template <class... A, class... B>
constexpr Leaves<A..., B...> operator+(Leaves<A...>, Leaves<B...>) {
  return {};
}
template <class Part, class... Leaf>
constexpr Leaves<Through<Part, Leaf>...> through(Leaves<Leaf...>) {
  return {};
}

template <const auto& fields>
constexpr auto leaves_of();

template <const auto& fields, std::size_t I>
constexpr auto leaves_at() {
  using Type = FieldAt<fields, I>;
  if constexpr (is_quantity<Type>) {
    return Leaves<Member<fields, I>>{};
  } else if constexpr (is_group<Type>) {
    return through<Member<fields, I>>(leaves_of<PartOf<Type>::type::fields>());
  } else {
    return Leaves<>{};
  }
}

template <const auto& fields>
constexpr auto leaves_of() {
  return []<std::size_t... I>(std::index_sequence<I...>) { return (Leaves<>{} + ... + leaves_at<fields, I>()); }
  (std::make_index_sequence<fields_in<fields>>{});
}

}  // namespace loadpath::detail
