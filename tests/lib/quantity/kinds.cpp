#include "lib/quantity/kinds.hpp"

#include "lib/quantity/literal.hpp"

#include <doctest/doctest.h>

namespace {

using loadpath::Dimension;
using loadpath::Kind;
using loadpath::Meant;

constexpr Dimension stress = Dimension::of(-1, 1, -2), work = Dimension::of(2, 1, -2), number{};
constexpr Dimension frequency = Dimension::of(0, 0, -1), turning = Dimension::of(0, 0, -1, 0, 1);
constexpr Dimension angle = Dimension::of(0, 0, 0, 0, 1), temperature = Dimension::of(0, 0, 0, 1);

Meant of_stress(const char* symbol, const char* meaning) {
  return loadpath::kind_of_field({symbol, meaning, "MPa", stress, Kind::plain});
}

}  // namespace

TEST_SUITE("quantity kinds") {
  TEST_CASE("a stress is identified by its meaning, else by its symbol") {
    CHECK(of_stress("tau_max", "largest") == Meant::shear_stress);
    CHECK(of_stress("sigma_max", "maximum nominal stress") == Meant::normal_stress);
    CHECK(of_stress("sigma_v", "maximum von Mises stress") == Meant::equivalent_stress);
    CHECK(of_stress("sigma_T", "by Tresca, extreme fibre") == Meant::equivalent_stress);
    CHECK(of_stress("sigma_1", "equivalent stress of the shaft") == Meant::equivalent_stress);
    CHECK(of_stress("sigma_a", "amplitude of the shear stress") == Meant::shear_stress);
    CHECK(of_stress("tau_adm", "largest") == Meant::strength);
    CHECK(of_stress("tau_all", "largest") == Meant::strength);
    CHECK(of_stress("tau_adm_1", "allowable torsional stress") == Meant::strength);
    CHECK(of_stress("R_e", "yield strength") == Meant::strength);
    CHECK(of_stress("sigma_D", "fatigue limit of the part") == Meant::strength);
    CHECK(of_stress("sigma_AK", "permissible amplitude at this mean stress") == Meant::strength);
    CHECK(of_stress("sigma_C", "detail: its category") == Meant::strength);
    CHECK(of_stress("G", "shear modulus") == Meant::nothing);
    CHECK(of_stress("s", "standard deviation of the strength") == Meant::nothing);
    CHECK(of_stress("a_T", "constant of Tetmajer") == Meant::nothing);
    CHECK(of_stress("sigma_0", "constant of the fatigue limit") == Meant::nothing);
    CHECK(of_stress("p", "bearing pressure in the bore") == Meant::nothing);
  }

  TEST_CASE("work, moments, frequencies and temperatures are identified by their units") {
    using loadpath::kind_of_field;
    CHECK(kind_of_field({"T", "torque", "N*m", work, Kind::moment}) == Meant::torque);
    CHECK(kind_of_field({"A", "work", "J", work, Kind::energy}) == Meant::work);
    CHECK(kind_of_field({"x", "", "", work, Kind::plain}) == Meant::nothing);
    CHECK(kind_of_field({"f", "", "Hz", frequency, Kind::plain}) == Meant::frequency);
    CHECK(kind_of_field({"k", "", "1/s", frequency, Kind::plain}) == Meant::nothing);
    CHECK(kind_of_field({"n", "", "rpm", turning, Kind::plain}) == Meant::angular_speed);
    CHECK(kind_of_field({"t", "", "°C", temperature, Kind::temperature}) == Meant::temperature);
    CHECK(kind_of_field({"t", "", "K", temperature, Kind::difference}) == Meant::difference);
    CHECK(loadpath::kind_of_literal("25 Hz") == Meant::frequency);
    CHECK(loadpath::kind_of_literal("25 1/s") == Meant::nothing);
    CHECK(loadpath::kind_of_literal("20 kJ") == Meant::work);
    CHECK(loadpath::kind_of_literal("20 N*m") == Meant::nothing);
    CHECK(loadpath::kind_of_literal("5 kW") == Meant::nothing);
    CHECK(loadpath::kind_of_literal("120 rpm") == Meant::angular_speed);
    CHECK(loadpath::kind_of_literal("120 degC") == Meant::temperature);
    CHECK(loadpath::kind_of_literal("60 K") == Meant::nothing);  // a temperature or a difference
    CHECK(loadpath::kind_of_literal("HEA 160") == Meant::nothing);
  }

  TEST_CASE("a known kind is refused for another, except for compatible ones") {
    constexpr Meant stresses[] = {Meant::normal_stress, Meant::shear_stress, Meant::equivalent_stress};
    for (const Meant field : stresses) {
      for (const Meant given : stresses) CHECK(takes_kind(field, given) == (field == given));
      CHECK(takes_kind(field, Meant::nothing));
      CHECK(takes_kind(Meant::nothing, field));
      CHECK(takes_kind(field, Meant::strength));
      CHECK_FALSE(takes_kind(Meant::strength, field));
    }
    CHECK(takes_kind(Meant::normal_stress, Meant::uniaxial_stress));
    CHECK(takes_kind(Meant::equivalent_stress, Meant::uniaxial_stress));
    CHECK_FALSE(takes_kind(Meant::shear_stress, Meant::uniaxial_stress));
    CHECK_FALSE(takes_kind(Meant::torque, Meant::work));
    CHECK_FALSE(takes_kind(Meant::work, Meant::torque));
    CHECK_FALSE(takes_kind(Meant::temperature, Meant::difference));
    CHECK_FALSE(takes_kind(Meant::torque, Meant::strength));
  }

  TEST_CASE("an angle is left out where this causes no wrong factor") {
    using loadpath::fits_but_for_angle;
    CHECK(fits_but_for_angle(turning, turning, Meant::angular_speed, false));
    CHECK(fits_but_for_angle(turning, frequency, Meant::rate, false));
    CHECK_FALSE(fits_but_for_angle(turning, frequency, Meant::nothing, false));
    CHECK_FALSE(fits_but_for_angle(turning, frequency, Meant::frequency, true));
    CHECK_FALSE(fits_but_for_angle(frequency, turning, Meant::angular_speed, true));
    CHECK(fits_but_for_angle(angle, number, Meant::nothing, false));
    CHECK_FALSE(fits_but_for_angle(number, angle, Meant::nothing, false));
    CHECK(fits_but_for_angle(number, angle, Meant::nothing, true));
    CHECK(fits_but_for_angle(work, work * angle, Meant::nothing, false));
    CHECK_FALSE(fits_but_for_angle(work, stress, Meant::nothing, true));
    constexpr Dimension time = Dimension::of(0, 0, 1);
    CHECK_FALSE(fits_but_for_angle(time, time / angle, Meant::nothing, false));
    CHECK(fits_but_for_angle(time, time / angle, Meant::nothing, true));
  }
}
