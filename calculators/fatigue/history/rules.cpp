// Rules of fatigue.history beyond the bounds of its fields.
#include "calculators/fatigue/history/curve.hpp"
#include "calculators/fatigue/history/cycles.hpp"
#include "calculators/fatigue/history/history.hpp"
#include "calculators/fatigue/history/means.hpp"
#include "calculators/fatigue/history/weighing.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::fatigue {

namespace {

using Input = History::Input;
using Curve = History::Curve;
using Means = History::Means;
using Detail = History::Detail;

bool any_given(std::initializer_list<double> numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [](double x) { return is_set(x); });
}

/// The first block that comes less than half a cycle in all passages; past the last where none does.
std::size_t rare_block(const Input& in) {
  const auto rare = [&](const History::Block& b) { return b.sigma_a > 0.0 * MPa && in.n_req * b.n < 0.5 - 1e-9; };
  return static_cast<std::size_t>(std::find_if(in.blocks.begin(), in.blocks.end(), rare) - in.blocks.begin());
}

}  // namespace

Applies History::has_tension(const Input& in) {
  if (!is_of_part(in) || in.mean != Means::none) return Applies::no;
  return where(has_tensile_mean(in));
}

bool History::one_source(const Input& in) { return is_set(in.sigma) == in.blocks.empty(); }

bool History::curve_given(const Input& in) {
  switch (in.curve) {
    case Curve::en1993:
      return is_set(in.sigma_C);
    case Curve::dnv:
      return in.detail != Detail::untold || is_set(in.lg_a);
    case Curve::part:
      break;
  }
  return is_set(in.sigma_D) && is_set(in.N_D) && is_set(in.k);
}

FieldFault History::missing_of_curve(const Input& in) {
  if (in.curve == Curve::en1993)
    return {"sigma_C", say("the detail of EN 1993-1-9 needs its category"), say("sigma_C")};
  if (in.curve == Curve::dnv)
    return {"detail", say("the curve of DNV-RP-C203 needs its detail"), say("detail = \"C\"")};
  return {"sigma_D", say("the curve of a part needs sigma_D, N_D and k"),
          say("sigma_D of fatigue.endurance, or curve = \"en1993\" of a welded detail")};
}

bool History::curve_alone(const Input& in) {
  const bool of_part = any_given({in_si(in.sigma_D), in.N_D, in.k});
  const bool of_en = is_set(in.sigma_C),
             of_dnv = in.detail != Detail::untold || any_given({in.lg_a, in.m_1, in.m_2, in.N_1});
  return (in.curve == Curve::part || !of_part) && (in.curve == Curve::en1993 || !of_en) &&
         (in.curve == Curve::dnv || !of_dnv);
}

/// At no life above the best detail of its slope: what lies above has the numbers of two branches mixed.
bool History::curve_is_of_dnv(const Input& in) {
  if (in.curve != Curve::dnv || !curve_given(in) || !slopes_fall(in)) return true;
  Input best;
  best.curve = Curve::dnv;
  best.detail = in.m_1 >= 4.0 || branch_of(in.detail).m_1 == 4.0 ? Detail::B1 : Detail::C;
  const rainflow::SnCurve own = curve_of(in), highest = curve_of(best);
  constexpr double digits = 1.005;  // rounding of a stress, from lg a in three decimals
  for (const double N : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10}) {
    const auto S = own.stress(N), most = highest.stress(N);
    if (S && most && *S > digits * *most) return false;
  }
  return true;
}

bool History::comes_once(const Input& in) { return !is_set(in.n_req) || rare_block(in) == in.blocks.size(); }

FieldFault History::comes_never(const Input& in) {
  const std::size_t i = rare_block(in);
  if (i == in.blocks.size()) return {};
  return {"blocks[" + std::to_string(i + 1) + "].n",
          say("with n_req = {1} this block occurs {2} times: a block must occur at least once", format_number(in.n_req),
              format_number(in.n_req * in.blocks[i].n)),
          say("raise n, or n_req")};
}

bool History::slopes_fall(const Input& in) {
  const double named = branch_of(in.detail).m_1;
  const double m_1 = is_set(named) ? named : is_set(in.m_1) ? in.m_1 : 3.0;
  return in.curve != Curve::dnv || (is_set(in.m_2) ? in.m_2 : 5.0) > m_1;
}

bool History::mean_suits(const Input& in) {
  if (!is_of_part(in)) return in.mean == Means::none;
  return in.stress == Stresses::normal ||
         (in.mean != Means::swt && in.mean != Means::walker && in.mean != Means::morrow);
}

bool History::mean_given(const Input& in) { return !counts_means(in) || knows(haigh_of(in), rule_of(in)); }

bool History::varies(const Input& in) {
  if (!in.sigma.is_series()) return true;
  const std::vector<double>& si = in.sigma.series->si;
  return std::any_of(si.begin(), si.end(), [&](double x) { return x != si.front(); });
}

bool History::may_be_left(const Input& in) { return !is_turn(in) || in.residue == Residue::repeated; }

}  // namespace loadpath::fatigue
