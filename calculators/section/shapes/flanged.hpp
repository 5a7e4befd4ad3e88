// The sizes of a section of a web and flanges: an I, a channel, a T.
#pragma once

#include "lib/calculator/field.hpp"

namespace loadpath::section {

struct Flanged {
  Length h = unset<Length>;
  Length b = unset<Length>;
  Length t_w = unset<Length>;
  Length t_f = unset<Length>;
  Length r = from_si<Length>(0.0);
};

/// With what its depth, its width and the thickness of its flanges are called.
template <class Input = Flanged>
constexpr auto flanged_inputs(const char* depth, const char* width, const char* flange) {
  return Fields{
      Field<Input, Length>{&Input::h, "h", mm, depth}.positive().usually(0.1, 1e4),
      Field<Input, Length>{&Input::b, "b", mm, width}.positive().usually(0.1, 1e4),
      Field<Input, Length>{&Input::t_w, "t_w", mm, "thickness of the web"}.positive(),
      Field<Input, Length>{&Input::t_f, "t_f", mm, flange}.positive(),
      Field<Input, Length>{&Input::r, "r", mm, "radius of the fillets; omitted: none"}.at_least(0).may_be_missing()};
}

}  // namespace loadpath::section
