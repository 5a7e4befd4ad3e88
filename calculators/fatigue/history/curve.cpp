#include "calculators/fatigue/history/curve.hpp"

#include <cmath>
#include <vector>

namespace loadpath::fatigue {

namespace {

using Input = HistoryTypes::Input;
using Curve = HistoryTypes::Curve;
using rainflow::SnCurve;
using Branch = SnCurve::Branch;

double in_MPa(Stress s) { return in_si(s) / 1e6; }

SnCurve made(rainflow::Measure measure, SnCurve::Point point, std::vector<Branch> branches) {
  const auto curve = SnCurve::make(measure, point, branches);
  return curve ? *curve : SnCurve();
}

/// [EN1993-1-9] 7.1 (2), (3): normal stresses by slope 3 to 5e6 and 5 to 1e8, shear by 5 to 1e8; nothing below.
SnCurve of_en1993(const Input& in) {
  const SnCurve::Point category{in_MPa(in.sigma_C), 2e6};
  if (in.stress == Stresses::shear) return made(rainflow::Measure::range, category, {{5.0, 1e8}});
  return made(rainflow::Measure::range, category, {{3.0, 5e6}, {5.0, 1e8}});
}

/// [DNVC203] 2.4.1: the branches meet at N_1.
SnCurve of_dnv(const Input& in) {
  const DnvBranch named = branch_of(in.detail);
  const double lg_a = is_set(named.lg_a) ? named.lg_a : in.lg_a;
  const double m_1 = is_set(named.m_1) ? named.m_1 : is_set(in.m_1) ? in.m_1 : 3.0;
  const double m_2 = is_set(in.m_2) ? in.m_2 : 5.0, N_1 = is_set(in.N_1) ? in.N_1 : 1e7;
  const double S = std::pow(10.0, (lg_a - std::log10(N_1)) / m_1);
  return made(rainflow::Measure::range, {S, N_1}, {{m_1, N_1}, {m_2, Branch::endless}});
}

}  // namespace

SnCurve curve_of(const Input& in) {
  switch (in.curve) {
    case Curve::en1993:
      return of_en1993(in);
    case Curve::dnv:
      return of_dnv(in);
    case Curve::part:
      break;
  }
  return made(rainflow::Measure::amplitude, {in_MPa(in.sigma_D), in.N_D}, {{in.k, in.N_D}});
}

double constant_amplitude_limit(const Input& in) {
  const double C = in_MPa(in.sigma_C);
  return in.stress == Stresses::shear ? C * std::pow(2e6 / 1e8, 1.0 / 5.0) : C * std::cbrt(2.0 / 5.0);
}

SnCurve curve_by(HistoryTypes::MinerRule rule, const Input& in, double largest) {
  const SnCurve curve = curve_of(in);
  if (in.curve == Curve::en1993 && largest <= constant_amplitude_limit(in)) return {};
  if (in.curve != Curve::part) return curve;
  using From = HistoryTypes::MinerRule;
  const rainflow::Miner by = rule == From::original     ? rainflow::Miner::original
                             : rule == From::elementary ? rainflow::Miner::elementary
                             : rule == From::liu_zenner ? rainflow::Miner::liu_zenner
                                                        : rainflow::Miner::modified;
  const auto found = rainflow::by_miner(curve, by, largest);
  return found ? *found : SnCurve();
}

}  // namespace loadpath::fatigue
