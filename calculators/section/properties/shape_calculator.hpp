// Common base of the calculators of single shapes: a shape gives its own area, second moments and contour; moduli,
// principal axes and figures follow.
#pragma once

#include "calculators/section/properties/outline.hpp"
#include "lib/calculator/mode.hpp"

#include <array>

namespace loadpath::section {

/// The base of a shape that declares
///   template <class Tracer> static Result own(const Input&, Tracer&);  // without what follows from the contour
///   static Extremes extremes(const Input&);
///   static Contours contours(const Input&);
///   static void describe(const Input&, SectionRecord&);  // kind and dimensions
/// and defines them in its source, `own` for NoTrace and Trace.
template <class Shape>
struct ShapeCalculator {
  template <class Input, class Tracer>
  static auto evaluate(const Input& in, Tracer& trace) {
    auto result = completed(Shape::own(in, trace), Shape::extremes(in), trace);
    Shape::describe(in, result.section);
    return result;
  }
  template <class Input>
  static std::vector<figure::Figure> figures(const Input& in, const Properties& r) {
    return section::figures(Shape::contours(in), r);
  }
};

}  // namespace loadpath::section
