// The types derived from a form (lib/calculator/form.hpp) and a calculator class: the given and requested quantities
// as types, and the settled choices. Included by the source of a calculator.
#pragma once

#include "lib/calculator/form.hpp"
#include "lib/calculator/leaves.hpp"

#include <bit>
#include <cstdint>

namespace loadpath::detail {

/// The offsets of quantities inside their aggregate.
template <class Owner, class... Leaf>
std::array<std::size_t, sizeof...(Leaf)> offsets_in(Leaves<Leaf...>) {
  union Room {
    char none;
    Owner owner;
    Room() : none{} {}
    ~Room() {}
  } room;
  const char* const start = &room.none;
  return {static_cast<std::size_t>(reinterpret_cast<const char*>(&Leaf::in(room.owner)) - start)...};
}

template <class Owner, class... Leaf>
std::array<double, sizeof...(Leaf)> values_in(const Owner& owner, Leaves<Leaf...>) {
  return {in_si(Leaf::in(owner))...};
}

/// Whether an aggregate is as a blank one.
template <const auto& fields, class Owner>
bool is_blank(const Owner& owner, const Owner& blank);

template <const auto& fields, std::size_t I, class Owner>
bool is_blank_at(const Owner& owner, const Owner& blank) {
  using Type = FieldAt<fields, I>;
  if constexpr (is_record<Type>) {
    return true;
  } else {
    const auto& a = Member<fields, I>::in(owner);
    const auto& b = Member<fields, I>::in(blank);
    if constexpr (is_quantity<Type>) {
      return std::bit_cast<std::uint64_t>(in_si(a)) == std::bit_cast<std::uint64_t>(in_si(b));
    } else if constexpr (is_group<Type>) {
      return is_blank<PartOf<Type>::type::fields>(a, b);
    } else if constexpr (is_list<Type>) {
      return a.empty();
    } else if constexpr (requires { a.series; }) {
      return !is_set(a);
    } else if constexpr (requires { a.view(); }) {
      return a.view() == b.view();
    } else {
      return a == b;
    }
  }
}

template <const auto& fields, class Owner>
bool is_blank(const Owner& owner, const Owner& blank) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return (is_blank_at<fields, I>(owner, blank) && ...); }
  (std::make_index_sequence<fields_in<fields>>{});
}

template <class C, std::size_t which>
class FormOf {
  using Input = typename C::Input;
  using Places = std::make_index_sequence<fields_in<C::inputs>>;
  static constexpr Form form = C::forms[which];

  template <std::size_t I>
  static constexpr bool is_given = names(form.given, field_at<I>(C::inputs).key);
  template <std::size_t I>
  static constexpr std::string_view word = word_in(form.given, field_at<I>(C::inputs).key);

  template <std::size_t I>
  static constexpr auto meant() {
    using Enum = std::remove_cvref_t<decltype(std::declval<Input&>().*(field_at<I>(C::inputs).at))>;
    for (const auto& choice : choices_of(Enum{})) {
      if (choice.key == word<I>) return choice.value;
    }
    return Enum{};
  }

  template <std::size_t I>
  static constexpr auto given_at() {
    if constexpr (is_given<I> && is_quantity<FieldAt<C::inputs, I>>) {
      return Leaves<Member<C::inputs, I>>{};
    } else {
      return Leaves<>{};
    }
  }
  template <std::size_t... I>
  static constexpr auto all_given(std::index_sequence<I...>) {
    static_assert((0 + ... + (is_given<I> ? 1 : 0)) == count_of(form.given), "a form names no such input");
    return (Leaves<>{} + ... + given_at<I>());
  }
  template <class Leaf>
  static constexpr auto asked_one() {
    if constexpr (*form.asked == '\0' || any_of(form.asked, &Leaf::is_at)) {
      return Leaves<Leaf>{};
    } else {
      return Leaves<>{};
    }
  }
  template <class... Leaf>
  static constexpr auto all_asked(Leaves<Leaf...>) {
    return (Leaves<>{} + ... + asked_one<Leaf>());
  }

  /// Sets a choice to the word of the form, and anything else without a column to the value of the base.
  template <std::size_t I>
  static void settle_one(Input& point, const Input& base) {
    if constexpr (!word<I>.empty()) {
      Member<C::inputs, I>::in(point) = meant<I>();
    } else if constexpr (is_given<I> && !is_quantity<FieldAt<C::inputs, I>>) {
      Member<C::inputs, I>::in(point) = Member<C::inputs, I>::in(base);
    }
  }
  template <std::size_t I>
  static bool fits_one(const Input& base, const Input& blank) {
    if constexpr (!is_given<I>) {
      return is_blank_at<C::inputs, I>(base, blank);
    } else if constexpr (!word<I>.empty()) {
      return Member<C::inputs, I>::in(base) == meant<I>();
    } else {
      return true;
    }
  }

 public:
  static constexpr auto given = all_given(Places{});
  static constexpr auto asked = all_asked(leaves_of<C::results>());
  static_assert(*form.asked == '\0' || asked.count == count_of(form.asked), "a form names no such result");

  /// Sets the given inputs that are not quantities.
  static void settle(Input& point, const Input& base) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (settle_one<I>(point, base), ...); }
    (Places{});
  }
  /// Whether all but the given quantities is as the form has it.
  static bool fits(const Input& base) {
    const Input blank;
    return [&]<std::size_t... I>(std::index_sequence<I...>) { return (fits_one<I>(base, blank) && ...); }
    (Places{});
  }
};

}  // namespace loadpath::detail
