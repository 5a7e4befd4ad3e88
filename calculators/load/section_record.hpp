// A section as one record: a column, a link or a beam that takes area and second moments takes the walls with them.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"

#include <array>

namespace loadpath {

/// Inputs of the buckling curve of EN 1993-1-1 and of the limits of local buckling.
enum class SectionKind { unsaid, rolled_I, welded_I, hot_hollow, cold_hollow, welded_box, channel, tee, angle, solid };

constexpr auto choices_of(SectionKind) {
  using K = SectionKind;
  return std::array{ChoiceName<K>{K::unsaid, "", "not given"},
                    ChoiceName<K>{K::rolled_I, "rolled_I", "rolled I or H section"},
                    ChoiceName<K>{K::welded_I, "welded_I", "welded I or H section"},
                    ChoiceName<K>{K::hot_hollow, "hot_hollow", "hollow section, hot finished"},
                    ChoiceName<K>{K::cold_hollow, "cold_hollow", "hollow section, cold formed"},
                    ChoiceName<K>{K::welded_box, "welded_box", "welded box section"},
                    ChoiceName<K>{K::channel, "channel", "channel"},
                    ChoiceName<K>{K::tee, "tee", "T section"},
                    ChoiceName<K>{K::angle, "angle", "angle"},
                    ChoiceName<K>{K::solid, "solid", "solid section"}};
}

/// How an open section was made.
enum class Rolling { unsaid, rolled, welded };

constexpr auto choices_of(Rolling) {
  using R = Rolling;
  return std::array{ChoiceName<R>{R::unsaid, "", "not given: the less favourable buckling curves, of welded sections"},
                    ChoiceName<R>{R::rolled, "rolled", "rolled"},
                    ChoiceName<R>{R::welded, "welded", "welded from plates"}};
}

/// How a hollow section was made.
enum class Forming { unsaid, hot_finished, cold_formed, welded };

constexpr auto choices_of(Forming) {
  using F = Forming;
  return std::array{
      ChoiceName<F>{F::unsaid, "", "not given: the less favourable buckling curve, of cold formed sections"},
      ChoiceName<F>{F::hot_finished, "hot_finished", "hot finished, EN 10210"},
      ChoiceName<F>{F::cold_formed, "cold_formed", "cold formed, EN 10219"},
      ChoiceName<F>{F::welded, "welded", "welded box"}};
}

constexpr SectionKind kind_of(Rolling made) {
  return made == Rolling::rolled ? SectionKind::rolled_I : SectionKind::welded_I;
}

constexpr SectionKind kind_of(Forming made) {
  if (made == Forming::hot_finished) return SectionKind::hot_hollow;
  return made == Forming::welded ? SectionKind::welded_box : SectionKind::cold_hollow;
}

/// Result of every section.*: section = "=box". Dimensions that the shape does not have are unset, and the kind of a
/// section of free shape is not stated.
struct SectionRecord {
  Area A = unset<Area>;
  SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_min = unset<SecondMoment>;
  Length c_y = unset<Length>, c_z = unset<Length>;
  SectionKind kind = SectionKind::unsaid;
  Length d = unset<Length>, h = unset<Length>, b = unset<Length>;
  Length t_f = unset<Length>, t_w = unset<Length>, r = unset<Length>;

  static constexpr Fields fields{Field{&SectionRecord::A, "A", mm2, "area"},
                                 Field{&SectionRecord::I_y, "I_y", mm4, "second moment of area about y"},
                                 Field{&SectionRecord::I_z, "I_z", mm4, "second moment of area about z"},
                                 Field{&SectionRecord::I_min, "I_min", mm4,
                                       "minimum second moment of area, where the principal axes are inclined"},
                                 Field{&SectionRecord::c_y, "c_y", mm, "distance of the extreme fibre from y"},
                                 Field{&SectionRecord::c_z, "c_z", mm, "distance of the extreme fibre from z"},
                                 Choice{&SectionRecord::kind, "kind", "section type"},
                                 Field{&SectionRecord::d, "d", mm, "diameter of a round bar or tube"},
                                 Field{&SectionRecord::h, "h", mm, "height of the section, along z"},
                                 Field{&SectionRecord::b, "b", mm, "width of the section, along y"},
                                 Field{&SectionRecord::t_f, "t_f", mm, "thickness of the flange"},
                                 Field{&SectionRecord::t_w, "t_w", mm, "thickness of the web or wall"},
                                 Field{&SectionRecord::r, "r", mm, "root radius"}};
};

}  // namespace loadpath
