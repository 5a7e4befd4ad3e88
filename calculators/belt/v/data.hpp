// V-belts by the tables: the ratings of each basis, and the data that belong only to its rating.
//
// A basis is a system of ratings with the factors that were made for it. Nothing of one basis is ever used with
// another: an arc-of-contact factor of one with the rating of another overstates a drive by up to 15 %.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/table/rows.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::belt {

enum class Basis { unstated, iso, optibelt };

/// A section as listed in a result.
enum class SectionWord { none, Z, A, B, C, D, E, SPZ, SPA, SPB, SPC };

/// A section on a basis: constants of its rated power, its mass, its groove, its limits. Meaning:
/// tables/belt/v_iso.toml.
struct VRow {
  static constexpr auto group = "v_belt";
  double C_1 = unset<double>, C_2 = unset<double>, C_3 = unset<double>, C_4 = unset<double>;
  double a_1 = 0.0, b_1 = 0.0, a_2 = 0.0, b_2 = 0.0, a_3 = 0.0, b_3 = 0.0, a_4 = 0.0, b_4 = 0.0;
  Length d_low = unset<Length>, d_high = unset<Length>, d_least = unset<Length>;
  AngularSpeed n_low = unset<AngularSpeed>, n_high = unset<AngularSpeed>;
  LineDensity m = unset<LineDensity>;
  Length w_d = unset<Length>, h_a = unset<Length>, h_b = unset<Length>, e = unset<Length>, f = unset<Length>,
         d_phi = unset<Length>;
  double phi_1 = unset<double>, phi_2 = unset<double>;
  Speed v_max = unset<Speed>;
  AngularSpeed f_B_max = unset<AngularSpeed>;
  Force C_0 = from_si<Force>(0.0);
  Time L_h = unset<Time>;

  static constexpr Fields fields{Field{&VRow::C_1, "C_1", ratio, "constant of the rated power"},
                                 Field{&VRow::C_2, "C_2", ratio, "constant of the rated power"},
                                 Field{&VRow::C_3, "C_3", ratio, "constant of the rated power"},
                                 Field{&VRow::C_4, "C_4", ratio, "constant of the rated power"},
                                 Field{&VRow::a_1, "a_1", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::b_1, "b_1", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::a_2, "a_2", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::b_2, "b_2", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::a_3, "a_3", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::b_3, "b_3", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::a_4, "a_4", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::b_4, "b_4", ratio, "power increment for the speed ratio"},
                                 Field{&VRow::d_low, "d_low", mm, "minimum rated diameter"},
                                 Field{&VRow::d_high, "d_high", mm, "maximum rated diameter"},
                                 Field{&VRow::d_least, "d_least", mm, "minimum recommended diameter"},
                                 Field{&VRow::n_low, "n_low", rpm, "lowest rated speed"},
                                 Field{&VRow::n_high, "n_high", rpm, "highest rated speed"},
                                 Field{&VRow::m, "m", kg_per_m, "mass per length of one belt"},
                                 Field{&VRow::w_d, "w_d", mm, "datum width"},
                                 Field{&VRow::h_a, "h_a", mm, "height of the groove above the datum diameter"},
                                 Field{&VRow::h_b, "h_b", mm, "depth of the groove below the datum diameter"},
                                 Field{&VRow::e, "e", mm, "pitch of the grooves"},
                                 Field{&VRow::f, "f", mm, "from the last groove to the edge"},
                                 Field{&VRow::d_phi, "d_phi", mm, "maximum diameter with the groove angle phi_1"},
                                 Field{&VRow::phi_1, "phi_1", deg, "groove angle of small pulleys"},
                                 Field{&VRow::phi_2, "phi_2", deg, "groove angle of large pulleys"},
                                 Field{&VRow::v_max, "v_max", m_per_s, "maximum speed"},
                                 Field{&VRow::f_B_max, "f_B_max", Hz, "maximum bending frequency"},
                                 Field{&VRow::C_0, "C_0", N, "stiffness of the belt against the test force"},
                                 Field{&VRow::L_h, "L_h", hour, "life for which the rating is stated"}};
};

struct VLengthRow {
  static constexpr auto group = "v_belt_length";
  Length L = unset<Length>;
  double c_L = unset<double>;
  static constexpr Fields fields{Field{&VLengthRow::L, "L", mm, "datum length"},
                                 Field{&VLengthRow::c_L, "c_L", ratio, "length factor"}};
};

/// A row of v_belt with the lengths that are made, ascending.
struct VSection {
  Basis basis = Basis::unstated;
  Name name;
  VRow row;
  std::vector<VLengthRow> lengths;
};

std::span<const VSection> v_sections();
/// Nothing where the basis has no such section.
const VSection* find_v_section(Basis basis, const Name& name);
/// The word for the name of a section.
SectionWord word_of(const Name& name);
/// "Z, A, B"
std::string names_of_v_sections(Basis basis);

/// The pulleys of a basis that are made, ascending.
std::span<const Length> v_pulleys(Basis basis);
/// Whether a list has this pulley, or this belt of the section, to the last bits of rounding.
bool is_sold_pulley(Length d);
bool is_sold_belt(const VSection& section, Length L);

/// The length factor: of the table, linear between its lengths; NaN outside of them.
double v_length_factor(const VSection& section, Length L);
/// The arc-of-contact factor of the Optibelt basis, linear between the rows of its table; NaN outside.
double optibelt_wrap_factor(double alpha);
double least_optibelt_wrap();

/// The share that each of z belts carries, ISO basis: the low or the high end of its range.
double v_count_factor(double z, bool high_end);

/// The service factor of the Optibelt basis, by the name of a row ("light, normal torque") and the hours of a day.
double optibelt_service_factor(std::string_view row, double hours);

constexpr auto choices_of(Basis) {
  return std::array{ChoiceName<Basis>{Basis::unstated, "not_given", "not given", "unstated"},
                    ChoiceName<Basis>{Basis::iso, "iso", "ISO 5292 and GOST 1284.3-96: classical sections"},
                    ChoiceName<Basis>{Basis::optibelt, "optibelt", "Optibelt: wrapped wedge and classical sections"}};
}

constexpr auto choices_of(SectionWord) {
  using Word = SectionWord;
  return std::array{ChoiceName<Word>{Word::none, "none", "no section, or one that the tables were given"},
                    ChoiceName<Word>{Word::Z, "Z", "classical section, 10 mm wide"},
                    ChoiceName<Word>{Word::A, "A", "classical section, 13 mm wide"},
                    ChoiceName<Word>{Word::B, "B", "classical section, 17 mm wide"},
                    ChoiceName<Word>{Word::C, "C", "classical section, 22 mm wide"},
                    ChoiceName<Word>{Word::D, "D", "classical section, 32 mm wide"},
                    ChoiceName<Word>{Word::E, "E", "classical section, 40 mm wide"},
                    ChoiceName<Word>{Word::SPZ, "SPZ", "wedge section, 9.7 mm wide"},
                    ChoiceName<Word>{Word::SPA, "SPA", "wedge section, 12.7 mm wide"},
                    ChoiceName<Word>{Word::SPB, "SPB", "wedge section, 16.3 mm wide"},
                    ChoiceName<Word>{Word::SPC, "SPC", "wedge section, 22 mm wide"}};
}

}  // namespace loadpath::belt
