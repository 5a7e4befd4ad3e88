// The rules of column.lightest, and what they say of an input that breaks them.
#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/lightest/lightest.hpp"
#include "calculators/column/lightest/parts.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::column {

namespace {

using Failure = Lightest::Failure;
using Input = Lightest::Input;
using Result = Lightest::Result;

std::string names_of(const Lightest::Families& families) {
  std::string names;
  for (const auto& f : families) names += (names.empty() ? "" : ", ") + std::string(f.family.view());
  return names;
}

/// The first family that no row of the tables begins with; null where all are known.
const Lightest::Family* stranger(const Input& in) {
  const auto unknown = [](const Lightest::Family& f) {
    const auto& all = sections_by_mass();
    return std::none_of(all.begin(), all.end(),
                        [&](const TableSection& s) { return begins_with(s.name(), f.family.view()); });
  };
  const auto found = std::find_if(in.families.begin(), in.families.end(), unknown);
  return found == in.families.end() ? nullptr : &*found;
}

/// Another family of the list that contains this one; null if there is none. Of two equal ones the first.
const Lightest::Family* container_of(const Lightest::Family& f, const Input& in) {
  const auto contains = [&](const Lightest::Family& other) {
    return &other != &f && begins_with(f.family.view(), other.family.view()) &&
           (&other < &f || !(other.family == f.family));
  };
  const auto found = std::find_if(in.families.begin(), in.families.end(), contains);
  return found == in.families.end() ? nullptr : &*found;
}

/// The first family in the list that another one contains; the end if each is named once.
auto repeated(const Input& in) {
  return std::find_if(in.families.begin(), in.families.end(),
                      [&](const Lightest::Family& f) { return container_of(f, in) != nullptr; });
}

/// Whether one of the sections to choose from is such a row.
template <class Test>
bool any_row(const Input& in, Test test) {
  const auto& all = sections_by_mass();
  return std::any_of(all.begin(), all.end(), [&](const TableSection& s) { return belongs(s, in) && test(s); });
}

bool is_open_tube(const TableSection& section) {
  const Section& s = section;
  return is_set(s.d) && s.kind == SectionKind::unsaid;
}

/// The first section without the extreme fibre that the eccentricity or the bow needs; null if none.
const TableSection* fibreless(const Input& in) {
  if (!is_offset_about_y(in) && !is_offset_about_z(in)) return nullptr;
  const auto& all = sections_by_mass();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const TableSection& s) { return belongs(s, in) && !fibre_known(bar_of(in, s)); });
  return found == all.end() ? nullptr : &*found;
}

Message remedy_of(Failure failure) {
  if (failure == Failure::open)
    return say("give the kind of these sections: kind = \"hot_hollow\" or kind = \"cold_hollow\"");
  if (failure == Failure::strength)
    return say("name a material that is given for thicker sections, or families with thinner walls");
  if (failure == Failure::beyond) return say("name families of larger sections, or hold the bar better");
  if (failure == Failure::range) return say("use a method that covers stocky bars: tetmajer, johnson, ec3, aisc");
  return {};
}

Input with_a_strength(Input in) {
  if (!is_set(in.R_e) && !in.strengths.empty()) in.R_e = in.strengths.front().R_e;
  return in;
}

Result quick(const Input& in) {
  NoTrace quiet;
  return Lightest::evaluate(in, quiet);
}

}  // namespace

bool Lightest::families_known(const Input& in) { return stranger(in) == nullptr; }

FieldFault Lightest::unknown_family(const Input& in) {
  const Family* const unknown = stranger(in);
  const auto sizes = first_sizes(family_of(unknown->family.view()));
  const auto known = sizes.empty() ? families() : sizes;
  return {"families[" + std::to_string(unknown - &in.families[0] + 1) + "].family",
          say("unknown family '{1}' in the section tables", unknown->family.view()),
          did_you_mean(unknown->family.view(), known, there_is(known))};
}

bool Lightest::families_once(const Input& in) { return repeated(in) == in.families.end(); }

FieldFault Lightest::family_twice(const Input& in) {
  const auto again = repeated(in);
  const Name& container = container_of(*again, in)->family;
  return {"families[" + std::to_string(again - in.families.begin() + 1) + "].family",
          container == again->family
              ? say("the family '{1}' is named twice", again->family.view())
              : say("the sections '{1}' are part of the family '{2}'", again->family.view(), container.view()),
          say("leave it out here")};
}

bool Lightest::room_for_one(const Input& in) {
  const bool free = !is_set(in.h_max) && !is_set(in.b_max);
  return free || !families_known(in) || any_row(in, [](const TableSection&) { return true; });
}

