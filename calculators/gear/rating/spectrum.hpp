// Load spectrum of a rating: blocks of torque and speed with their fraction of the life, and what they do to the teeth.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::gear {

struct LoadBlock {
  Name name;
  double q = unset<double>, k = 1.0;
  AngularSpeed n = unset<AngularSpeed>;
  static constexpr Fields fields{
      NameField{&LoadBlock::name, "name", "name of the block"}.may_be_missing(),
      Field{&LoadBlock::q, "q", ratio, "fraction of time; all fractions sum to 1"}.within(0, 1).positive(),
      Field{&LoadBlock::k, "k", ratio, "torque of the block / T_1; starts and stops included"}.at_least(0).usually(0,
                                                                                                                   10),
      Field{&LoadBlock::n, "n", rpm, "speed of gear 1 in the block; omitted: n_1"}.positive().may_be_missing()};
};
inline constexpr std::size_t most_load_blocks = 32;

/// One block with its cycles and its share of the life of both gears.
struct BlockDamage {
  Name name;
  double q = unset<double>;
  Moment T = unset<Moment>;
  AngularSpeed n = unset<AngularSpeed>;
  double N_1 = unset<double>, N_2 = unset<double>, K_V = unset<double>, K_Hbeta = unset<double>;
  double D_H1 = unset<double>, D_H2 = unset<double>, D_F1 = unset<double>, D_F2 = unset<double>;
  static constexpr Fields fields{NameField{&BlockDamage::name, "name", "name of the block"},
                                 Field{&BlockDamage::q, "q", ratio, "fraction of time"},
                                 Field{&BlockDamage::T, "T", N_m, "torque of gear 1, without K_A"},
                                 Field{&BlockDamage::n, "n", rpm, "speed of gear 1"},
                                 Field{&BlockDamage::N_1, "N_1", ratio, "load cycles of a tooth of gear 1"},
                                 Field{&BlockDamage::N_2, "N_2", ratio, "load cycles of a tooth of gear 2"},
                                 Field{&BlockDamage::K_V, "K_V", ratio, "dynamic factor"},
                                 Field{&BlockDamage::K_Hbeta, "K_Hbeta", ratio, "face load factor, contact"},
                                 Field{&BlockDamage::D_H1, "D_H1", ratio, "pitting damage, gear 1"},
                                 Field{&BlockDamage::D_H2, "D_H2", ratio, "pitting damage, gear 2"},
                                 Field{&BlockDamage::D_F1, "D_F1", ratio, "tooth root damage, gear 1"},
                                 Field{&BlockDamage::D_F2, "D_F2", ratio, "tooth root damage, gear 2"}};
};

template <class Input>
constexpr auto spectrum_inputs() {
  return Fields{ListField{&Input::blocks, "blocks",
                          "load spectrum: blocks of torque and speed with time fractions (ISO 6336-6); omitted: T_1 "
                          "for the entire life"}
                    .may_be_missing()};
}

template <class Result>
constexpr auto spectrum_results() {
  return Fields{
      Field{&Result::D_H1, "D_H1", ratio, "pitting damage sum at S_Hmin, gear 1"},
      Field{&Result::D_H2, "D_H2", ratio, "pitting damage sum at S_Hmin, gear 2"},
      Field{&Result::D_F1, "D_F1", ratio, "tooth root damage sum at S_Fmin, gear 1"},
      Field{&Result::D_F2, "D_F2", ratio, "tooth root damage sum at S_Fmin, gear 2"},
      Field{&Result::T_H1, "T_H1", N_m, "equivalent torque of the spectrum for pitting of gear 1, on gear 1"},
      Field{&Result::T_H2, "T_H2", N_m, "equivalent torque of the spectrum for pitting of gear 2, on gear 1"},
      Field{&Result::T_F1, "T_F1", N_m, "equivalent torque of the spectrum for the root of gear 1, on gear 1"},
      Field{&Result::T_F2, "T_F2", N_m, "equivalent torque of the spectrum for the root of gear 2, on gear 1"},
      Field{&Result::K_AH, "K_AH", ratio, "application factor of the spectrum for pitting: equivalent torque / T_1"},
      Field{&Result::K_AF, "K_AF", ratio, "application factor of the spectrum for the root: equivalent torque / T_1"},
      ListField{&Result::blocks, "blocks", "the blocks"}};
}

template <class Input>
double sum_of_fractions(const Input& in) {
  double sum = 0.0;
  for (const LoadBlock& b : in.blocks) sum += b.q;
  return sum;
}
/// Peak torques above T_1 that blocks state: each block is compared with the static limits, however short it is, in the
/// modes of pitting and tooth breakage.
template <class Input>
Applies unrated_peaks(const Input& in) {
  const bool has_peaks = std::any_of(in.blocks.begin(), in.blocks.end(), [](const LoadBlock& b) { return b.k > 1.0; });
  return has_peaks ? Applies::no : Applies::unseen;
}

template <class Input>
bool fractions_close(const Input& in) {
  return in.blocks.empty() || std::abs(sum_of_fractions(in) - 1.0) <= 1e-3 * (1.0 + 1e-9);
}
template <class Input>
FieldFault open_fractions(const Input& in) {
  return {"blocks", say("the fractions q sum to {1}, not to 1", format_number(sum_of_fractions(in))),
          say("give every block its fraction of the time in which the gears run")};
}

template <class Input>
constexpr auto spectrum_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return in.blocks.empty() || is_set(in.L_h); }, "blocks, L_h",
                  "a load spectrum needs the required life L_h"},
      Rule<Input>{[](const Input& in) { return in.blocks.empty() || in.standard == decltype(in.standard)::iso6336; },
                  "blocks, standard", "a load spectrum is rated by ISO 6336-6: standard = \"iso6336\""},
      Rule<Input>{[](const Input& in) {
                    return in.blocks.empty() || std::any_of(in.blocks.begin(), in.blocks.end(),
                                                            [](const LoadBlock& b) { return b.k >= 1.0; });
                  },
                  "blocks, T_1", "no block has the torque T_1: give the torque of the largest block, k = 1"},
      Rule<Input>{&fractions_close<Input>, "blocks", "the fractions q of the blocks must sum to 1",
                  &open_fractions<Input>}};
}

}  // namespace loadpath::gear
