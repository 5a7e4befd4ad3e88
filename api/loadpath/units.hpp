// Units as text: "kN*m", "MPa", "rpm", "degC".
#pragma once

#include <span>
#include <string_view>

namespace loadpath::api {

/// Values of one unit in another, in place. An Error if one is none, or they are of two kinds.
void convert(std::span<double> values, std::string_view from, std::string_view to);
/// A quantity as people write it, in SI: "12 kN*m".
double in_si(std::string_view quantity);

}  // namespace loadpath::api
