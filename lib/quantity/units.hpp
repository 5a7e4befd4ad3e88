// Quantities at compile time: the only file with boost::units. In an optimised build a quantity is a double.
//
// Moments are N*m for bending and torsion alike; an angle is a double in rad; an angular velocity is 1/s. Distinctions
// that the types do not make (deg from %, rpm from Hz, N*m from J) are part of the Unit of a field.
#pragma once

#include "lib/numerics/cube_root.hpp"
#include "lib/quantity/dimension.hpp"

#include <boost/units/cmath.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/systems/si/acceleration.hpp>
#include <boost/units/systems/si/area.hpp>
#include <boost/units/systems/si/energy.hpp>
#include <boost/units/systems/si/force.hpp>
#include <boost/units/systems/si/frequency.hpp>
#include <boost/units/systems/si/length.hpp>
#include <boost/units/systems/si/mass.hpp>
#include <boost/units/systems/si/power.hpp>
#include <boost/units/systems/si/pressure.hpp>
#include <boost/units/systems/si/temperature.hpp>
#include <boost/units/systems/si/time.hpp>
#include <boost/units/systems/si/velocity.hpp>
#include <boost/units/systems/si/volume.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace loadpath {

namespace si = boost::units::si;

using std::numbers::pi;

using Length = boost::units::quantity<si::length>;
using Area = boost::units::quantity<si::area>;
using SectionModulus = boost::units::quantity<si::volume>;
using SecondMoment = decltype(Area() * Area());
using Mass = boost::units::quantity<si::mass>;
using MassArm = decltype(Mass() * Length());
using MassMoment = decltype(Mass() * Area());
using Time = boost::units::quantity<si::time>;
using Heating = boost::units::quantity<si::temperature>;  // a difference, never a point on the scale
using Expansion = decltype(1.0 / Heating());
using Force = boost::units::quantity<si::force>;
using Moment = boost::units::quantity<si::energy>;
using Stress = boost::units::quantity<si::pressure>;
using Speed = boost::units::quantity<si::velocity>;
using Acceleration = boost::units::quantity<si::acceleration>;
using AngularSpeed = boost::units::quantity<si::frequency>;
using AngularAcceleration = decltype(AngularSpeed() / Time());
using Twist = decltype(1.0 / Length());  // angle per length
using Power = boost::units::quantity<si::power>;
using Stiffness = decltype(Force() / Length());
using Damping = decltype(Force() / Speed());
using TurningDamping = decltype(Moment() * Time());

// The functions that formulas use, for quantities and numbers alike.
using boost::units::abs;
using boost::units::pow;
using boost::units::root;
using boost::units::sqrt;
using std::abs;
using std::acos;
using std::asin;
using std::atan;
using std::cos;
using std::exp;
using std::log;
using std::max;
using std::min;
using std::sin;
using std::sqrt;
using std::tan;

// Arguments by value compile to one instruction; std::max takes references and becomes a branch.
template <class Unit, class Number>
[[nodiscard]] auto max(const boost::units::quantity<Unit, Number>& a, const boost::units::quantity<Unit, Number>& b) {
  return boost::units::quantity<Unit, Number>::from_value(std::max(a.value(), b.value()));
}
template <class Unit, class Number>
[[nodiscard]] auto min(const boost::units::quantity<Unit, Number>& a, const boost::units::quantity<Unit, Number>& b) {
  return boost::units::quantity<Unit, Number>::from_value(std::min(a.value(), b.value()));
}

template <class Unit, class Number>
[[nodiscard]] auto cbrt(const boost::units::quantity<Unit, Number>& q) {
  using Result = decltype(root<3>(q));
  return Result::from_value(numerics::cube_root(q.value()));
}

// Functions of a ratio of like quantities, whose unit Boost keeps, as numbers; an angle is a double in rad.
using Ratio = decltype(Length() / Length());
[[nodiscard]] inline double log(const Ratio& x) { return std::log(x.value()); }
[[nodiscard]] inline double asin(const Ratio& x) { return std::asin(x.value()); }
[[nodiscard]] inline double acos(const Ratio& x) { return std::acos(x.value()); }
[[nodiscard]] inline double atan(const Ratio& x) { return std::atan(x.value()); }

/// The result of a formula: a quantity, or a plain number if its dimensions cancel.
template <class Quantity>
[[nodiscard]] constexpr Quantity reduced(const Quantity& q) {
  return q;
}
[[nodiscard]] constexpr double reduced(const Ratio& x) { return x.value(); }

namespace detail {

template <class List>
struct Exponents;
template <>
struct Exponents<boost::units::dimensionless_type> {
  static constexpr Dimension value{};
};
template <class Base>
inline constexpr int place_of = -1;
template <>
inline constexpr int place_of<boost::units::length_base_dimension> = Dimension::length;
template <>
inline constexpr int place_of<boost::units::mass_base_dimension> = Dimension::mass;
template <>
inline constexpr int place_of<boost::units::time_base_dimension> = Dimension::time;
template <>
inline constexpr int place_of<boost::units::temperature_base_dimension> = Dimension::temperature;
template <class Base, class Exponent, class Next>
struct Exponents<boost::units::list<boost::units::dim<Base, Exponent>, Next>> {
  static constexpr Dimension value = [] {
    Dimension d = Exponents<Next>::value;
    d.twelfths[place_of<Base>] =
        static_cast<std::int16_t>(Dimension::one * Exponent::Numerator / Exponent::Denominator);
    return d;
  }();
};

template <class Quantity>
struct Traits;
template <>
struct Traits<double> {
  static constexpr Dimension dimension{};
};
template <class Exponent, class System>
struct Traits<boost::units::quantity<boost::units::unit<Exponent, System>>> {
  static constexpr Dimension dimension = Exponents<Exponent>::value;
};

}  // namespace detail

