// Input and result of column.stepped.
#pragma once

#include "calculators/column/stepped/critical.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::column {

struct SteppedTypes {
  enum class Foot { fixed, pinned };
  enum class Top { free, pinned, fixed, guided };
  /// Whether the self-weight acts along the column.
  enum class Orientation { vertical, horizontal };

  struct Part {
    Name name;
    Length l = unset<Length>, d = unset<Length>;
    Area A = unset<Area>;
    SecondMoment I = unset<SecondMoment>;
    Force P = unset<Force>;
    Stiffness q = unset<Stiffness>;
    static constexpr Fields fields{
        NameField{&Part::name, "name", "name of the part"}.may_be_missing(),
        Field{&Part::l, "l", mm, "length"}.positive().usually(10, 1e5),
        Field{&Part::d, "d", mm, "diameter of a solid round part"}
            .positive()
            .usually(1, 2000)
            .findable("R40")
            .may_be_missing(),
        Field{&Part::A, "A", mm2, "area of another section"}.positive().may_be_missing(),
        Field{&Part::I, "I", mm4, "second moment of area of another section, about the axis of buckling"}
            .positive()
            .may_be_missing(),
        Field{&Part::P, "P", kN, "compressive force applied at its upper end"}.load().at_least(0).may_be_missing(),
        Field{&Part::q, "q", N_per_mm, "compressive load per unit length of the part, without self-weight"}
            .load()
            .at_least(0)
            .may_be_missing()};
  };
  using Parts = List<Part, most_pieces>;

  struct Input {
    Parts parts;
    Foot foot = Foot::fixed;
    Top top = Top::free;
    Orientation orientation = Orientation::vertical;
    Stress E = unset<Stress>;
    Density rho = unset<Density>;
    Stress R_e = unset<Stress>, sigma_P = unset<Stress>;
    double n_st = unset<double>;
  };

  struct MemberOfColumn {
    Name name;
    Area A = unset<Area>;
    SecondMoment I = unset<SecondMoment>;
    Force N_u = unset<Force>, N_l = unset<Force>;
    Force N_cr = unset<Force>;
    double beta = unset<double>;
    Length s = unset<Length>;
    double lambda = unset<double>;
    Stress sigma = unset<Stress>, sigma_cr = unset<Stress>;
    double u = unset<double>;
    static constexpr Fields fields{
        NameField{&MemberOfColumn::name, "name", "part"},
        Field{&MemberOfColumn::A, "A", mm2, "area"},
        Field{&MemberOfColumn::I, "I", mm4, "second moment of area"},
        Field{&MemberOfColumn::N_u, "N_u", kN, "compressive force at its upper end"},
        Field{&MemberOfColumn::N_l, "N_l", kN, "compressive force at its lower end"},
        Field{&MemberOfColumn::N_cr, "N_cr", kN, "force at its lower end when the column buckles elastically"},
        Field{&MemberOfColumn::beta, "beta", ratio, "effective length factor of the part"},
        Field{&MemberOfColumn::s, "s", mm, "effective length of the part"},
        Field{&MemberOfColumn::lambda, "lambda", ratio, "slenderness of the part"},
        Field{&MemberOfColumn::sigma, "sigma", MPa, "stress at its lower end"},
        Field{&MemberOfColumn::sigma_cr, "sigma_cr", MPa, "critical stress of the part"},
        Field{&MemberOfColumn::u, "u", ratio, "n_st x stress / critical stress"}};
  };

  struct Result {
    Length t = unset<Length>;
    Force F = unset<Force>;
    double alpha_cr = unset<double>;
    Force F_cr = unset<Force>;
    double u = unset<double>, r_P = unset<double>;
    List<MemberOfColumn, most_pieces> members;
  };
};

constexpr auto choices_of(SteppedTypes::Foot) {
  using F = SteppedTypes::Foot;
  return std::array{ChoiceName<F>{F::fixed, "fixed", "fixed (built in)"},
                    ChoiceName<F>{F::pinned, "pinned", "pinned (hinged)"}};
}

constexpr auto choices_of(SteppedTypes::Top) {
  using T = SteppedTypes::Top;
  return std::array{ChoiceName<T>{T::free, "free", "free"}, ChoiceName<T>{T::pinned, "pinned", "pinned (hinged)"},
                    ChoiceName<T>{T::fixed, "fixed", "fixed (built in)"},
                    ChoiceName<T>{T::guided, "guided", "guided: free to translate, fixed against rotation"}};
}

constexpr auto choices_of(SteppedTypes::Orientation) {
  using O = SteppedTypes::Orientation;
  return std::array{ChoiceName<O>{O::vertical, "vertical", "vertical: the weight compresses it"},
                    ChoiceName<O>{O::horizontal, "horizontal", "horizontal: the weight bends it"}};
}

}  // namespace loadpath::column
