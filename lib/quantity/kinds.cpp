#include "lib/quantity/kinds.hpp"

#include <algorithm>
#include <array>

namespace loadpath {
namespace {

constexpr Dimension a_stress = Dimension::of(-1, 1, -2), a_work = Dimension::of(2, 1, -2);
constexpr Dimension a_frequency = Dimension::of(0, 0, -1), an_angular_speed = Dimension::of(0, 0, -1, 0, 1);
constexpr Dimension a_temperature = Dimension::of(0, 0, 0, 1), a_time = Dimension::of(0, 0, 1);
constexpr Dimension an_angle = Dimension::of(0, 0, 0, 0, 1);

/// A word in the meaning or the symbol of a stress, with its kind; the first match decides.
struct StressWord {
  std::string_view meaning, symbol;  // a part of the one, the start of the other; empty: any
  Meant kind;
};

constexpr std::array stress_words{
    StressWord{"modulus", "", Meant::nothing},
    StressWord{"deviation", "", Meant::nothing},
    StressWord{"constant", "", Meant::nothing},
    StressWord{"strength", "", Meant::strength},
    StressWord{"allow", "", Meant::strength},
    StressWord{"limit", "", Meant::strength},
    StressWord{"permissible amplitude at this", "", Meant::strength},
    StressWord{"its category", "", Meant::strength},
    StressWord{"shear", "", Meant::shear_stress},
    StressWord{"", "tau", Meant::shear_stress},
    StressWord{"equivalent", "", Meant::equivalent_stress},
    StressWord{"von Mises", "", Meant::equivalent_stress},
    StressWord{"Tresca", "", Meant::equivalent_stress},
    StressWord{"", "sigma", Meant::normal_stress},
};

Meant kind_of_stress(const Declaration& field) {
  if (field.symbol.ends_with("_adm") || field.symbol.ends_with("_all")) return Meant::strength;
  const auto found = std::find_if(stress_words.begin(), stress_words.end(), [&](const StressWord& word) {
    return field.meaning.find(word.meaning) != std::string_view::npos && field.symbol.starts_with(word.symbol);
  });
  return found == stress_words.end() ? Meant::nothing : found->kind;
}

}  // namespace

Meant kind_of_field(const Declaration& field) {
  if (field.dimension == a_stress) return kind_of_stress(field);
  if (field.dimension == a_work && field.kind == Kind::moment) return Meant::torque;
  if (field.dimension == a_work && field.kind == Kind::energy) return Meant::work;
  if (field.dimension == a_frequency && field.unit.find("Hz") != std::string_view::npos) return Meant::frequency;
  if (field.dimension == an_angular_speed) return Meant::angular_speed;
  if (field.dimension == a_temperature && field.kind == Kind::temperature) return Meant::temperature;
  if (field.dimension == a_temperature && field.kind == Kind::difference) return Meant::difference;
  return Meant::nothing;
}

Meant kind_of_unit(const Dimension& dimension, bool hertz, bool joules, bool scale) {
  if (dimension == a_temperature && scale) return Meant::temperature;  // K: a temperature or a difference
  if (dimension == an_angular_speed) return Meant::angular_speed;
  if (dimension == a_frequency && hertz) return Meant::frequency;
  return dimension == a_work && joules ? Meant::work : Meant::nothing;
}

std::string_view name_of(Meant kind) {
  switch (kind) {
    case Meant::nothing:
      return "a quantity";
    case Meant::normal_stress:
      return "a normal stress";
    case Meant::shear_stress:
      return "a shear stress";
    case Meant::equivalent_stress:
    case Meant::uniaxial_stress:
      return "an equivalent stress";
    case Meant::strength:
      return "a strength";
    case Meant::frequency:
      return "a frequency";
    case Meant::angular_speed:
      return "an angular velocity";
    case Meant::rate:
      return "radians per time";
    case Meant::work:
      return "an energy";
    case Meant::torque:
      return "a moment";
    case Meant::temperature:
      return "a temperature";
    case Meant::difference:
      return "a temperature difference";
  }
  return "a quantity";
}

bool takes_kind(Meant field, Meant given) {
  if (field == Meant::nothing || given == Meant::nothing || given == Meant::rate || field == given) return true;
  const bool in_one_direction = field == Meant::normal_stress || field == Meant::equivalent_stress;
  if (given == Meant::strength) return in_one_direction || field == Meant::shear_stress;  // a capacity
  return given == Meant::uniaxial_stress && in_one_direction;
}

bool fits_but_for_angle(const Dimension& wanted, const Dimension& given, Meant kind, bool turns) {
  if (given == wanted) return true;
  if (given.without_angle() != wanted.without_angle()) return false;
  if (wanted == an_angular_speed) return given == a_frequency && kind == Meant::rate;
  if (wanted == a_frequency) return false;
  if (wanted.is_number()) return given != an_angle || turns;
  if (wanted == a_time) return turns;
  return true;
}

}  // namespace loadpath
