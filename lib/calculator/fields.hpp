// Members common to fields of all types, and lists of fields for the declarations of a calculator. std::tuple and
// std::tuple_cat would do the same at several times the compile time.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace loadpath {

/// A check is a utilisation, demand over capacity, passing at <= 1. A limit is the range of a method, outside of which
/// the verdict is "not covered"; or a criterion, outside of which the part fails.
enum class Role { input, result, check, limit };

namespace detail {

/// Members common to fields of all types, each a link of the chain that declares it.
template <class Self>
struct Described {
  const char* key = "";
  const char* doc = "";
  std::optional<Role> role = {};    // default: that of the list, input or result
  bool optional = false;            // an input that may be missing (see its rule or default)
  bool is_load = false;             // a load on this part, or on another part by it; not a capacity
  bool is_informative = false;      // a result that is shown, and never part of a verdict
  const char* same_as_source = "";  // an input: see same_as_that_of_source
  bool is_chosen = false;           // a result that is a choice of the step: a section, a drive
  bool is_as_given = false;         // a result that is the input of its key where that is given
  bool is_of_body = false;          // an input that belongs to a load of the same record when that is taken singly
  const char* also_called = "";     // an input: other words that a project may write for its key, "n_2"
  const char* shared_as = "";       // see one_of_body

  [[nodiscard]] constexpr Self as(Role r) const {
    Self s = self();
    s.role = r;
    return s;
  }
  /// Other words for the key of an input, "a, C": what a project writes where a result has that key.
  [[nodiscard]] constexpr Self also(const char* words) const {
    Self s = self();
    s.also_called = words;
    return s;
  }
  [[nodiscard]] constexpr Self may_be_missing() const {
    Self s = self();
    s.optional = true;
    return s;
  }
  /// Force, moment, power, pressure: as an input a load on the part, as a result a load on a part that takes it.
  [[nodiscard]] constexpr Self load() const {
    Self s = self();
    s.is_load = true;
    return s;
  }
  /// A result that is the input of the same key where that is given: steps that refer to each other take the input.
  [[nodiscard]] constexpr Self as_given() const {
    Self s = self();
    s.is_as_given = true;
    return s;
  }
  /// A result that is the choice made by the step, shown as the size of the part: the lightest section, the drive.
  [[nodiscard]] constexpr Self chosen() const {
    Self s = self();
    s.is_chosen = true;
    return s;
  }
  /// A dimension of the component of a load: "=gears.gear_1.T" also gives gear_1.d_f, as the record does.
  [[nodiscard]] constexpr Self of_body() const {
    Self s = self();
    s.is_of_body = true;
    return s;
  }
  /// A result that is shown but not part of a verdict: by another school, of a sum that other checks assess in parts,
  /// of alternative methods.
  [[nodiscard]] constexpr Self informative() const {
    Self s = self();
    s.is_informative = true;
    return s;
  }
  /// A quantity that a body has once, by this name, "torque": in steps of one body the less favourable value holds, and
  /// any other needs a justification. A result measures what inputs of the name state in different ways, as T or as P
  /// with n. A choice may have two, "ends_y, ends_z".
  [[nodiscard]] constexpr Self one_of_body(const char* name) const {
    Self s = self();
    s.shared_as = name;
    return s;
  }
  /// The same quantity in the step that values are taken from, by its key there: "stages[#].z_1", '#' being the index
  /// named by the reference, otherwise 1. A different value is an error.
  [[nodiscard]] constexpr Self same_as_that_of_source(const char* there) const {
    Self s = self();
    s.same_as_source = there;
    return s;
  }

 private:
  [[nodiscard]] constexpr const Self& self() const { return static_cast<const Self&>(*this); }
};

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

/// The list that a field of a concatenation comes from, and its index there.
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
