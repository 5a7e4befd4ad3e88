#include "calculators/machine/law_period.hpp"
#include "calculators/machine/motion/motion.hpp"
#include "calculators/motion/laws.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace loadpath::machine {

namespace {

/// A formula of the crank angle, with its key and its unit.
struct LawOfAngle {
  const char* key;
  const LawText* text;
  const char* unit;
};

std::array<LawOfAngle, 2> laws_of(const Motion::Input& in) {
  return {{{"M_of_phi", &in.M_of_phi, N_m.symbol}, {"J_of_phi", &in.J_of_phi, kg_m2.symbol}}};
}

FieldFault gap_of(const LawOfAngle& one, const Law& law, double period) {
  const auto values = [&](double phi) {  // whose slope may be infinite, as at the end of a root
    const numerics::Jet jet = law.at(phi);
    return std::isfinite(jet.first) && std::isfinite(jet.second) ? jet : numerics::Jet{jet.value, 0.0, 0.0};
  };
  const motion::Gap gap = motion::first_gap(values, 0.0, period * (1.0 - 1e-12), 721);
  if (!gap) return {};
  const std::string place = format_quantity(gap.from, deg.symbol, 4);
  if (gap.from < gap.to)
    return {one.key, say("near phi = {1} the formula jumps, or varies too fast to be followed", place),
            say("it has a pole there, or too many oscillations in the period; give a jump of the load by points")};
  return {one.key, say("the formula has no value at phi = {1}", place),
          say("it divides by zero there, or takes a root or an arc function outside its range")};
}

FieldFault repetition_of(const LawOfAngle& one, const Law& law, double period) {
  const auto found = unrepeated(law, period);
  if (!found) return {};
  const auto value = [&](double si) { return format_quantity(si, one.unit, 4); };
  const std::string length = format_quantity(period, deg.symbol, 5);
  return {one.key,
          found->leaps ? say("the formula does not repeat after {1}: it jumps there from {2} to {3}", length,
                             value(found->here), value(found->later))
                       : say("the formula does not repeat after {1}: it is {2} at {3}, and {4} a period later", length,
                             value(found->here), format_quantity(found->phi, deg.symbol, 4), value(found->later)),
          say("give the period after which it repeats, as period = \"720 deg\"")};
}

FieldFault fault_of(const LawOfAngle& one, double period) {
  if (one.text->empty()) return {};
  if (const Fault* const fault = one.text->fault()) return {one.key, fault->message, fault->hint};
  const Law& law = *one.text->law();
  FieldFault gap = gap_of(one, law, period);
  return gap.message.empty() ? repetition_of(one, law, period) : gap;
}

}  // namespace

bool Motion::has_one_load(const Input& in) {
  return (is_set(in.M) ? 1 : 0) + (in.M_of_phi.empty() ? 0 : 1) + (in.points.empty() ? 0 : 1) == 1;
}

bool Motion::has_one_motor(const Input& in) {
  const bool formula = is_set(in.M_A) || is_set(in.M_K);
  if (formula && !is_set(in.n_0)) return false;
  return (in.motor.empty() ? 0 : 1) + (is_set(in.M_A) ? 1 : 0) + (is_set(in.M_K) ? 1 : 0) == 1;
}

bool Motion::laws_read(const Input& in) { return law_fault(in).message.empty(); }

FieldFault Motion::law_fault(const Input& in) {
  for (const LawOfAngle& one : laws_of(in)) {
    FieldFault fault = fault_of(one, in.period);
    if (!fault.message.empty()) return fault;
  }
  return {};
}

bool Motion::points_rise(const Input& in) {
  if (in.points.empty()) return true;
  for (std::size_t k = 1; k < in.points.size(); ++k) {
    if (in.points[k].phi < in.points[k - 1].phi) return false;
  }
  const double length = in.points.back().phi - in.points.front().phi;
  return in.points.size() >= 2 && length > 0.0 && length <= in.period * (1.0 + 1e-12);
}

bool Motion::motor_rises(const Input& in) {
  if (in.motor.empty()) return true;
  for (std::size_t k = 1; k < in.motor.size(); ++k) {
    if (!(in.motor[k].n > in.motor[k - 1].n)) return false;
  }
  return in.motor.size() >= 2 && in_si(in.motor.front().n) == 0.0;
}

bool Motion::has_inertia(const Input& in) {
  const Law* const law = in.J_of_phi.law();
  if (law == nullptr) return true;
  const double constant = in_si(in.J_F) + in_si(in.J_M) * in.i * in.i;
  constexpr int places = 720;
  for (int k = 0; k < places; ++k) {
    if (!(law->at(in.period * k / places).value + constant > 0.0)) return false;
  }
  return true;
}

}  // namespace loadpath::machine
