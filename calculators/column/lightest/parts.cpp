#include "calculators/column/lightest/parts.hpp"

#include "calculators/column/buckling_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace loadpath::column {

namespace {

using Failure = LightestTypes::Failure;

/// A check or a limit of column.buckling, kept up to 1, and what a section that is above it fails by.
struct Bound {
  double MemberResult::*value;
  Failure failure;
};

/// In the order of the reported reason.
constexpr std::array bounds{
    Bound{&MemberResult::u, Failure::load},       Bound{&MemberResult::x_t, Failure::tension},
    Bound{&MemberResult::u_t, Failure::tension},  Bound{&MemberResult::r_1, Failure::range},
    Bound{&MemberResult::r_0, Failure::range},    Bound{&MemberResult::r_lambda, Failure::slenderness},
    Bound{&MemberResult::r_class, Failure::thin}, Bound{&MemberResult::u_TF, Failure::twisting}};

/// Why the method gives no force: it ends before this bar, or was not tried without a strength or a buckling
/// curve.
Failure reason_without_force(const Buckling::Input& bar, const MemberResult& r) {
  if (r.r_1 > 1.0 || r.r_0 > 1.0) return Failure::range;
  const bool tried = std::any_of(r.methods.begin(), r.methods.end(),
                                 [&](const MethodResult& by) { return by.name.view() == word_of(method_of(bar)); });
  return tried ? Failure::beyond : is_set(bar.R_e) ? Failure::open : Failure::strength;
}

}  // namespace

bool belongs(const TableSection& section, const LightestTypes::Input& in) {
  const bool wanted = std::any_of(in.families.begin(), in.families.end(), [&](const LightestTypes::Family& f) {
    return begins_with(section.name(), f.family.view());
  });
  return wanted && !(section.h > in.h_max) && !(section.b > in.b_max);
}

Stress strength_of(const LightestTypes::Input& in, Length t) {
  if (in.strengths.empty()) return in.R_e;
  const auto found = std::find_if(in.strengths.begin(), in.strengths.end(),
                                  [&](const LightestTypes::Strength& s) { return t <= s.t_max; });
  return found == in.strengths.end() ? unset<Stress> : found->R_e;
}

Buckling::Input bar_of(const LightestTypes::Input& in, const TableSection& section) {
  Buckling::Input bar{in, section};
  bar.R_e = strength_of(in, section.t_f);
  if (bar.kind == SectionKind::unsaid) bar.kind = in.kind;
  const bool is_open = bar.method == Method::unsaid && bar.kind == SectionKind::unsaid;
  if (is_open && default_method(bar, true) == Method::ec3) bar.method = Method::ec3;  // as all the others
  return bar;
}

double demand_of(const MemberResult& r) {
  double demand = 0.0;
  for (const Bound& bound : bounds) {
    if (r.*bound.value > demand) demand = r.*bound.value;
  }
  return demand;
}

LightestTypes::Failure failure_of(const Buckling::Input& bar, const MemberResult& r) {
  if (std::isnan(r.u)) return reason_without_force(bar, r);
  const auto above = std::find_if(bounds.begin(), bounds.end(), [&](const Bound& b) { return r.*b.value > 1.0; });
  return above == bounds.end() ? Failure::none : above->failure;
}

}  // namespace loadpath::column
