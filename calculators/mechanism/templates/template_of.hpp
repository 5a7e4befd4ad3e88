// Makes the erased MechanismTemplate of a template's struct. Included by the source of each template.
#pragma once

#include "calculators/mechanism/templates/template.hpp"
#include "lib/calculator/record_of.hpp"

namespace loadpath::planar::templates {

template <class T>
const MechanismTemplate& mechanism_template() {
  static constexpr MechanismTemplate made = [] {
    MechanismTemplate t;
    t.id = T::id;
    t.title = T::title;
    t.doc = T::doc;
    t.example = T::example;
    t.parameters = &record_type<T, T::fields>;
    t.lay_out = [](void* input) {
      auto& in = *static_cast<Mechanism::Input*>(input);
      Sketch sketch(in, unset<double>);
      T{}.draw(sketch);
      put_zeros(in);
    };
    t.draw = [](const void* parameters, Sketch& sketch) { static_cast<const T*>(parameters)->draw(sketch); };
    t.crank_stop = [](const void* parameters) -> std::optional<FieldFault> {
      if constexpr (requires(const T& of) { of.crank_stop(); }) {
        return static_cast<const T*>(parameters)->crank_stop();
      } else {
        return std::nullopt;
      }
    };
    return t;
  }();
  return made;
}

}  // namespace loadpath::planar::templates
