#include "calculators/dynamics/inertia/inertia.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::dynamics {

namespace {

using Part = Inertia::Part;
using Shape = Inertia::Shape;

struct Size {
  const char* key;
  Length Part::*at;
};
constexpr std::array<Size, 5> sizes{
    {{"D", &Part::D}, {"d_i", &Part::d_i}, {"h", &Part::h}, {"a", &Part::a}, {"b", &Part::b}}};

/// Keys of a shape: all that it takes, those without which it has no moment of inertia, and no volume.
struct Keys {
  std::string_view takes, needs, of_volume;
};

Keys keys_of(Shape shape) {
  switch (shape) {
    case Shape::cylinder:
      return {" D d_i h ", " D ", " D h "};
    case Shape::rod:
      return {" D d_i h ", " h ", " D h "};
    case Shape::cone:
      return {" D h ", " D ", " D h "};
    case Shape::sphere:
      return {" D d_i ", " D ", " D "};
    case Shape::cuboid:
      return {" a b h ", " a b ", " a b h "};
    case Shape::point:
    case Shape::other:
      break;
  }
  return {};
}

bool has(std::string_view keys, const char* key) {
  return keys.find(" " + std::string(key) + " ") != std::string_view::npos;
}

std::string word_of(Shape shape) {
  for (const auto& name : choices_of(Shape())) {
    if (name.value == shape) return name.key;
  }
  return {};
}

/// The first size that is missing of those that `keys` names; null if all are there.
const char* missing(const Part& p, std::string_view keys) {
  const auto found =
      std::ranges::find_if(sizes, [&](const Size& size) { return has(keys, size.key) && !is_set(p.*size.at); });
  return found == sizes.end() ? nullptr : found->key;
}

FieldFault size_fault(const Part& p) {
  const Keys keys = keys_of(p.shape);
  const std::string shape = word_of(p.shape);
  for (const Size& size : sizes) {
    if (is_set(p.*size.at) && !has(keys.takes, size.key))
      return {size.key, say("the shape {1} has no size {2}", shape, size.key), say("omit it, or change the shape")};
  }
  if (const char* const key = missing(p, keys.needs))
    return {key, say("the shape {1} needs {2}", shape, key), say("give it")};
  // a shell or ring without thickness has a moment of inertia, but no volume
  if (is_set(p.D) && is_set(p.d_i) && (is_set(p.mass) ? p.d_i > p.D : !(p.d_i < p.D)))
    return {"d_i", say("the inner diameter must be smaller than the outer diameter D"), say("change d_i or D")};
  return {};
}

FieldFault mass_fault(const Part& p, bool density) {
  if (is_set(p.mass) && is_set(p.rho)) return {"rho", say("m and rho are both given"), say("omit one of them")};
  if (is_set(p.mass)) return {};
  const Keys keys = keys_of(p.shape);
  if (keys.of_volume.empty()) return {"m", say("the shape {1} needs its mass", word_of(p.shape)), say("give m")};
  if (!density && !is_set(p.rho))
    return {"", say("the part has neither a mass nor a density"), say("give m, or rho of the part or of all parts")};
  if (const char* const key = missing(p, keys.of_volume))
    return {key, say("the mass from the density needs {1}", key), say("give it, or m in place of rho")};
  return {};
}

FieldFault direction_fault(const Part& p) {
  const bool inclined = is_set(p.beta) && p.beta != 0.0;
  if (p.shape == Shape::rod && !is_set(p.beta))
    return {"beta", say("a rod needs the angle of its axis to z"), say("give 90° across the axis, 0° along it")};
  if (p.shape == Shape::cone && inclined && !is_set(p.h))
    return {"h", say("an inclined cone needs its height h"), say("give it")};
  const bool of_revolution = p.shape == Shape::cylinder || p.shape == Shape::rod || p.shape == Shape::cone;
  if (inclined && !of_revolution)
    return {"beta", say("the shape {1} takes no angle beta", word_of(p.shape)),
            say("omit beta; for an inclined cuboid give shape other with J_c")};
  return {};
}

FieldFault moment_fault(const Part& p) {
  if (p.shape == Shape::other && !is_set(p.J_c))
    return {"J_c", say("the shape other needs its moment of inertia J_c"), say("give it, or point")};
  if (p.shape != Shape::other && is_set(p.J_c))
    return {"J_c", say("the sizes of the shape {1} determine J_c", word_of(p.shape)), say("omit it, or give other")};
  return {};
}

FieldFault fault_of(const Part& p, bool density) {
  for (FieldFault fault : {size_fault(p), mass_fault(p, density), direction_fault(p), moment_fault(p)}) {
    if (!fault.message.empty()) return fault;
  }
  return {};
}

}  // namespace

bool Inertia::parts_are_complete(const Input& in) { return incomplete(in).message.empty(); }

FieldFault Inertia::incomplete(const Input& in) {
  for (std::size_t i = 0; i < in.parts.size(); ++i) {
    FieldFault fault = fault_of(in.parts[i], is_set(in.rho));
    if (fault.message.empty()) continue;
    const std::string place = "parts[" + std::to_string(i + 1) + "]";
    fault.path = fault.path.empty() ? place : place + "." + fault.path;
    return fault;
  }
  return {};
}

}  // namespace loadpath::dynamics
