// What a calculator itself knows beside a typed input: the shape factor of a shoulder whose sizes stand beside it, the
// buckling curve that the code has for the section. A typed value on the bolder side of it is the user's word, and
// wants a reason: because.alpha_b = "...".
#pragma once

#include <array>
#include <cstddef>

namespace loadpath {

/// What is known of a bound without the type of its input.
struct BoundInfo {
  const char* field = "";       // of the input: "alpha_b"
  const char* text = "";        // what bounds it, in messages: "the shoulder D, d, r"
  bool is_least = false;        // a value below it is bolder; else one above it
  bool spares_results = false;  // a value that another step has found is not typed
  const char* source_has = "";  // it holds where a load of the step comes from what has this key too: "length"
};

/// `value`: in SI, of a choice the number of its word; NaN where nothing bounds the input.
template <class Input>
struct Bound : BoundInfo {
  double (*value)(const Input&);

  constexpr Bound(const char* key, const char* what, double (*most)(const Input&))
      : BoundInfo{key, what}, value(most) {}

  [[nodiscard]] constexpr Bound least() const {
    Bound bound = *this;
    bound.is_least = true;
    return bound;
  }
  [[nodiscard]] constexpr Bound sparing_results() const {
    Bound bound = *this;
    bound.spares_results = true;
    return bound;
  }
  [[nodiscard]] constexpr Bound where_source_has(const char* key) const {
    Bound bound = *this;
    bound.source_has = key;
    return bound;
  }
};

/// The bounds of a calculator class without the type of its input.
template <class C>
inline constexpr auto bound_infos = [] {
  std::array<BoundInfo, C::bounds.size()> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = C::bounds[i];
  return infos;
}();

}  // namespace loadpath
