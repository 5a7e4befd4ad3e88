// Members of a bar fixed in torsion: segments in series, sleeves in parallel, torques.
#pragma once

#include "calculators/shaft/parts/ring.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::shaft {

inline constexpr std::size_t most_segments = 16, most_sleeves = 8, most_twisting = 24;
inline constexpr std::size_t most_members = most_segments + most_sleeves;
inline constexpr std::size_t most_cuts = most_segments + 2 * most_sleeves + most_twisting;

inline constexpr Unit<Force> N_m_per_m{"N*m/m", from_si<Force>(1.0)};

enum class End { free, held, elastic };

constexpr auto choices_of(End) {
  return std::array{ChoiceName<End>{End::free, "free", "free"}, ChoiceName<End>{End::held, "held", "fixed", "fixed"},
                    ChoiceName<End>{End::elastic, "elastic", "elastic (spring)"}};
}

/// A cylinder or a cone of the bar.
struct Segment {
  Name name;
  Length l = unset<Length>, d = unset<Length>, d_2 = unset<Length>;
  Length d_bore = 0.0 * mm, d_bore_2 = unset<Length>;
  Stress G = unset<Stress>, tau_adm = unset<Stress>;
  Force m = 0.0 * N;
  static constexpr Fields fields{
      NameField{&Segment::name, "name", "name of the part"}.may_be_missing(),
      Field{&Segment::l, "l", mm, "length"}.positive().usually(0.1, 1e5),
      Field{&Segment::d, "d", mm, "outer diameter; of a cone at its first end"}.positive().usually(1, 2000).findable(
          "R40"),
      Field{&Segment::d_2, "d_2", mm, "outer diameter at its second end, of a cone"}
          .positive()
          .usually(1, 2000)
          .may_be_missing(),
      Field{&Segment::d_bore, "d_bore", mm, "diameter of the bore; of a cone at its first end"}.at_least(0),
      Field{&Segment::d_bore_2, "d_bore_2", mm, "diameter of the bore at the second end, if different"}
          .at_least(0)
          .may_be_missing(),
      Field{&Segment::G, "G", GPa, "its own shear modulus"}.positive().usually(least_G, most_G).may_be_missing(),
      Field{&Segment::tau_adm, "tau_adm", MPa, "its own allowable shear stress"}
          .positive()
          .usually(1, 1000)
          .customarily_at_most(600)
          .may_be_missing(),
      Field{&Segment::m, "m", N_m_per_m, "torque per unit length, signed"}.load()};
};

/// A cylinder around the bar, or inside its bore, that rotates as one with it along its full length.
struct Sleeve {
  Name name;
  Length x = unset<Length>, l = unset<Length>, d = unset<Length>, d_bore = 0.0 * mm;
  Stress G = unset<Stress>, tau_adm = unset<Stress>;
  static constexpr Fields fields{
      NameField{&Sleeve::name, "name", "name of the sleeve"}.may_be_missing(),
      Field{&Sleeve::x, "x", mm, "first end of the sleeve, from the first end of the bar"}.at_least(0),
      Field{&Sleeve::l, "l", mm, "length"}.positive().usually(0.1, 1e5),
      Field{&Sleeve::d, "d", mm, "outer diameter"}.positive().usually(1, 2000),
      Field{&Sleeve::d_bore, "d_bore", mm, "diameter of its bore"}.at_least(0),
      Field{&Sleeve::G, "G", GPa, "its own shear modulus"}.positive().usually(least_G, most_G).may_be_missing(),
      Field{&Sleeve::tau_adm, "tau_adm", MPa, "its own allowable shear stress"}
          .positive()
          .usually(1, 1000)
          .customarily_at_most(600)
          .may_be_missing()};
};

/// A torque on the bar.
struct AxialTorque {
  Name name;
  Length x = unset<Length>;
  Moment T = unset<Moment>;
  static constexpr Fields fields{NameField{&AxialTorque::name, "name", "source of the torque"}.may_be_missing(),
                                 Field{&AxialTorque::x, "x", mm, "position from the first end"}.at_least(0),
                                 Field{&AxialTorque::T, "T", N_m, "torque on the bar, signed"}.load()};
};

inline bool is_cone(const Segment& s) {
  return (is_set(s.d_2) && s.d_2 != s.d) || (is_set(s.d_bore_2) && s.d_bore_2 != s.d_bore);
}

}  // namespace loadpath::shaft
