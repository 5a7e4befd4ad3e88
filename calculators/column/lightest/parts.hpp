// Declarations shared by the sources of column.lightest.
#pragma once

#include "calculators/column/lightest/families.hpp"
#include "calculators/column/lightest/types.hpp"

namespace loadpath::column {

/// Whether the section is of one of the families, and there is room for it.
bool belongs(const TableSection& section, const LightestTypes::Input& in);

/// The yield strength at a thickness; unset beyond the last one.
Stress strength_of(const LightestTypes::Input& in, Length t);

/// The input of column.buckling that corresponds to the section.
Buckling::Input bar_of(const LightestTypes::Input& in, const TableSection& section);

/// The largest check or limit of column.buckling of those that are known; each is kept up to 1.
double demand_of(const MemberResult& r);

/// The first reason why it does not carry the bar.
LightestTypes::Failure failure_of(const Buckling::Input& bar, const MemberResult& r);

}  // namespace loadpath::column
