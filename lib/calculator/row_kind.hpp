// A choice that a row of a table makes if the user does not: `section = "IPE 200"` implies kind = "rolled_I".
#pragma once

#include "lib/calculator/record.hpp"

namespace loadpath {

/// The kind of the row that the step names for a table, where that is one of the words of the choice. Other rows leave
/// the input as it is.
template <class Owner, class Enum>
struct RowKind : Choice<Owner, Enum> {
  const char* table;
  constexpr RowKind(Enum Owner::*member, const char* k, const char* d, const char* group)
      : Choice<Owner, Enum>{member, k, d}, table{group} {
    this->optional = true;
  }
};

namespace detail {

template <const auto& fields, Role role, std::size_t I, class Owner, class Enum>
constexpr FieldInfo info_of(const RowKind<Owner, Enum>& f) {
  FieldInfo info = info_of<fields, role, I>(static_cast<const Choice<Owner, Enum>&>(f));
  info.provider = {Provider::Kind::table, f.table, "kind"};
  return info;
}

}  // namespace detail

}  // namespace loadpath
