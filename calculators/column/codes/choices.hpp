// The words that a column's inputs choose from.
#pragma once

#include "calculators/load/section_record.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::column {

/// How the two ends are held. The first of the pair is the start; "guided" cannot turn but moves across.
enum class Ends { unsaid, pinned_pinned, fixed_free, fixed_pinned, fixed_fixed, fixed_guided, pinned_guided };

constexpr auto choices_of(Ends) {
  using E = Ends;
  return std::array{ChoiceName<E>{E::unsaid, "", "not given"},
                    ChoiceName<E>{E::pinned_pinned, "pinned_pinned", "pinned at both ends", "pinned"},
                    ChoiceName<E>{E::fixed_free, "fixed_free", "fixed at the start, free at the end", "cantilever"},
                    ChoiceName<E>{E::fixed_pinned, "fixed_pinned", "fixed at the start, pinned at the end"},
                    ChoiceName<E>{E::fixed_fixed, "fixed_fixed", "fixed at both ends", "fixed"},
                    ChoiceName<E>{E::fixed_guided, "fixed_guided", "sway: fixed at the start, guided at the end"},
                    ChoiceName<E>{E::pinned_guided, "pinned_guided", "sway: pinned at the start, guided at the end"}};
}

/// Where the effective length factors of these cases come from.
enum class Basis { exact, text, recommended };

constexpr auto choices_of(Basis) {
  using B = Basis;
  return std::array{
      ChoiceName<B>{B::exact, "exact", "roots of the characteristic equation: 1, 2, 0.69916, 0.5, 1, 2"},
      ChoiceName<B>{B::text, "text", "[B25]: 1, 2, 0.7, 0.5; sway as exact"},
      ChoiceName<B>{B::recommended, "recommended", "for real ends, [AISC360]: 1, 2.1, 0.80, 0.65, 1.2, 2"}};
}

/// The last value means none: the method follows from the input (default_method).
enum class Method { euler, tetmajer, johnson, rankine, secant, ec3, aisc, sp16, unsaid };

constexpr auto choices_of(Method) {
  using M = Method;
  return std::array{ChoiceName<M>{M::euler, "euler", "Euler, elastic, above the limiting slenderness"},
                    ChoiceName<M>{M::tetmajer, "tetmajer", "Tetmajer-Yasinsky: minimum of yield, Tetmajer and Euler"},
                    ChoiceName<M>{M::johnson, "johnson", "Johnson's parabola, Euler above it"},
                    ChoiceName<M>{M::rankine, "rankine", "Rankine-Gordon"},
                    ChoiceName<M>{M::secant, "secant", "secant formula, with an eccentricity"},
                    ChoiceName<M>{M::ec3, "ec3", "EN 1993-1-1:2005, 6.3.1, flexural buckling"},
                    ChoiceName<M>{M::aisc, "aisc", "AISC 360, E3, allowable strength"},
                    ChoiceName<M>{M::sp16, "sp16", "SP 16.13330, 7.1.3; coefficients not checked against it"},
                    ChoiceName<M>{M::unsaid, "", "ec3 of a steel section of the tables, else johnson"}};
}

/// Buckling curves of EN 1993-1-1, table 6.1.
enum class Curve { by_kind, a0, a, b, c, d };

constexpr auto choices_of(Curve) {
  using C = Curve;
  return std::array{ChoiceName<C>{C::by_kind, "by_kind", "follows from the kind of section, table 6.2"},
                    ChoiceName<C>{C::a0, "a0", "alpha = 0.13"},
                    ChoiceName<C>{C::a, "a", "alpha = 0.21"},
                    ChoiceName<C>{C::b, "b", "alpha = 0.34"},
                    ChoiceName<C>{C::c, "c", "alpha = 0.49"},
                    ChoiceName<C>{C::d, "d", "alpha = 0.76"}};
}

enum class Grade { to_S420, S460 };

constexpr auto choices_of(Grade) {
  using G = Grade;
  return std::array{ChoiceName<G>{G::to_S420, "to_S420", "S235 to S420"}, ChoiceName<G>{G::S460, "S460", "S460"}};
}

/// Where Tetmajer's line ends and Euler's hyperbola begins.
enum class Transition { computed, published };

constexpr auto choices_of(Transition) {
  using T = Transition;
  return std::array{ChoiceName<T>{T::computed, "computed", "intersection of both curves"},
                    ChoiceName<T>{T::published, "published", "at lambda_1 of the set, as textbooks do"}};
}

/// Material class for the customary safety factor; the steel codes apply to steel or if no class is given.
enum class Class { unsaid, steel, cast_iron, wood, other };

constexpr auto choices_of(Class) {
  using C = Class;
  return std::array{ChoiceName<C>{C::unsaid, "", "not given"}, ChoiceName<C>{C::steel, "steel", "steel: n_st 1.8 to 3"},
                    ChoiceName<C>{C::cast_iron, "cast_iron", "cast iron: n_st 5 to 5.5"},
                    ChoiceName<C>{C::wood, "wood", "wood: n_st 2.8 to 3.2"},
                    ChoiceName<C>{C::other, "other", "another material, not covered by the steel codes"}};
}

enum class AxisName { y, z };

constexpr auto choices_of(AxisName) {
  return std::array{ChoiceName<AxisName>{AxisName::y, "y", "buckling about y"},
                    ChoiceName<AxisName>{AxisName::z, "z", "buckling about z"}};
}

enum class Loading { none, compression, tension };

constexpr auto choices_of(Loading) {
  using L = Loading;
  return std::array{ChoiceName<L>{L::none, "none", "no load given: allowable loads only"},
                    ChoiceName<L>{L::compression, "compression", "compressed"},
                    ChoiceName<L>{L::tension, "tension", "no compression: a bar in tension does not buckle"}};
}

}  // namespace loadpath::column
