#include "calculators/fatigue/din743/din743.hpp"

#include "calculators/fatigue/din743/safety.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::fatigue {

template <class Tracer>
Din743::Result Din743::evaluate(const Input& in, Tracer& trace) {
  Result r{din743(in, in, din743_loads(in), trace)};
  if (is_set(in.E)) {
    STEP_TO(r, x_E, in.E / (210.0 * GPa), "its formulas are those of steels");
  }
  return r;
}

template Din743::Result Din743::evaluate(const Input&, NoTrace&);
template Din743::Result Din743::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Din743>();