FieldFault Lightest::no_room(const Input& in) {
  std::string limits;
  if (is_set(in.h_max)) limits = "h_max = " + format_quantity(in_si(in.h_max), mm.symbol);
  if (is_set(in.b_max))
    limits += (limits.empty() ? "b_max = " : ", b_max = ") + format_quantity(in_si(in.b_max), mm.symbol);
  return {is_set(in.h_max) ? "h_max" : "b_max", say("no section of {1} fits within {2}", names_of(in.families), limits),
          say("give more by h_max, b_max, or leave them out")};
}

bool Lightest::kind_fits(const Input& in) {
  const bool hollow = in.kind == SectionKind::hot_hollow || in.kind == SectionKind::cold_hollow;
  return hollow || in.kind == SectionKind::unsaid || !any_row(in, &is_open_tube);
}

FieldFault Lightest::kind_of_tubes(const Input& in) {
  return {"kind", say("round tubes must be hot_hollow or cold_hollow, not {1}", word_of(in.kind)), {}};
}

bool Lightest::fibres_known(const Input& in) { return fibreless(in) == nullptr; }

FieldFault Lightest::no_fibre(const Input& in) {
  return {
      in.e_y > 0.0 * mm    ? "e_y"
      : in.e_z > 0.0 * mm  ? "e_z"
      : in.e_0y > 0.0 * mm ? "e_0y"
                           : "e_0z",
      say("the extreme fibre of {1} is not at half the side, so the secant formula is not available for these sections",
          fibreless(in)->name()),
      say("leave out e_y, e_z, e_0y, e_0z and take another method, or give column.buckling the section with c_y or "
          "c_z")};
}

bool Lightest::strengths_rise(const Input& in) {
  return std::is_sorted(in.strengths.begin(), in.strengths.end(),
                        [](const Strength& a, const Strength& b) { return a.t_max < b.t_max; });
}

/// A material fills both: R_e then is one of them.
bool Lightest::one_strength(const Input& in) {
  return in.strengths.empty() || !is_set(in.R_e) ||
         std::any_of(in.strengths.begin(), in.strengths.end(), [&](const Strength& s) { return s.R_e == in.R_e; });
}

bool Lightest::strength_in_tension(const Input& in) {
  return !(in.N > 0.0 * kN) || is_set(in.R_e) || !in.strengths.empty();
}

Method Lightest::method_of(const Input& in) {
  return in.method != Method::unsaid ? in.method : default_method(with_a_strength(in), true);
}

/// Missing buckling curves and strengths are reported per section.
bool Lightest::needs_of_method(const Input& in) {
  return missing_inputs(with_a_strength(in), method_of(in), true).empty();
}
FieldFault Lightest::missing_for_method(const Input& in) {
  return column::missing_for_method(with_a_strength(in), method_of(in), true);
}
bool Lightest::one_carries(const Input& in) { return quick(in).carrying > 0.0; }

FieldFault Lightest::none_carries(const Input& in) {
  const Result r = quick(in);
  const std::string names = names_of(in.families);
  const auto& all = sections_by_mass();
  const auto best = std::find_if(all.begin(), all.end(), [&](const TableSection& s) { return r.section == s.name(); });
  const Failure failure = failure_of(bar_of(in, *best), r);
  const bool all_judged =
      in.strengths.empty() || !any_row(in, [&](const TableSection& s) { return !is_set(strength_of(in, s.t_f)); });
  if (failure == Failure::load) {
    return {"",
            say(all_judged ? "no section of {1} carries {2}; the strongest is {3}"
                           : "no section of {1} whose strength is given carries {2}; the strongest of these is {3}",
                names, format_quantity(in_si(r.F), kN.symbol), r.section.view()),
            say("name heavier families, or hold the bar better")};
  }
  return {
      "",
      say("no section of {1} carries the bar; nearest is {2}: {3}", names, r.section.view(), choice_of(failure).doc),
      remedy_of(failure)};
}

namespace {

/// The last of the available outlines; whether there is no other.
std::pair<Outline, bool> outlines_of(const Lightest::Input& in) {
  Outline least = Outline::open, most = Outline::solid;
  for (const TableSection& section : sections_by_mass()) {
    if (!belongs(section, in)) continue;
    const Outline outline = Buckling::outline_of(bar_of(in, section));
    least = std::min(least, outline), most = std::max(most, outline);
  }
  return {most, least >= most};
}

}  // namespace

/// Outline of the section found, if the sections differ: the first that carries the bar.
Outline Lightest::outline_of(const Input& in) {
  const auto [most, is_only] = outlines_of(in);
  if (is_only) return most;
  NoTrace quiet;
  for (const TableSection& section : sections_by_mass()) {
    if (!belongs(section, in)) continue;
    const Buckling::Input bar = bar_of(in, section);
    if (failure_of(bar, Buckling::evaluate(bar, quiet)) == Failure::none) return Buckling::outline_of(bar);
  }
  return most;
}

}  // namespace loadpath::column
