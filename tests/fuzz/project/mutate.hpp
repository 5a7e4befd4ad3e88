// Changes of a project that a user could make, deliberately or by mistake: values and lines of other projects,
// numbers at the limits of the range, other units and words, lines repeated or omitted. Random bytes would seldom
// pass the reader.
#pragma once

#include <cstddef>
#include <random>
#include <string>

namespace loadpath::fuzz {

using Random = std::minstd_rand;

/// The project with a change or two; a seed if there is no project to change.
std::string mutated(std::string text, Random& random);
/// One project with steps of another.
std::string crossed(const std::string& a, const std::string& b, Random& random);

}  // namespace loadpath::fuzz
