// A key that is not valid at its place, and is valid elsewhere: an input of a group or of a list's elements, or the
// name of an element.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <span>
#include <string>
#include <string_view>

namespace loadpath::project {

/// "speed is an input of crank: write crank = { speed = "... rad/s" }"; of a list "loads = [{ F = "... N" }]". Empty if
/// no group or list has it; of several the first two.
Message input_within(std::string_view key, std::span<const FieldInfo> fields);

/// "did you mean 'links.slider'?" for the name of an element that a list has already; empty if none has.
Message element_called(std::string_view name, std::span<const FieldInfo> fields, void* owner);

/// "write crank = { speed = "180 rpm" }" for crank = "180 rpm": the first quantity of a table's inputs that the value
/// fits; else the inputs there are.
Message value_within(std::string_view value, const FieldInfo& table, const std::string& path);

/// "write the torque: T = \"=15 kW/(1450 rpm)\"", for P = "15 kW" where there is a torque T and no power.
Message torque_of_power(const toml::Tree::Entry& entry, std::span<const FieldInfo> fields);

/// "write the radius: R = "=1200 mm/2"", for D = "1200 mm" where there is a radius R; "write r and measured = "inner""
/// for r_i; "did you mean 'delta' (nominal wall thickness)?" for t, s and e. Empty for other keys.
Message size_meant(const toml::Tree::Entry& entry, std::span<const FieldInfo> fields);

}  // namespace loadpath::project
