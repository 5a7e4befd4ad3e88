#include "calculators/gear/sizing/sizing.hpp"

#include "calculators/gear/pair.hpp"
#include "calculators/gear/sizing/search.hpp"
#include "calculators/gear/sizing/teeth.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::gear {

namespace {

using Input = PairSizing::Input;
using Result = PairSizing::Result;

void compare(const Input& in, const sizing::Found& best, Result& r) {
  const double first = sizing::measure_of(best.row, in.by);
  for (auto* list : {&r.candidates, &r.rejected}) {
    for (auto& c : *list) c.excess = sizing::measure_of(c, in.by) / first - 1.0;
  }
}

/// The choice, as the formulas of gear.rating name it.
template <class Tracer>
void show(const Input& in, const RatingTypes::Input& teeth, const char* which, Result& r, Tracer& trace) {
  r.m_n = trace.value("m_n", teeth.m_n, which);
  r.z_1 = teeth.z_1, r.z_2 = teeth.z_2;
  const double z_1 = trace.value("z_1", static_cast<double>(r.z_1), which);
  const double z_2 = trace.value("z_2", static_cast<double>(r.z_2), which);
  r.beta = trace.angle("beta", teeth.beta, which);
  r.x_1 = trace.value("x_1", teeth.x_1, which);
  r.b = trace.value("b", teeth.b, which);
  const PairResult g = rating::geometry_of(teeth);
  r.x_2 = trace.value("x_2", g.x_2, which);
  r.a_w = trace.value("a_w", g.a_w, "working centre distance by gear.pair");
  const Length d_1 = r.d_1 = trace.value("d_1", g.d_1, "reference circle of gear 1");
  const Length d_2 = r.d_2 = trace.value("d_2", g.d_2, "reference circle of gear 2");
  STEP_TO(r, i, z_2 / z_1, "gear ratio");
  STEP_TO(r, dev_i, r.i / in.i_set - 1.0, "against the required one");
  STEP_TO(r, psi_d, r.b / d_1, "face width over the diameter of gear 1");
  STEP_TO(r, mass, pi / 4.0 * in.rho * (d_1 * d_1 + d_2 * d_2) * r.b, "both gears as solid cylinders");
}

/// Specific sliding where contact begins and ends: it is largest at the roots.
template <class Tracer>
void sliding(const RatingTypes::Input& teeth, Result& r, Tracer& trace) {
  const PairResult g = rating::geometry_of(teeth);
  const double u = trace.value("u", g.u, "gear ratio of the teeth"),
               alpha_wt = trace.angle("alpha_wt", g.alpha_wt, "working pressure angle");
  const Length d_a1 = trace.value("d_a1", g.d_a1, "tip circle"), d_a2 = trace.value("d_a2", g.d_a2, "tip circle");
  const Length d_b1 = trace.value("d_b1", g.d_b1, "base circle"), d_b2 = trace.value("d_b2", g.d_b2, "base circle");
  STEP(l_T, r.a_w * sin(alpha_wt), "line of action between the base circles");
  STEP(rho_a1, sqrt(d_a1 * d_a1 - d_b1 * d_b1) / 2.0, "radius of the flank at the tip of gear 1");
  STEP(rho_a2, sqrt(d_a2 * d_a2 - d_b2 * d_b2) / 2.0, "radius of the flank at the tip of gear 2");
  STEP_TO(r, zeta_1, 1.0 - rho_a2 / (u * (l_T - rho_a2)),
          "sliding over rolling velocity at the root of gear 1, where the tip of gear 2 touches it");
  STEP_TO(r, zeta_2, 1.0 - u * rho_a1 / (l_T - rho_a1),
          "sliding over rolling velocity at the root of gear 2, where the tip of gear 1 touches it");
}

}  // namespace

double PairSizing::least_deviation(const Input& in) {
  if (!is_set(in.f_ma)) return unset<double>;
  Result r;
  const sizing::Found best = sizing::search_for(in, r);
  return is_set(best.teeth.m_n) ? Rating::least_deviation(best.teeth) : unset<double>;
}

template <class Tracer>
PairSizing::Result PairSizing::evaluate(const Input& in, Tracer& trace) {
  Result r;
  sizing::torque_of(in, trace);
  const sizing::Found best = sizing::search_for(in, r);
  trace.value("tried", r.tried, "modules, numbers of teeth and helix angles of the range");
  trace.value("found", r.found, "of them pass every check and limit of gear.rating, ten at most, in the ranking order");
  if (!is_set(best.teeth.m_n)) return r;
  compare(in, best, r);
  show(in, best.teeth, r.found > 0.0 ? "best pair" : "nearest pair: none passes", r, trace);
  sliding(best.teeth, r, trace);
  static_cast<RatingTypes::Result&>(r) = Rating::evaluate(best.teeth, trace);
  r.best = {best.teeth};
  return r;
}

std::vector<figure::Figure> PairSizing::figures(const Input& in, const Result& r) {
  if (!is_set(r.m_n)) return {};
  Pair::Input pair = rating::pair_of(r.best);
  pair.T_1 = r.best.T_1, pair.n_1 = in.n_1;
  NoTrace quiet;
  return Pair::figures(pair, Pair::evaluate(pair, quiet));
}

template PairSizing::Result PairSizing::evaluate(const Input&, NoTrace&);
template PairSizing::Result PairSizing::evaluate(const Input&, Trace&);

}  // namespace loadpath::gear

template const loadpath::Calculator& loadpath::erased<loadpath::gear::PairSizing>();
