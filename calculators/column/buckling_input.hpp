// A compressed bar with its section.
#pragma once

#include "calculators/column/member/member.hpp"
#include "calculators/column/member/section.hpp"

namespace loadpath::column {

struct BucklingInput : Member, Section {
  Length l_T = unset<Length>;
};

}  // namespace loadpath::column
