// The shaft as it whirls with what sits on it: critical speeds and frequencies with the moments that turn discs, and
// the shaft's own pieces, out of their planes.
#pragma once

#include "calculators/shaft/design/bending.hpp"
#include "lib/beam/whirl.hpp"

#include <optional>

namespace loadpath::shaft {

/// Nothing where no seat says how it turns as a disc, or a mass is not known.
std::optional<beam::Whirl> whirl_of(const Design::Input& in, const Elastic& elastic);

/// Of the lowest modes critical speeds, and frequencies at the speed of the shaft.
template <class Tracer>
void judge_whirl(const Design::Input& in, const Elastic& elastic, Design::Result& r, Tracer& trace);

/// Their frequencies over the speed; nothing where one of these is not known.
std::optional<draw::Figure> campbell(const Design::Input& in, const Elastic& elastic, const Design::Result& r);

}  // namespace loadpath::shaft
