// Laws of motion as formulas of the time t: coordinates of a point, angles, forces.
#pragma once

#include "lib/calculator/law_text.hpp"
#include "lib/numerics/jet.hpp"
#include "lib/quantity/units.hpp"
#include "lib/text/issue.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace loadpath::motion {

inline constexpr Law::Variable time_variable{"t", sec.dimension()};

using LengthLaw = LawOf<m, time_variable>;
using AngleLaw = LawOf<deg, time_variable>;
using ForceLaw = LawOf<N, time_variable>;

/// A formula of an input with the key that it was given under.
struct Written {
  const char* key;
  const LawText* text;
};

/// Whether a formula is a law; an empty one, equal to zero, is.
bool reads(const Written& written);
/// Error of the first invalid law, at its key; empty if all are valid.
FieldFault reading_fault(std::span<const Written> laws);

/// Value and derivatives at a time, SI: zero for an empty formula, NaN for an invalid law.
numerics::Jet at(const Written& written, double t);

/// The value, or zero if it is only rounding relative to `scale`.
double without_rounding(double value, double scale);

/// Whether value and both derivatives are there, and of sizes that machines have.
bool is_finite(const numerics::Jet& jet);

/// Where a law has no value or derivatives, or leaps between two places that follow each other; none where it has all.
struct Gap {
  double from = std::numeric_limits<double>::quiet_NaN(), to = from;

  explicit operator bool() const { return !std::isnan(from); }
};
/// The first of `count` places from t_1 to t_2, their ends included, or between two of them.
Gap first_gap(const std::function<numerics::Jet(double)>& law, double t_1, double t_2, int count = 257);
/// None also if the formula is an invalid law, which another rule reports.
Gap first_gap(const Written& written, double t_1, double t_2);
/// A message for the first law that has one.
FieldFault gap_fault(std::span<const Written> laws, double t_1, double t_2);

/// The integral of a function of time, adaptive to a relative error of about 1e-10.
double integral(double (*function)(const void* data, double t), const void* data, double t_1, double t_2);

}  // namespace loadpath::motion
