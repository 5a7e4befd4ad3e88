// The shaft as it whirls with what sits on it: critical speeds and frequencies with the moments that turn discs, and
// the shaft's own pieces, out of their planes.
#pragma once

#include "calculators/shaft/design/model/bending.hpp"
#include "calculators/shaft/design/model/result.hpp"
#include "lib/beam/whirl.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <optional>

namespace loadpath::shaft {

/// Nothing where no seat says how it turns as a disc, or a mass is not known.
std::optional<beam::Whirl> whirl_of(const DesignInput& in, const Elastic& elastic);

/// Critical speeds of the lowest modes, and frequencies at the speed of the shaft.
template <class Tracer>
void judge_whirl(const DesignInput& in, const Elastic& elastic, DesignResult& r, Tracer& trace);

/// Their frequencies over the speed; nothing where one of these is not known.
std::optional<figure::Figure> campbell(const DesignInput& in, const Elastic& elastic, const DesignResult& r);

}  // namespace loadpath::shaft
