// The section of a compressed bar: typed, or a row of the section tables. Its fields are declared here once.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "lib/calculator/row_kind.hpp"

namespace loadpath::column {

using Warping = decltype(SecondMoment() * Area());
inline constexpr Unit<Warping> mm6{"mm^6", from_si<Warping>(1e-18)};

struct Section {
  Length d = unset<Length>, d_bore = unset<Length>, h = unset<Length>, b = unset<Length>;
  Area A = unset<Area>;
  SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_min = unset<SecondMoment>;
  Length i_y = unset<Length>, i_z = unset<Length>;
  SectionKind kind = SectionKind::unsaid;
  Length t_f = unset<Length>, t_w = unset<Length>, r = unset<Length>;
  Length c_y = unset<Length>, c_z = unset<Length>;
  SecondMoment I_t = unset<SecondMoment>;
  Warping I_w = unset<Warping>;
  Length y_M = unset<Length>;
  Curve curve_y = Curve::by_kind, curve_z = Curve::by_kind;
};

/// Whether a section without its area is a tube or a rectangular hollow section, by the thickness of its wall.
inline bool is_walled(const Section& in) { return !is_set(in.A) && is_set(in.t_w); }
/// Of a round bar: as given, or by its wall; unset of a solid one.
inline Length bore_of(const Section& in) {
  return !is_set(in.d_bore) && is_walled(in) ? in.d - 2.0 * in.t_w : in.d_bore;
}
/// Of the walls across the height.
inline Length flange_of(const Section& in) { return is_set(in.t_f) ? in.t_f : in.t_w; }
/// As given, or by the sizes: of a round bar, a rectangle, or a rectangle less the one within its walls.
Area area_of(const Section& in);
/// By the sizes of a section without its area.
SecondMoment moment_of_sizes(const Section& in, bool about_y);

/// Whether area and second moments, given without sizes, are those of a full section.
bool is_full(const Section& in);

template <class Input>
constexpr auto section_inputs() {
  return Fields{
      Field<Input, Length>{&Input::d, "d", mm, "diameter of a round bar or tube"}
          .positive()
          .usually(1, 2000)
          .from("section", "d")
          .where_it_has()
          .findable("R40"),
      Field<Input, Length>{&Input::d_bore, "d_bore", mm, "bore diameter of a round bar"}.at_least(0).may_be_missing(),
      Field<Input, Length>{&Input::h, "h", mm, "height of the section, along z"}
          .positive()
          .usually(1, 5000)
          .from("section", "h")
          .where_it_has()
          .findable("R40"),
      Field<Input, Length>{&Input::b, "b", mm, "width of the section, along y"}
          .positive()
          .usually(1, 5000)
          .from("section", "b")
          .where_it_has()
          .findable("R40"),
      Field<Input, Area>{&Input::A, "A", mm2, "area; omitted: round bar d or rectangle b h, hollow with t_w"}
          .positive()
          .from("section", "A"),
      Field<Input, SecondMoment>{&Input::I_y, "I_y", mm4, "second moment of area about y"}
          .positive()
          .from("section", "I_y")
          .where_it_has(),
      Field<Input, SecondMoment>{&Input::I_z, "I_z", mm4, "second moment of area about z"}
          .positive()
          .from("section", "I_z")
          .where_it_has(),
      Field<Input, SecondMoment>{&Input::I_min, "I_min", mm4,
                                 "minimum second moment of area of a section with inclined principal axes (angle)"}
          .positive()
          .from("section", "I_min")
          .where_it_has(),
      Field<Input, Length>{&Input::i_y, "i_y", mm, "radius of gyration about y, replaces I_y"}
          .positive()
          .may_be_missing(),
      Field<Input, Length>{&Input::i_z, "i_z", mm, "radius of gyration about z, replaces I_z"}
          .positive()
          .may_be_missing(),
      RowKind<Input, SectionKind>{&Input::kind, "kind",
                                  "section type, for the buckling curves of EN 1993-1-1 and local buckling", "section"},
      Field<Input, Length>{&Input::t_f, "t_f", mm, "thickness of the flange"}
          .positive()
          .from("section", "t_f")
          .where_it_has(),
      Field<Input, Length>{
          &Input::t_w, "t_w", mm,
          "thickness of the web or wall; without A: of the tube d, or of the hollow section b h with sharp "
          "corners"}
          .positive()
          .usually(0.5, 200)
          .from("section", "t_w")
          .where_it_has()
          .findable("R20"),
      Field<Input, Length>{&Input::r, "r", mm, "root radius"}.at_least(0).from("section", "r").where_it_has()};
}

/// What an open section is twisted by.
template <class Input>
constexpr auto twisting_inputs() {
  return Fields{Field<Input, SecondMoment>{&Input::I_t, "I_t", mm4, "torsion constant; omitted: from the walls"}
                    .positive()
                    .from("section", "I_t")
                    .where_it_has(),
                Field<Input, Warping>{&Input::I_w, "I_w", mm6, "warping constant; omitted: from the walls"}
                    .at_least(0)
                    .from("section", "I_w")
                    .where_it_has(),
                Field<Input, Length>{&Input::y_M, "y_M", mm,
                                     "distance of the shear centre from the centroid, on the axis of symmetry of a "
                                     "channel, tee or angle; omitted: from the walls"}
                    .positive()
                    .from("section", "y_M")
                    .where_it_has()};
}

/// Defaults derived from the section.
template <class Input>
constexpr auto derived_section_inputs() {
  return Fields{
      Field<Input, Length>{&Input::c_y, "c_y", mm,
                           "distance of the extreme fibre from y; omitted: half the height of a symmetric section"}
          .positive()
          .may_be_missing(),
      Field<Input, Length>{&Input::c_z, "c_z", mm,
                           "distance of the extreme fibre from z; omitted: half the width of a symmetric section"}
          .positive()
          .may_be_missing(),
      Choice<Input, Curve>{&Input::curve_y, "curve_y", "buckling curve of EN 1993-1-1 about y"}.may_be_missing(),
      Choice<Input, Curve>{&Input::curve_z, "curve_z", "buckling curve of EN 1993-1-1 about z"}.may_be_missing()};
}

}  // namespace loadpath::column
