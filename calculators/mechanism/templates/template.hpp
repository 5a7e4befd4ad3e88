// A mechanism that is known in shape: a few lengths of its own in place of links, joints and points.
//
// A template is one source in this folder and one line in all.cpp. It is a struct whose members are its parameters:
//
//   struct SliderCrank {
//     static constexpr auto id = "slider_crank", title = "...", doc = "...", example = "...";
//     Length r = unset<Length>, ...;
//     static constexpr Fields fields{Field{...}...};
//     void draw(Sketch&) const;                               // every link, joint and point at the first position
//     std::optional<FieldFault> crank_stop() const;           // where a crank drives: why it cannot turn round
//   };
//   template const MechanismTemplate& mechanism_template<SliderCrank>();
//
// The names in `draw` do not depend on the parameters, and it is also called with none of them given: the names are
// wanted before the values are.
#pragma once

#include "calculators/mechanism/templates/sketch.hpp"
#include "lib/calculator/calculator.hpp"

#include <optional>
#include <span>

namespace loadpath::planar::templates {

struct MechanismTemplate : Template {
  void (*draw)(const void* parameters, Sketch& sketch) = nullptr;
  std::optional<FieldFault> (*crank_stop)(const void* parameters) = nullptr;
};

/// The erased form of a template's struct: defined by template_of.hpp, instantiated in the template's source.
template <class T>
const MechanismTemplate& mechanism_template();

/// All of them, in the order of the documentation.
std::span<const Template* const> all();

}  // namespace loadpath::planar::templates
