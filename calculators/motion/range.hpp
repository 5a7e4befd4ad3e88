// A range of times t_1 to t_2 that may be left out: the rules that it keeps.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::motion {

template <class Input>
constexpr auto range_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return is_set(in.t_1) == is_set(in.t_2); }, "t_1, t_2",
                                "give both t_1 and t_2, or neither"},
                    Rule<Input>{[](const Input& in) { return !(in.t_1 >= in.t_2); }, "t_2, t_1",
                                "the range must end after its start"}};
}

}  // namespace loadpath::motion
