#include "calculators/fatigue/din743/din743.hpp"

#include "calculators/fatigue/din743/safety.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::fatigue {

template <class Tracer>
Din743::Result Din743::evaluate(const Input& in, Tracer& trace) {
  Result r{din743(in, in, din743_loads(in), trace)};
  compare_with_steel(in.E, r, "its formulas are those of steels", trace);
  return r;
}

template Din743::Result Din743::evaluate(const Input&, NoTrace&);
template Din743::Result Din743::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Din743>();
