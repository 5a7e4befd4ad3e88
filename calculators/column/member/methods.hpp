// The methods side by side: critical stress, safety, allowable force and utilisation of each.
#pragma once

#include "calculators/column/member/parts.hpp"
#include "calculators/column/member/result.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::column {

/// Whether the input says enough for the method.
inline bool has_method(const Member& in, const Material& material, const MemberResult& r, Method method) {
  const bool yields = is_set(in.R_e);
  switch (method) {
    case Method::euler:
      return is_set(in.E) && (is_set(in.sigma_P) || is_set(material.lambda_T));
    case Method::tetmajer:
      return is_set(in.a_T);
    case Method::johnson:
      return yields;
    case Method::rankine:
      return yields || is_set(in.sigma_c);
    case Method::secant:
      return is_set(r.axes[0].sigma_s);
    case Method::ec3:
      return is_set(r.axes[0].chi) && is_set(r.axes[1].chi);
    case Method::aisc:
      return yields && is_steel(in);
    case Method::sp16:
      return yields && is_steel(in) && is_set(material.sp16.alpha);
    case Method::unsaid:
      break;
  }
  return false;
}

template <class Tracer>
Stress critical_stress(const Member& in, const Material& material, const MemberResult& r, Method method,
                       Tracer& trace) {
  if (method == Method::secant)
    return trace.value("sigma_cr", min(r.axes[0].sigma_s, r.axes[1].sigma_s), "the lower of the two axes");
  if (method == Method::ec3) {
    const double chi = trace.value("chi", std::min(r.axes[0].chi, r.axes[1].chi), "the lower of the two axes");
    return NAMED_STEP("sigma_cr", chi * in.R_e, "EN 1993-1-1 (6.47) without its partial factor, [EN1993-1-1-buckling]");
  }
  return stress_of_slenderness(method, r.lambda, material, trace);
}

/// As given; 1 where EN 1993-1-1 decides.
template <class Tracer>
double partial_factor(const char* symbol, double given, bool is_assumed, const char* why, Tracer& trace) {
  return is_set(given) || !is_assumed ? given : trace.value(symbol, 1.0, why);
}

/// `decides`: whether the check goes by this method.
template <class Tracer>
double safety(const Member& in, Method method, bool decides, Tracer& trace) {
  if (method == Method::ec3) {
    const double gamma_M1 =
        partial_factor("gamma_M1", in.gamma_M1, decides, "assumed: the value that EN 1993-1-1, 6.1, recommends", trace);
    const double gamma_F =
        partial_factor("gamma_F", in.gamma_F, decides, "assumed: the force is a design value", trace);
    if (!is_set(gamma_M1) || !is_set(gamma_F)) return unset<double>;
    return NAMED_STEP("n", gamma_M1 * gamma_F, "partial factors on the resistance and on the load");
  }
  const double n = method == Method::aisc ? in.Omega_c : in.n_st;
  if (is_set(n)) trace.value("n", n, method == Method::aisc ? "AISC 360, E1, [AISC360]" : "safety against buckling");
  return n;
}

inline constexpr auto method_names = [] {
  constexpr auto words = choices_of(Method{});
  std::array<Name, words.size()> names{};
  for (std::size_t i = 0; i < words.size(); ++i) names[i] = words[i].key;
  return names;
}();

/// One line of the methods side by side, and the results where it is the one that decides.
template <class Tracer>
void add_method(const Member& in, const Material& material, Method method, bool decides, MemberResult& r,
                Tracer& trace) {
  [[maybe_unused]] const auto scope = trace.scope("methods", r.methods.size());
  MethodResult by{method_names[static_cast<std::size_t>(method)]};
  const Stress sigma_cr = by.sigma_cr = critical_stress(in, material, r, method, trace);
  const double n = by.n = safety(in, method, decides, trace);
  if (is_set(sigma_cr)) {
    STEP_TO(by, P_cr, sigma_cr * r.A, "critical force");
    if (is_set(n)) {
      STEP_TO(by, P_all, P_cr / n, "allowable force");
      if (is_set(r.F)) by.u = NAMED_STEP("u", r.F / P_all, "force / allowable force");
    }
  }
  r.methods.push_back(by);
  if (decides) r.sigma_cr = by.sigma_cr, r.P_all = by.P_all, r.u = by.u;
}

/// Those that the input says enough for, in the order of their words; without a loop, so that the compiler of a sweep
/// knows which of them there are.
template <class Tracer, std::size_t... k>
void add_methods(const Member& in, const Material& material, Method deciding, MemberResult& r, Tracer& trace,
                 std::index_sequence<k...>) {
  const auto add = [&](Method method) {
    if (has_method(in, material, r, method)) add_method(in, material, method, method == deciding, r, trace);
  };
  (add(choices_of(Method{})[k].value), ...);
}

/// How far the methods that hold here lie apart.
inline double spread_of(const MemberResult& r) {
  double least = unset<double>, most = least;
  for (const auto& by : r.methods) {
    const double sigma = in_si(by.sigma_cr);
    if (!is_set(sigma)) continue;
    if (!(sigma >= least)) least = sigma;
    if (!(sigma <= most)) most = sigma;
  }
  return most / least - 1.0;
}

}  // namespace loadpath::column
