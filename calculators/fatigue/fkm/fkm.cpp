#include "calculators/fatigue/fkm/fkm.hpp"

#include "calculators/fatigue/fkm/safety.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::fatigue {

template <class Tracer>
Fkm::Result Fkm::evaluate(const Input& in, Tracer& trace) {
  Result r{fkm_section(in, in, acting_loads(in), in, trace)};
  compare_with_steel(in.E, r, "its formulas here are those of steels", trace);
  return r;
}

template Fkm::Result Fkm::evaluate(const Input&, NoTrace&);
template Fkm::Result Fkm::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Fkm>();