/// The dimension of a quantity type; an angle in a double is not seen here.
template <class Quantity>
inline constexpr Dimension dimension_of = detail::Traits<Quantity>::dimension;

/// The SI number of a quantity, and back.
inline constexpr double in_si(double number) { return number; }
template <class Unit>
[[nodiscard]] constexpr double in_si(const boost::units::quantity<Unit>& q) {
  return q.value();
}
template <class Quantity>
[[nodiscard]] constexpr Quantity from_si(double number) {
  if constexpr (std::is_same_v<Quantity, double>) {
    return number;
  } else {
    return Quantity::from_value(number);
  }
}

/// A quantity that was not given: a mandatory one must never look like a valid 0.
template <class Quantity>
inline constexpr Quantity unset = from_si<Quantity>(std::numeric_limits<double>::quiet_NaN());

template <class Quantity>
[[nodiscard]] bool is_set(const Quantity& q) {
  return !std::isnan(in_si(q));
}
template <class Quantity>
[[nodiscard]] double si_or_zero(const Quantity& q) {
  return is_set(q) ? in_si(q) : 0.0;
}

/// A unit that a field is read and shown in. It fits one type of quantity; its dimension also knows the angle.
template <class Quantity>
struct Unit {
  const char* symbol;
  Quantity one;
  int angle = 0;  // exponent of the angle
  Kind kind = Kind::plain;

  [[nodiscard]] constexpr Dimension dimension() const {
    return dimension_of<Quantity> * Dimension::of(0, 0, 0, 0, angle);
  }
};

inline constexpr Unit<double> ratio{"-", 1.0};
inline constexpr Unit<double> deg{"deg", pi / 180.0, 1};
inline constexpr Unit<Length> mm{"mm", from_si<Length>(1e-3)};
inline constexpr Unit<Length> m{"m", from_si<Length>(1.0)};
inline constexpr Unit<Area> mm2{"mm^2", from_si<Area>(1e-6)};
inline constexpr Unit<SectionModulus> mm3{"mm^3", from_si<SectionModulus>(1e-9)};
inline constexpr Unit<SecondMoment> mm4{"mm^4", from_si<SecondMoment>(1e-12)};
inline constexpr Unit<Mass> kg{"kg", from_si<Mass>(1.0)};
inline constexpr Unit<MassArm> kg_mm{"kg*mm", from_si<MassArm>(1e-3)};
inline constexpr Unit<MassMoment> kg_m2{"kg*m^2", from_si<MassMoment>(1.0)};
inline constexpr Unit<Time> sec{"s", from_si<Time>(1.0)};
inline constexpr Unit<Force> N{"N", from_si<Force>(1.0)};
inline constexpr Unit<Force> kN{"kN", from_si<Force>(1e3)};
inline constexpr Unit<Moment> N_m{"N*m", from_si<Moment>(1.0), 0, Kind::moment};
inline constexpr Unit<Stress> MPa{"MPa", from_si<Stress>(1e6)};
inline constexpr Unit<Stress> GPa{"GPa", from_si<Stress>(1e9)};
inline constexpr Unit<Twist> deg_per_m{"deg/m", from_si<Twist>(pi / 180.0), 1};
inline constexpr Unit<Speed> m_per_s{"m/s", from_si<Speed>(1.0)};
inline constexpr Unit<Acceleration> m_per_s2{"m/s^2", from_si<Acceleration>(1.0)};
inline constexpr Unit<AngularSpeed> rad_per_s{"rad/s", from_si<AngularSpeed>(1.0), 1};
inline constexpr Unit<AngularAcceleration> rad_per_s2{"rad/s^2", from_si<AngularAcceleration>(1.0), 1};
inline constexpr Unit<Stiffness> N_per_mm{"N/mm", from_si<Stiffness>(1e3)};
inline constexpr Unit<Moment> N_m_per_rad{"N*m/rad", from_si<Moment>(1.0), -1};
inline constexpr Unit<Damping> N_s_per_m{"N*s/m", from_si<Damping>(1.0)};
inline constexpr Unit<TurningDamping> N_m_s{"N*m*s/rad", from_si<TurningDamping>(1.0), -1};
inline constexpr Unit<Power> W{"W", from_si<Power>(1.0)};

/// `10.0 * mm` in a formula.
template <class Quantity>
[[nodiscard]] constexpr Quantity operator*(double number, const Unit<Quantity>& unit) {
  return number * unit.one;
}
/// `d / mm` in a formula: the number.
template <class Quantity>
[[nodiscard]] constexpr double operator/(const Quantity& q, const Unit<Quantity>& unit) {
  return in_si(q) / in_si(unit.one);
}

}  // namespace loadpath
