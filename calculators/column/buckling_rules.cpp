// The rules of column.buckling about the section, and what they say of an input that breaks them.
#include "calculators/column/buckling.hpp"
#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/rules.hpp"
#include "calculators/column/torsional.hpp"

#include <cmath>

namespace loadpath::column {

namespace {

using Input = Buckling::Input;

bool axis_given(SecondMoment I, Length i) { return is_set(I) || is_set(i); }

bool fits(const Input& in, SecondMoment I, Length i) {
  if (!is_set(in.A) || !is_set(I) || !is_set(i)) return true;
  return std::abs(in_si(in.A) * in_si(i) * in_si(i) / in_si(I) - 1.0) < 0.02;
}

/// Whether the section has a buckling curve of the code that decides.
bool has_curves(const Input& in) {
  if (method_of(in) == Method::sp16) return is_set(sp16_type(in.kind).alpha);
  const auto has = [&](AxisName axis) { return curve_of(in, axis) != Curve::by_kind; };
  return has(AxisName::y) && has(AxisName::z);
}

}  // namespace

bool Buckling::section_given(const Input& in) {
  const bool round = is_set(in.d), rectangle = is_set(in.h) && is_set(in.b);
  if (is_set(in.A)) return axis_given(in.I_y, in.i_y) && axis_given(in.I_z, in.i_z);
  const bool moments = axis_given(in.I_y, in.i_y) || axis_given(in.I_z, in.i_z);
  const bool sides = is_set(in.h) || is_set(in.b);
  return !moments && (round ? !sides : rectangle);
}

FieldFault Buckling::section_missing(const Input& in) {
  if (is_set(in.A)) {
    return {"A", say("with the area A both axes need I or i"),
            say("give I_y and I_z, or i_y and i_z; for a round bar only d")};
  }
  if (axis_given(in.I_y, in.i_y) || axis_given(in.I_z, in.i_z))
    return {"", say("I or i is given, but not the area A"), say("give A too, or a round bar d, or a rectangle b, h")};
  if (is_set(in.d)) return {"d", say("d is a round bar, h and b a rectangle: the bar is one of them"), {}};
  return {
      "", say("the section is not given"),
      say("give section = \"IPE 200\" (`loadpath tables`), or d of a round bar (with d_bore or t_w), or b and h of a "
          "rectangle (hollow: with t_w), or A with I_y and I_z (or i_y and i_z)")};
}

bool Buckling::radii_fit(const Input& in) { return fits(in, in.I_y, in.i_y) && fits(in, in.I_z, in.i_z); }

bool Buckling::needs_of_method(const Input& in) { return missing_inputs(in, method_of(in), has_curves(in)).empty(); }

FieldFault Buckling::missing_for_method(const Input& in) {
  const bool curves = in.method == Method::unsaid ? is_structural(in) : has_curves(in);
  return column::missing_for_method(in, method_of(in), curves);
}

bool Buckling::extreme_fibre_known(const Input& in) { return fibre_known(in); }

Outline Buckling::outline_of(const Input& in) {
  switch (in.kind) {
    case SectionKind::rolled_I:
    case SectionKind::welded_I:
      return Outline::two_flanges;
    case SectionKind::channel:
    case SectionKind::tee:
    case SectionKind::angle:
      return twists_about_known_axis(in) ? Outline::one_symmetry : Outline::open;
    case SectionKind::hot_hollow:
    case SectionKind::cold_hollow:
    case SectionKind::welded_box:
      return Outline::closed;
    case SectionKind::solid:
      return Outline::solid;
    case SectionKind::unsaid:
      break;
  }
  if (is_solid(in)) return Outline::solid;
  return is_set(in.d) || is_walled(in) ? Outline::closed : Outline::unknown;
}

double Buckling::whole_twisting_length(const Input& in) {
  Input between_ends = in;
  between_ends.l_T = unset<Length>;
  return in_si(twisting_length(between_ends));
}

/// Rolled sections have up to 1.35 times that of their walls, and tapered flanges 0.86 times.
double Buckling::most_torsion_constant(const Input& in) { return 1.4 * in_si(twisting_by_walls(in).I_t); }
double Buckling::most_warping_constant(const Input& in) { return 1.2 * in_si(twisting_by_walls(in).I_w); }
double Buckling::least_shear_centre(const Input& in) { return 0.85 * in_si(twisting_by_walls(in).e); }

}  // namespace loadpath::column
