#include "calculators/column/member/rules.hpp"

#include "calculators/column/member/parts.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/section_shape.hpp"

#include <cmath>

namespace loadpath::column {

namespace {

/// The first misplaced support, and its list; -1 if all are in order.
struct Misplaced {
  const char* list = "";
  int place = -1;
};

Misplaced astray(const Member& in) {
  for (const AxisName axis : {AxisName::y, AxisName::z}) {
    Length before = 0.0 * mm;
    int place = 0;
    for (const auto& support : supports_of(in, axis)) {
      if (!(support.x > before && support.x < in.l)) return {axis == AxisName::y ? "supports_y" : "supports_z", place};
      before = support.x;
      ++place;
    }
  }
  return {};
}

/// Tetmajer's stress over Euler's at the published limit, less 1.
double gap_at_limit(const Member& in) {
  const double c = is_set(in.c_T) ? in_si(in.c_T) : 0.0;
  const double x = in.lambda_1, tetmajer = in_si(in.a_T) + x * (-in_si(in.b_T) + x * c);
  return tetmajer * x * x / (pi * pi * in_si(in.E)) - 1.0;
}

struct Custom {
  double least, most;
};

Custom custom_of(Class material) {
  if (material == Class::steel) return {1.8, 3.0};
  if (material == Class::cast_iron) return {5.0, 5.5};
  if (material == Class::wood) return {2.8, 3.2};
  return {0.0, INFINITY};
}

bool is_loaded(const Member& in) { return is_set(in.N) || is_set(in.P); }

/// Missing input for the critical stress.
Message lack_of_stress(const Member& in, Method by, bool curves) {
  const bool yields = is_set(in.R_e);
  if (by == Method::euler) {
    if (is_set(in.sigma_P) || is_set(in.a_T)) return {};
    return say(
        "the proportional limit sigma_P, or a Tetmajer set, e.g. tetmajer = \"S235\" (`loadpath tables "
        "columns/tetmajer`)");
  }
  if (by == Method::tetmajer) {
    if (is_set(in.a_T)) return {};
    return say("a Tetmajer set, e.g. tetmajer = \"S235\" (`loadpath tables columns/tetmajer`), or a_T and b_T");
  }
  if (by == Method::rankine) {
    if (yields || is_set(in.sigma_c)) return {};
    return say("the crushing stress sigma_c, or the yield strength R_e");
  }
  if (!yields) return say("the yield strength R_e, or a material");
  if (by == Method::secant && !offset_is_given(in)) return say("the eccentricity e_y or e_z, or the bow e_0y or e_0z");
  if (by == Method::ec3 && !curves)
    return say(
        "the buckling curves: the kind of section (a rolled or welded I with t_f, h and b), or curve_y, curve_z");
  if (by == Method::sp16 && !curves) return say("the kind of section: hollow or box, I, channel, tee or angle");
  return {};
}

/// Missing input for the allowable force; AISC includes its safety factor, and those of EN 1993-1-1 are assumed.
Message lack_of_safety(const Member& in, Method by) {
  if (!is_loaded(in) || by == Method::aisc || by == Method::ec3) return {};
  return is_set(in.n_st) ? Message{} : say("the required buckling safety factor n_st");
}

/// Without a force there is its slenderness to be had, and without a modulus nothing else; a bar in tension does not
/// buckle.
bool asks_for_no_method(const Member& in) {
  if (in.N >= 0.0 * kN.one && !is_set(in.P)) return true;
  return !is_loaded(in) && !is_set(in.E);
}

/// Message for a bar whose method follows from its input: the input to give, and one alternative.
FieldFault missing_by_default(const Member& in, bool curves) {
  const bool is_open = !is_set(in.R_e) && !is_set(in.sigma_P) && !is_set(in.a_T);
  if (is_open) {
    const bool asks_safety = !curves && is_loaded(in) && !is_set(in.n_st);
    return {
        "R_e",
        asks_safety ? say("give the yield strength R_e, or a material, and the required buckling safety factor n_st")
                    : say("give the yield strength R_e, or a material"),
        say("or use a Tetmajer set instead of R_e, e.g. tetmajer = \"grey_iron\": `loadpath tables columns/tetmajer`")};
  }
  return {
      "n_st", say("give the required buckling safety factor n_st"),
      is_set(in.R_e) && is_steel(in) ? say("or use a code that includes it: method = \"ec3\" or \"aisc\"") : Message{}};
}

SecondMoment second_moment(Area A, SecondMoment I, Length i) { return is_set(I) ? I : A * i * i; }

table::SectionShape shape_of(const Section& in) {
  const Length wall = is_set(in.t_w) || !is_set(in.d_bore) ? in.t_w : 0.5 * (in.d - in.d_bore);
  return {in_si(in.h),
          in_si(in.b),
          in_si(in.d),
          in_si(in.t_f),
          in_si(wall),
          in_si(in.A),
          in_si(second_moment(in.A, in.I_y, in.i_y)),
          in_si(second_moment(in.A, in.I_z, in.i_z)),
          word_of(in.kind),
          in_si(in.I_min),
          in_si(in.I_t),
          in_si(in.I_w)};
}

}  // namespace

bool is_one_section(const Section& in) { return !is_set(in.A) || !table::inconsistency_of(shape_of(in)); }

FieldFault two_sections(const Section& in) {
  const auto inconsistency = table::inconsistency_of(shape_of(in));
  if (!inconsistency) return {};
  return {inconsistency->key, inconsistency->message,
          say("give one section only: by its row, by its sizes, or by A, I_y and I_z; check the units")};
}

bool is_solid_if_full(const Section& in) {
  const bool outlined = is_set(in.d) || (is_set(in.h) && is_set(in.b));
  if (!outlined || is_set(in.A) || in.kind == SectionKind::unsaid) return true;
  const bool is_hollow =
      in.kind == SectionKind::hot_hollow || in.kind == SectionKind::cold_hollow || in.kind == SectionKind::welded_box;
  return is_walled(in) || in.d_bore > 0.0 * mm ? is_hollow : in.kind == SectionKind::solid;
}

bool walls_fit(const Section& in) {
  if (is_set(in.A)) return true;
  if (is_set(in.t_w) && is_set(in.d_bore)) return false;
  if (is_set(in.t_f) && (!is_set(in.t_w) || is_set(in.d))) return false;
  if (!is_set(in.t_w)) return true;
  if (in.r > 0.0 * mm) return false;
  if (is_set(in.d)) return 2.0 * in.t_w < in.d;
  return 2.0 * in.t_w < in.b && 2.0 * flange_of(in) < in.h;
}

FieldFault unfit_walls(const Section& in) {
  if (is_set(in.t_w) && is_set(in.d_bore))
    return {"d_bore", say("d_bore and t_w both give the wall of the tube"), say("give one of them")};
  if (is_set(in.t_f) && is_set(in.d)) return {"t_f", say("a round bar has no flange"), say("give t_w of a tube")};
  if (is_set(in.t_f) && !is_set(in.t_w))
    return {"t_f", say("t_f does not describe a section of b and h without t_w"),
            say("give t_w of a rectangular hollow section, or A, I_y and I_z")};
  if (in.r > 0.0 * mm)
    return {"r", say("a hollow section of b, h and t_w is computed with sharp corners"),
            say("omit r, or give A, I_y and I_z")};
  return {"t_w", say("the walls must enclose a hollow"), say("2 t_w below d or b, 2 t_f below h")};
}

bool fibres_reach(const Section& in) {
  constexpr double rounding = 1.01;
  const auto reaches = [&](Length c, SecondMoment I, Length i) {
    const double square = in_si(i) * in_si(i);
    return !(rounding * in_si(c) * rounding * in_si(c) < (is_set(i) ? square : in_si(I) / in_si(in.A)));
  };
  return reaches(in.c_y, in.I_y, in.i_y) && reaches(in.c_z, in.I_z, in.i_z);
}

bool is_least_moment(const Section& in) {
  constexpr double rounding = 1.01;
  return !(in.I_min > rounding * in.I_y || in.I_min > rounding * in.I_z);
}

bool is_full(const Section& in) {
  const table::SectionShape shape = shape_of(in);
  return table::is_full(shape.A, shape.I_y, shape.I_z);
}

bool supports_inside(const Member& in) { return astray(in).place < 0; }

FieldFault support_outside(const Member& in) {
  const Misplaced at = astray(in);
  const std::string path = std::string(at.list) + "[" + std::to_string(at.place + 1) + "].x";
  return {path,
          say("supports must lie between the ends of the bar, 0 and {1}, in order",
              format_quantity(in_si(in.l), mm.symbol)),
          say("omit the ends from this list; sort the others by x")};
}

bool supports_need_ends(const Member& in) {
  if (in.supports_y.empty() && in.supports_z.empty()) return true;
  return in.beta_basis == Basis::exact && !(is_set(in.beta_y) && !in.supports_y.empty()) &&
         !(is_set(in.beta_z) && !in.supports_z.empty());
}

Message missing_inputs(const Member& in, Method by, bool curves) {
  if (asks_for_no_method(in) || (by == Method::unsaid && !is_loaded(in))) return {};
  const Message of_stress = lack_of_stress(in, by, curves), of_safety = lack_of_safety(in, by);
  if (of_stress.empty()) return of_safety;
  return of_safety.empty() ? of_stress : say("{1}; {2}", of_stress, of_safety);
}

FieldFault missing_for_method(const Member& in, Method by, bool curves) {
  if (in.method == Method::unsaid) return missing_by_default(in, curves);
  return {"method", say("the method '{1}' needs {2}", word_of(by), missing_inputs(in, by, curves)), {}};
}

bool factors_given(const Member& in, Method by) {
  if (by != Method::ec3) return true;
  if (in.N > 0.0 * kN.one) return !is_set(in.n_t) || is_set(in.gamma_F);
  const bool is_pressed = in.P > 0.0 * kN.one || in.N < 0.0 * kN.one;
  if (!is_pressed) return true;
  return is_set(in.gamma_M1) && is_set(in.gamma_F);
}

bool safety_counts(const Member& in, Method by) {
  return !is_set(in.n_st) || by != Method::ec3 || in.method == Method::ec3;
}

FieldFault assumed_factors(const Member& in) {
  const bool both = !is_set(in.gamma_M1) && !is_set(in.gamma_F) && !(in.N > 0.0 * kN.one);
  return {"",
          say("partial factors of EN 1993-1-1 assumed: {1}", both                 ? "gamma_M1 = 1.0, gamma_F = 1"
                                                             : is_set(in.gamma_F) ? "gamma_M1 = 1.0"
                                                                                  : "gamma_F = 1"),
          say("give gamma_F if the force is not a design value, gamma_M1 if the National Annex gives another value")};
}

bool method_suits_class(const Member& in) {
  const bool of_steel = in.method == Method::ec3 || in.method == Method::aisc || in.method == Method::sp16;
  return !of_steel || is_steel(in);
}

FieldFault method_of_steel(const Member& in) {
  return {"method",
          in.material_class == Class::unsaid ? say("the method '{1}' is for steel, not for a modulus of {2}",
                                                   word_of(in.method), format_quantity(in_si(in.E), GPa.symbol))
                                             : say("the method '{1}' is for steel, not for material_class = \"{2}\"",
                                                   word_of(in.method), word_of(in.material_class)),
          say("take euler, tetmajer, johnson or rankine with the constants of the material")};
}

bool set_meets_euler(const Member& in) {
  if (!is_set(in.a_T) || !is_set(in.b_T) || !is_set(in.E)) return true;
  return is_set(material_of(in).lambda_T);
}

bool set_near_euler(const Member& in) {
  if (!is_set(in.a_T) || !is_set(in.b_T) || !is_set(in.E) || !is_set(in.lambda_1)) return true;
  return std::abs(gap_at_limit(in)) <= 0.03;
}

FieldFault gap_of_set(const Member& in) {
  const double gap = 100.0 * gap_at_limit(in);
  return {"",
          say("at its published limit {1} the set is {2} % {3} Euler's hyperbola", format_number(in.lambda_1, 4),
              format_number(std::abs(gap), 2), gap > 0.0 ? "above" : "below"),
          say("transition = \"computed\" changes over where the two meet; textbooks change over at the limit")};
}

bool set_fits_modulus(const Member& in) {
  return !is_set(in.E_T) || !is_set(in.E) || std::abs(in.E / in.E_T - 1.0) <= 0.05;
}

bool set_is_of_material(const Member& in) {
  constexpr double most = 1.3;  // grey irons and woods differ that much among themselves
  return !is_set(in.E_T) || !is_set(in.E) || (in.E <= most * in.E_T && in.E_T <= most * in.E);
}

FieldFault modulus_of_set(const Member& in) {
  return {"",
          say("the set of Tetmajer-Yasinsky was given with E = {1}, not {2}",
              format_quantity(in_si(in.E_T), GPa.symbol), format_quantity(in_si(in.E), GPa.symbol)),
          say("take the set of this material")};
}

bool usual_safety(const Member& in) {
  const Custom custom = custom_of(in.material_class);
  return !is_set(in.n_st) || (in.n_st >= custom.least && in.n_st <= custom.most);
}

FieldFault unusual_safety(const Member& in) {
  const Custom custom = custom_of(in.material_class);
  return {"n_st", say("n_st = {1} is unusual for this class of material", format_number(in.n_st)),
          say("{1} to {2} is usual", format_number(custom.least), format_number(custom.most))};
}

}  // namespace loadpath::column
