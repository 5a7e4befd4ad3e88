// Sizes of one part that are exchanged for each other: some larger and others smaller. Where a check concerns the part
// as one (deflection, critical speed), no single size can be lowered, and yet another combination may be cheaper.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/search/joint_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

namespace {

/// How many sizes up and down all are varied together: as many as few enough combinations allow; 0: none.
std::size_t reach_of(std::size_t count) {
  constexpr double most_combinations = 1000.0;
  for (const std::size_t reach : {std::size_t{2}, std::size_t{1}}) {
    const double choices = 2.0 * static_cast<double>(reach) + 1.0;
    if (std::pow(choices, static_cast<double>(count)) <= most_combinations) return reach;
  }
  return 0;
}

}  // namespace

/// The sizes, those of one size with `first` at `at`.
SizeIndices JointSearch::with_group(SizeIndices indices, std::size_t first, std::size_t at) const {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (sizes_.at(i).like == first) indices[i] = at;
  }
  return indices;
}

bool JointSearch::is_cheaper(const SizeIndices& tried, double lowest) {
  return sizes_.set(tried) && numerics::exceeds(lowest, sizes_.cost());
}

bool JointSearch::takes_cheaper(const SizeIndices& tried, SizeIndices& least, double& lowest) {
  if (!is_cheaper(tried, lowest) || !passes()) return false;
  lowest = sizes_.cost();
  least = sizes_.now();
  return true;
}

/// One of them as large as it may be and still cheaper: it makes up for the others.
bool JointSearch::takes_with_one_raised(const SizeIndices& tried, std::size_t first, SizeIndices& least,
                                        double& lowest) {
  std::size_t at = tried[first];
  while (at + 1 < sizes_.sizes(first).size() && is_cheaper(with_group(tried, first, at + 1), lowest)) ++at;
  return at > tried[first] && takes_cheaper(with_group(tried, first, at), least, lowest);
}

/// One round about the sizes that were found; whether it found cheaper ones.
bool JointSearch::exchange_once(SizeIndices& least, const SizeIndices& floors, std::size_t reach) {
  const SizeIndices firsts = sizes_.firsts();
  const std::size_t choices = 2 * reach + 1;
  sizes_.set(least);
  const SizeIndices centre = sizes_.now();
  double lowest = sizes_.cost();
  std::size_t combinations = 1;
  for (std::size_t i = 0; i < firsts.size(); ++i) combinations *= choices;
  bool improved = false;
  for (std::size_t which = 0; which < combinations; ++which) {
    SizeIndices tried = centre;
    bool exists = true;
    std::size_t rest = which;
    for (const std::size_t first : firsts) {
      const std::size_t at = centre[first] + rest % choices;
      rest /= choices;
      exists = exists && at >= reach + floors[first];
      if (exists) tried = with_group(std::move(tried), first, at - reach);
    }
    if (!exists || !is_cheaper(tried, lowest)) continue;
    improved = takes_cheaper(tried, least, lowest) || improved;
    for (const std::size_t first : firsts) {
      if (tried[first] == centre[first]) improved = takes_with_one_raised(tried, first, least, lowest) || improved;
    }
  }
  return improved;
}

/// One of them smaller by as little as makes the part cheaper, or a little more.
bool JointSearch::takes_with_one_lowered(const SizeIndices& raised, std::size_t first, std::size_t floor,
                                         SizeIndices& least, double& lowest) {
  std::size_t left = 3;
  bool improved = false;
  for (std::size_t at = raised[first]; left > 0 && at-- > floor;) {
    const SizeIndices tried = with_group(raised, first, at);
    if (!is_cheaper(tried, lowest)) continue;
    --left;
    improved = takes_cheaper(tried, least, lowest) || improved;
  }
  return improved;
}

/// One size a few steps larger for another one that is smaller; whether it found cheaper ones.
bool JointSearch::exchange_pairs(SizeIndices& least, const SizeIndices& floors) {
  constexpr std::size_t most_raised = 3;
  const SizeIndices firsts = sizes_.firsts();
  sizes_.set(least);
  const SizeIndices centre = sizes_.now();
  double lowest = sizes_.cost();
  bool improved = false;
  for (const std::size_t larger : firsts) {
    const std::size_t room = sizes_.sizes(larger).size() - centre[larger] - 1;
    for (std::size_t up = 1; up <= std::min(most_raised, room); ++up) {
      const SizeIndices raised = with_group(centre, larger, centre[larger] + up);
      for (const std::size_t smaller : firsts) {
        if (smaller == larger) continue;
        improved = takes_with_one_lowered(raised, smaller, floors[smaller], least, lowest) || improved;
      }
    }
  }
  return improved;
}

void JointSearch::exchange(SizeIndices& least) {
  const std::size_t reach = reach_of(sizes_.firsts().size());
  if (reach == 0) return;
  const SizeIndices floors = floors_below(least);
  while (exchange_once(least, floors, reach) || exchange_pairs(least, floors)) lower_alone(least);
  sizes_.set(least);
}

}  // namespace loadpath::project
