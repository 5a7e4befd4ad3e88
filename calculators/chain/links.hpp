// Links and centre distance of a chain around two sprockets, each exactly from the other.
//
// The chain lies on circles whose circumference is z pitches. With the lean gamma of the strands the centre distance
// is p (z_2 - z_1)/(2 pi sin gamma), and the number of links depends only on cot gamma + gamma, the involute function
// of the complement of gamma: so both directions have a closed form.
#pragma once

namespace loadpath::chain {

/// Number of links, not rounded, at the centre distance of `pitches` > |z_2 - z_1|/(2 pi).
[[nodiscard]] double links_at(double pitches, double z_1, double z_2);

/// Centre distance in pitches of a chain with so many links; NaN where it does not reach around.
[[nodiscard]] double pitches_of(double links, double z_1, double z_2);

}  // namespace loadpath::chain
