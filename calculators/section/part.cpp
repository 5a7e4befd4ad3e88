#include "calculators/section/part.hpp"

#include "calculators/section/profile.hpp"
#include "calculators/section/shapes/angle.hpp"
#include "calculators/section/shapes/channel.hpp"
#include "calculators/section/shapes/circle.hpp"
#include "calculators/section/shapes/hollow.hpp"
#include "calculators/section/shapes/i.hpp"
#include "calculators/section/shapes/rectangle.hpp"
#include "calculators/section/shapes/ring.hpp"
#include "calculators/section/shapes/tee.hpp"
#include "lib/table/library.hpp"

#include <string>

namespace loadpath::section {

namespace {

using Part = BuiltUpTypes::Part;
using Shape = BuiltUpTypes::Shape;

/// A length that a shape needs, and its key.
struct Needed {
  const char* key;
  Length value;
};

std::optional<FieldFault> first_missing(std::initializer_list<Needed> needed, const char* shape) {
  for (const Needed& n : needed) {
    if (!is_set(n.value)) return FieldFault{n.key, say("'{1}' is missing: the shape '{2}' needs it", n.key, shape), {}};
  }
  return std::nullopt;
}

std::optional<FieldFault> missing_in(const Part& p) {
  switch (p.shape) {
    case Shape::table:
      return std::nullopt;
    case Shape::circle:
      return first_missing({{"d", p.d}}, "circle");
    case Shape::ring:
      return first_missing({{"d", p.d}, {"d_i", p.d_i}}, "ring");
    case Shape::rectangle:
      return first_missing({{"b", p.b}, {"h", p.h}}, "rectangle");
    case Shape::I:
      return first_missing({{"h", p.h}, {"b", p.b}, {"t_w", p.t_w}, {"t_f", p.t_f}}, "I");
    case Shape::channel:
      return first_missing({{"h", p.h}, {"b", p.b}, {"t_w", p.t_w}, {"t_f", p.t_f}}, "channel");
    case Shape::angle:
      return first_missing({{"h", p.h}, {"b", p.b}, {"t", p.t}}, "angle");
    case Shape::T:
      return first_missing({{"h", p.h}, {"b", p.b}, {"t_w", p.t_w}, {"t_f", p.t_f}}, "T");
    case Shape::hollow:
      return first_missing({{"h", p.h}, {"b", p.b}, {"t", p.t}}, "hollow");
  }
  return std::nullopt;
}

template <class C>
std::optional<FieldFault> broken_rule(const typename C::Input& in) {
  for (const auto& rule : C::rules) {
    if (!rule.holds(in)) return FieldFault{{}, say(rule.text), {}};
  }
  return std::nullopt;
}

/// Calls `use` with the input of the calculator of a shape and its class.
template <class Use>
auto with_input(const Part& p, Use use) {
  switch (p.shape) {
    case Shape::circle:
      return use(Circle{}, Circle::Input{p.d});
    case Shape::ring:
      return use(Ring{}, Ring::Input{p.d, p.d_i});
    case Shape::I:
      return use(I{}, I::Input{{p.h, p.b, p.t_w, p.t_f, p.r}});
    case Shape::channel:
      return use(Channel{}, Channel::Input{p.h, p.b, p.t_w, p.t_f, p.r});
    case Shape::angle:
      return use(Angle{}, Angle::Input{p.h, p.b, p.t, p.r, p.r_2});
    case Shape::T:
      return use(Tee{}, Tee::Input{p.h, p.b, p.t_w, p.t_f, p.r});
    case Shape::hollow:
      return use(Hollow{}, Hollow::Input{p.h, p.b, p.t, p.r, p.r_2});
    case Shape::table:
    case Shape::rectangle:
      break;
  }
  return use(Rectangle{}, Rectangle::Input{p.b, p.h});
}

Contours contours_of(const Part& part) {
  return with_input(part, [](auto calculator, const auto& in) { return decltype(calculator)::contours(in); });
}

Length or_none(Length length) { return is_set(length) ? length : from_si<Length>(0.0); }

/// The shape of a row of a table: contours follow from its sizes, the values are the table's.
Part shape_of(const table::Typed<Profile>& row) {
  Part p;
  p.h = row.h, p.b = row.b, p.t_w = row.t_w, p.t_f = row.t_f, p.t = row.t_w, p.d = row.h;
  p.r = or_none(row.r), p.r_2 = or_none(row.r_2);
  const std::string_view kind = row.kind();
  p.shape = kind == "channel"    ? Shape::channel
            : kind == "angle"    ? Shape::angle
            : kind == "rolled_I" ? Shape::I
                                 : Shape::hollow;
  if (kind == "round hollow") p.shape = Shape::ring, p.d_i = row.h - 2.0 * row.t_w;
  if (kind == "hot_hollow") p.r = 1.5 * row.t_w, p.r_2 = row.t_w;
  if (kind == "cold_hollow") p.r = 2.0 * row.t_w, p.r_2 = row.t_w;
  return p;
}

Shaped of_table(const table::Typed<Profile>& row) {
  const Part part = shape_of(row);
  Shaped s;
  s.extremes = with_input(part, [](auto calculator, const auto& in) { return decltype(calculator)::extremes(in); });
  s.own.A = row.A, s.own.I_y = row.I_y, s.own.I_z = row.I_z, s.own.I_t = row.I_t;
  const bool angle = part.shape == Shape::angle;
  s.own.I_yz = is_set(row.I_yz) ? row.I_yz : from_si<SecondMoment>(0.0);
  s.own.y_S = or_none(row.e_z);
  s.own.z_S = angle ? or_none(row.e_z) : from_si<Length>(0.0);
  return s;
}

}  // namespace

std::optional<FieldFault> fault_of(const Part& part) {
  if (part.shape == Shape::table) {
    if (part.section.empty())
      return FieldFault{"shape", say("give its 'shape', or name a 'section' of the tables"), {}};
    if (find_profile(part.section.view()) != nullptr) return std::nullopt;
    const auto row = table::find_row(Profile::group, part.section.view());  // says what is near
    return FieldFault{"section", row.fault().message, row.fault().hint};
  }
  if (!part.section.empty()) return FieldFault{"section", say("a part has a 'shape' or a 'section', not both"), {}};
  if (auto missing = missing_in(part)) return missing;
  return with_input(part, [](auto calculator, const auto& in) { return broken_rule<decltype(calculator)>(in); });
}

Part as_shape(const Part& part) {
  if (part.shape != Shape::table) return part;
  const auto* row = find_profile(part.section.view());
  return row != nullptr ? shape_of(*row) : part;
}

Shaped shaped(const Part& part) {
  if (part.shape == Shape::table) {
    const auto* row = find_profile(part.section.view());
    return row != nullptr ? of_table(*row) : Shaped{};
  }
  return with_input(part, [](auto calculator, const auto& in) {
    NoTrace off;
    return Shaped{decltype(calculator)::own(in, off), decltype(calculator)::extremes(in)};
  });
}

Contours contours(const Part& part) {
  if (part.shape != Shape::table) return contours_of(part);
  const auto* row = find_profile(part.section.view());
  return row != nullptr ? contours_of(shape_of(*row)) : Contours{};
}

}  // namespace loadpath::section
