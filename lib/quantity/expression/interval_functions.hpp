// The functions of the expression language over intervals, as lib/numerics/jet.hpp has them at a place.
#pragma once

#include "lib/quantity/expression/interval.hpp"

namespace loadpath::expression {

IntervalJet operator-(const IntervalJet& a);
IntervalJet operator+(const IntervalJet& a, const IntervalJet& b);
IntervalJet operator-(const IntervalJet& a, const IntervalJet& b);
IntervalJet operator*(const IntervalJet& a, const IntervalJet& b);
IntervalJet operator/(const IntervalJet& a, const IntervalJet& b);

/// To a constant power.
IntervalJet pow(const IntervalJet& a, double exponent);
IntervalJet sqrt(const IntervalJet& a);
IntervalJet cbrt(const IntervalJet& a);
IntervalJet exp(const IntervalJet& a);
/// To the base e.
IntervalJet log(const IntervalJet& a);
IntervalJet sin(const IntervalJet& a);
IntervalJet cos(const IntervalJet& a);
IntervalJet tan(const IntervalJet& a);
IntervalJet atan(const IntervalJet& a);
IntervalJet asin(const IntervalJet& a);
IntervalJet acos(const IntervalJet& a);
IntervalJet atan2(const IntervalJet& y, const IntervalJet& x);

}  // namespace loadpath::expression
