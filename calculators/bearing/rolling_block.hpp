// A block of the load spectrum of a bearing: a fraction of the time with one load and one speed.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <algorithm>

namespace loadpath::bearing {

struct Block {
  Name name;
  double q = unset<double>, k = 1.0;
  AngularSpeed n = unset<AngularSpeed>;
  Force F_r = unset<Force>, F_a = unset<Force>;
  static constexpr Fields fields{
      NameField{&Block::name, "name", "name of the block"}.may_be_missing(),
      Field{&Block::q, "q", ratio, "fraction of time; all fractions sum to 1"}.within(0, 1).positive(),
      Field{&Block::k, "k", ratio, "loads of the block / F_r and F_a of the step"}.at_least(0).usually(0, 10),
      Field{&Block::n, "n", rpm, "speed of the block; omitted: n"}.at_least(0).may_be_missing(),
      Field{&Block::F_r, "F_r", kN, "radial load of the block; omitted: k F_r"}.load().at_least(0).may_be_missing(),
      Field{&Block::F_a, "F_a", kN, "axial load of the block, its sign as that of F_a; omitted: k F_a"}
          .load()
          .may_be_missing()};
};

/// The loads of a block, without K_A; the axial one as given, not yet shared by a pair.
template <class Input>
constexpr Force radial_of(const Input& in, const Block& b) {
  return is_set(b.F_r) ? b.F_r : b.k * in.F_r;
}
template <class Input>
constexpr Force axial_of(const Input& in, const Block& b) {
  return is_set(b.F_a) ? b.F_a : b.k * in.F_a;
}

template <class Input>
bool has_own_loads(const Input& in) {
  return std::any_of(in.blocks.begin(), in.blocks.end(), [](const Block& b) { return is_set(b.F_r) || is_set(b.F_a); });
}

/// Whether one of the blocks has at least the loads of the step.
template <class Input>
bool holds_loads_of_step(const Input& in) {
  constexpr double nearly = 1.0 - 1e-9;
  return in.blocks.empty() || std::any_of(in.blocks.begin(), in.blocks.end(), [&](const Block& b) {
           return radial_of(in, b) >= nearly * in.F_r && abs(axial_of(in, b)) >= nearly * abs(in.F_a);
         });
}

/// Whether k of no block scales nothing.
template <class Input>
bool has_loads_once(const Input& in) {
  return std::none_of(in.blocks.begin(), in.blocks.end(),
                      [](const Block& b) { return is_set(b.F_r) && is_set(b.F_a) && b.k != 1.0; });
}

/// The radial load of the mate in a block is known only where k scales both.
template <class Input>
bool scales_pair(const Input& in) {
  return !is_set(in.mate.F_r) ||
         std::none_of(in.blocks.begin(), in.blocks.end(), [](const Block& b) { return is_set(b.F_r); });
}

template <class Input>
constexpr auto block_rules() {
  return std::array{
      Rule<Input>{&holds_loads_of_step<Input>, "blocks, F_r, F_a",
                  "no block has the loads F_r and F_a: give the loads of the largest block, k = 1"},
      Rule<Input>{&has_loads_once<Input>, "blocks",
                  "a block with loads of its own, F_r and F_a, is not scaled: omit k there"},
      Rule<Input>{&scales_pair<Input>, "blocks, mate",
                  "the radial load of the mate in a block follows from k: omit F_r of the block, and give k"}};
}

}  // namespace loadpath::bearing
