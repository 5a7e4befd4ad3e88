// Bounds on typed inputs that a calculator can derive from the other inputs: the shape factor of a shoulder of given
// dimensions, the buckling curve of a section. A value more favourable than the bound needs a justification:
// because.alpha_b = "...".
#pragma once

#include <array>
#include <cstddef>

namespace loadpath {

/// The part of a Bound that does not depend on the type of the input.
struct BoundInfo {
  const char* field = "";       // path of the input: "alpha_b"
  const char* text = "";        // description of the bound, in messages: "the shoulder D, d, r"
  bool is_least = false;        // smaller values are more favourable; otherwise larger ones
  bool spares_results = false;  // does not apply to results of other steps
  const char* source_has = "";  // applies only if the record that a load comes from has this key: "length"
};

/// `value`: in SI, for a choice its index; NaN if the input is not bounded. Of a field of a list, "stages.eta":
/// `value_of` the element.
template <class Input>
struct Bound : BoundInfo {
  double (*value)(const Input&) = nullptr;
  double (*value_of)(const Input&, std::size_t element) = nullptr;

  constexpr Bound(const char* key, const char* what, double (*most)(const Input&))
      : BoundInfo{key, what}, value(most) {}
  constexpr Bound(const char* key, const char* what, double (*most)(const Input&, std::size_t))
      : BoundInfo{key, what}, value_of(most) {}

  [[nodiscard]] double at(const Input& in, std::size_t element) const {
    return value_of == nullptr ? value(in) : value_of(in, element);
  }

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
