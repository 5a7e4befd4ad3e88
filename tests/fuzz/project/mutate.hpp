// Changes of a project that a user could make, or a slip of the hand: values and lines of other projects, numbers at
// the ends of what there is, other units and words, lines twice or not at all. Bytes alone would seldom pass the
// reader.
#pragma once

#include <cstddef>
#include <random>
#include <string>

namespace loadpath::fuzz {

using Random = std::minstd_rand;

/// The project with a change or two; a seed where there is no project to change.
std::string mutated(std::string text, Random& random);
/// One project with steps of another.
std::string crossed(const std::string& a, const std::string& b, Random& random);

}  // namespace loadpath::fuzz
