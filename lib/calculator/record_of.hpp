// Makes the erased fields (lib/calculator/record.hpp) from a calculator's constexpr list. Included by the source of a
// calculator. They are constants: nothing is built at program start.
#pragma once

#include "lib/calculator/leaves.hpp"
#include "lib/calculator/record.hpp"

#include <cmath>

namespace loadpath {

namespace detail {

template <class Enum>
constexpr auto choice_infos() {
  constexpr auto names = choices_of(Enum{});
  std::array<ChoiceInfo, names.size()> infos{};
  for (std::size_t i = 0; i < names.size(); ++i) infos[i] = {names[i].key, names[i].doc, names[i].also};
  return infos;
}
template <class Enum>
inline constexpr auto choice_table = choice_infos<Enum>();

template <class Self>
constexpr FieldInfo described(const detail::Described<Self>& field, FieldInfo::Type type, Role role_of_list) {
  FieldInfo info;
  info.type = type;
  info.key = field.key;
  info.doc = field.doc;
  info.also_called = field.also_called;
  info.role = field.role.value_or(role_of_list);
  info.optional = field.optional;
  info.is_load = field.is_load;
  info.is_of_body = field.is_of_body;
  info.shared_as = field.shared_as;
  info.is_chosen = field.is_chosen;
  info.is_as_given = field.is_as_given;
  info.is_informative = field.is_informative;
  info.same_as_source = field.same_as_source;
  return info;
}

template <const auto& fields, Role role>
constexpr std::span<const FieldInfo> infos_of();

/// The one value of a member.
template <class Quantity>
constexpr Quantity& one_of(Quantity& member) {
  return member;
}
template <class Quantity>
constexpr Quantity& one_of(Varying<Quantity>& member) {
  return member.one;
}
template <class Quantity>
constexpr const Quantity& one_of(const Varying<Quantity>& member) {
  return member.one;
}

template <const auto& fields, Role role, std::size_t I, class Owner, class Quantity, class Member>
constexpr FieldInfo info_of(const Field<Owner, Quantity, Member>& f) {
  FieldInfo info = described(f, FieldInfo::Type::quantity, role);
  info.unit = f.unit.symbol;
  info.factor = in_si(f.unit.one);
  info.dimension = f.unit.dimension();
  info.kind = f.unit.kind;
  info.bounds = f.bounds.times(info.factor);
  info.plausible = f.plausible.times(info.factor);
  info.customary = f.customary.times(info.factor);
  info.provider = f.provider;
  info.asked_by = f.asked_by;
  info.infinite = f.infinite;
  info.where_set = f.where_set;
  info.is_criterion = f.is_criterion;
  info.is_sizeless = f.is_sizeless;
  info.searched_in = f.searched_in;
  info.sought_unasked = f.sought_unasked;
  info.is_own = f.is_own;
  info.most_of_source = f.most_of_source;
  info.least_of_source = f.least_of_source;
  info.near_source = f.near_source;
  info.made_for = f.made_for;
  info.larger_is_better = f.larger_is_better;
  info.kept = f.kept;
  info.companions = f.companions;
  info.signed_load = f.signed_load;
  info.factors = f.factors;
  info.is_factor = f.is_factor;
  info.is_peak = f.is_peak;
  info.is_of_step = f.is_of_step;
  info.get = [](const void* o) { return in_si(one_of(static_cast<const Owner*>(o)->*member_at<fields, I>)); };
  info.set = [](void* o, double v) { static_cast<Owner*>(o)->*member_at<fields, I> = from_si<Quantity>(v); };
  if constexpr (!std::is_same_v<Member, Quantity>) {
    info.set_series = [](void* o, Value series) {
      static_cast<Owner*>(o)->*member_at<fields, I> = Varying<Quantity>(std::move(series));
    };
    info.series = [](const void* o) { return (static_cast<const Owner*>(o)->*member_at<fields, I>).series.get(); };
  }
  info.address = [](void* o) {
    auto& member = one_of(static_cast<Owner*>(o)->*member_at<fields, I>);
    if constexpr (std::is_same_v<Quantity, double>) {
      return &member;
    } else {
      return const_cast<double*>(&member.value());  // a quantity is one double, and the record is not const
    }
  };
  return info;
}

template <const auto& fields, Role role, std::size_t I, class Owner>
constexpr FieldInfo info_of(const Count<Owner>& f) {
  FieldInfo info = described(f, FieldInfo::Type::count, role);
  info.bounds = {static_cast<double>(f.low), static_cast<double>(f.high), false, false};
  info.get = [](const void* o) { return static_cast<double>(static_cast<const Owner*>(o)->*member_at<fields, I>); };
  info.set = [](void* o, double v) { static_cast<Owner*>(o)->*member_at<fields, I> = Whole(v); };
  return info;
}

template <const auto& fields, std::size_t I, class Owner, class Text>
constexpr void let_text(Text Owner::*, FieldInfo& info) {
  info.capacity = Text::capacity;
  info.text = [](const void* o) { return (static_cast<const Owner*>(o)->*member_at<fields, I>).view(); };
  info.set_text = [](void* o, std::string_view t) { static_cast<Owner*>(o)->*member_at<fields, I> = t; };
}

template <const auto& fields, Role role, std::size_t I, class Owner>
constexpr FieldInfo info_of(const NameField<Owner>& f) {
  FieldInfo info = described(f, FieldInfo::Type::name, role);
  info.searched_in = f.searched_in;
  let_text<fields, I>(f.at, info);
  return info;
}

template <const auto& fields, Role role, std::size_t I, class Owner, class Text>
constexpr FieldInfo info_of(const FormulaField<Owner, Text>& f) {
  FieldInfo info = described(f, FieldInfo::Type::formula, role);
  let_text<fields, I>(f.at, info);
  return info;
}

template <const auto& fields, Role role, std::size_t I, class Owner, class Enum>
constexpr FieldInfo info_of(const Choice<Owner, Enum>& f) {
  FieldInfo info = described(f, FieldInfo::Type::choice, role);
  info.choices = choice_table<Enum>;
  info.get = [](const void* o) {
    const Enum value = static_cast<const Owner*>(o)->*member_at<fields, I>;
    constexpr auto names = choices_of(Enum{});
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].value == value) return static_cast<double>(i);
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  info.set = [](void* o, double index) {  // NaN: not chosen, which is the default of the owner
    static_cast<Owner*>(o)->*member_at<fields, I> =
        std::isnan(index) ? Owner{}.*member_at<fields, I> : choices_of(Enum{})[static_cast<std::size_t>(index)].value;
  };
  return info;
}

template <const auto& fields, Role role, std::size_t I, class Owner>
constexpr FieldInfo info_of(const RecordField<Owner>& f) {
  return described(f, FieldInfo::Type::record, role);
}

template <const auto& fields, Role role, std::size_t I, class Owner, class Part>
constexpr FieldInfo info_of(const Group<Owner, Part>& f) {
  FieldInfo info = described(f, FieldInfo::Type::group, role);
  info.is_handed_over = f.is_handed_over;
  info.positional = f.positional;
  info.fields = infos_of<Part::fields, role>();
  info.size = [](const void*) { return std::size_t{1}; };
  info.element = [](void* o, std::size_t) -> void* { return &(static_cast<Owner*>(o)->*member_at<fields, I>); };
  return info;
}

template <const auto& fields, Role role, std::size_t I, class Owner, class Items>
constexpr FieldInfo info_of(const ListField<Owner, Items>& f) {
  using Element = typename Items::value_type;
  FieldInfo info = described(f, FieldInfo::Type::list, role);
  info.positional = f.positional;
  info.provider = f.provider;
  info.fields = infos_of<Element::fields, role>();
  info.capacity = capacity_of<Items>;
  info.size = [](const void* o) { return (static_cast<const Owner*>(o)->*member_at<fields, I>).size(); };
  info.element = [](void* o, std::size_t i) -> void* { return &(static_cast<Owner*>(o)->*member_at<fields, I>)[i]; };
  info.reserve = [](void* o, std::size_t n) { (static_cast<Owner*>(o)->*member_at<fields, I>).reserve(n); };
  info.push = [](void* o) -> void* {
    auto& list = static_cast<Owner*>(o)->*member_at<fields, I>;
    list.push_back(Element{});
    return &list.back();
  };
  return info;
}

template <const auto& fields, Role role>
inline constexpr auto infos = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<FieldInfo, sizeof...(I)>{info_of<fields, role, I>(field_at<I>(fields))...};
}
(std::make_index_sequence<std::remove_cvref_t<decltype(fields)>::count>{});

template <const auto& fields, Role role>
constexpr std::span<const FieldInfo> infos_of() {
  return infos<fields, role>;
}

}  // namespace detail

/// The erased type of an aggregate whose fields are declared in `fields`, which have that role unless declared
/// otherwise.
template <class Aggregate, const auto& fields, Role role = Role::input>
inline constexpr RecordType record_type{
    detail::infos_of<fields, role>(), [] { return std::shared_ptr<void>(std::make_shared<Aggregate>()); },
    [](const void* from, void* to) { *static_cast<Aggregate*>(to) = *static_cast<const Aggregate*>(from); }};

}  // namespace loadpath
