#include "calculators/shaft/design/schools.hpp"

#include "calculators/fatigue/combined.hpp"
#include "calculators/fatigue/din743/safety.hpp"
#include "calculators/fatigue/fkm/fields.hpp"
#include "calculators/fatigue/fkm/safety.hpp"

namespace loadpath::shaft {

namespace {

using fatigue::Din743Stress;
using fatigue::Endurance;
using fatigue::FkmSteelGroup;
using Input = DesignInput;

/// A steel of FKM by its group; castings are none.
FkmSteelGroup steel_of(Endurance::Group group) {
  switch (group) {
    case Endurance::Group::carbon_steel:
    case Endurance::Group::alloy_steel:
      return FkmSteelGroup::quenched_tempered;
    case Endurance::Group::case_hardening_steel:
      return FkmSteelGroup::case_hardening;
    case Endurance::Group::stainless_steel:
      return FkmSteelGroup::stainless;
    default:
      return FkmSteelGroup::untold;
  }
}

/// With the strengths as they are in this size; the safety is a factor on the full load.
fatigue::FkmSafety rated_by_fkm(const Input& in, const fatigue::Din743Section& section, const Stressed& t) {
  fatigue::FkmSteel steel;
  steel.steel = steel_of(in.group), steel.R_m = in.R_m, steel.R_e = in.R_e;
  fatigue::Din743Loads loads;
  loads.sigma_zd = {t.axial.m, t.axial.a};
  loads.sigma_b = {t.bending.m, t.bending.a};
  loads.tau_t = {t.torsion.m, t.torsion.a};
  fatigue::FkmService service;
  service.j_D = 1.0;
  NoTrace quiet;
  return fatigue::fkm_section(steel, section, loads, service, quiet);
}

/// By Serensen, with the limits of the section in bending and torsion that DIN 743 finds: its K_sigma is his K_D.
double rated_by_serensen(const Input& in, const fatigue::Din743Safety& rated, const Stressed& t) {
  fatigue::Combined::Input c;
  c.sigma_m = t.axial.m + t.bending.m, c.sigma_a = t.axial.a + t.bending.a;
  c.tau_m = t.torsion.m, c.tau_a = t.torsion.a;
  c.sigma_D = fatigue::of_stress(rated, "bending", &Din743Stress::sigma_WK, unset<Stress>);
  c.tau_D = fatigue::of_stress(rated, "torsion", &Din743Stress::sigma_WK, unset<Stress>);
  c.K_sigma = fatigue::of_stress(rated, "bending", &Din743Stress::K_sigma, unset<double>);
  c.K_tau = fatigue::of_stress(rated, "torsion", &Din743Stress::K_sigma, unset<double>);
  c.R_m = in.R_m, c.S_D = in.S_D;
  NoTrace quiet;
  if (!fatigue::Combined::varies(c)) return fatigue::any_safety;
  return fatigue::Combined::evaluate(c, quiet).n_Serensen;
}

}  // namespace

template <class Tracer>
void other_schools(const Input& in, const fatigue::Din743Section& section, const Stressed& stressed,
                   const fatigue::Din743Safety& rated, double outside, Safety& s, Tracer& trace) {
  if (outside == 0.0)
    s.n_Serensen = trace.value("n_Serensen", rated_by_serensen(in, rated, stressed),
                               "Serensen, as fatigue.combined finds it with K_sigma of DIN 743 for K_D");
  if (in.method == School::serensen) s.x_DIN = outside;
  double left = 1.0;  // value for a casting
  if (steel_of(in.group) != FkmSteelGroup::untold) {
    static constexpr auto fields = fatigue::fkm_results<fatigue::FkmSafety>();
    const fatigue::FkmSafety by_fkm = rated_by_fkm(in, section, stressed);
    left = ranges_left(by_fkm, fields);
    if (left == 0.0) s.n_FKM = trace.value("n_FKM", by_fkm.S_D, "FKM, F2, without j_D, as fatigue.fkm finds it");
  }
  if (in.method == School::fkm) s.x_DIN = left;
}

template void other_schools(const Input&, const fatigue::Din743Section&, const Stressed&, const fatigue::Din743Safety&,
                            double, Safety&, NoTrace&);
template void other_schools(const Input&, const fatigue::Din743Section&, const Stressed&, const fatigue::Din743Safety&,
                            double, Safety&, Trace&);

}  // namespace loadpath::shaft
