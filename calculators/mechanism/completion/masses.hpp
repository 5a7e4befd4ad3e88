// Where the mass of a link lies that names no mass centre: one rule for links that are written out and for templates.
//
// A link with joints at two points is the slender bar between them: its mass centre is the point S_LINK in the middle,
// J = m l^2 / 12. A link of one point, or a slide with joints at one, is a block: its mass is there. Any other, and
// what has wheels, needs its S. Whoever names an S that is not the joint of a block gives its J too.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/text/issue.hpp"

#include <functional>
#include <string>
#include <vector>

namespace loadpath::planar {

/// Names the mass centres of links that have a mass and no S, and says which have too little. Needs no values.
std::vector<FieldFault> name_mass_centres(Mechanism::Input& in, const std::function<bool(const std::string&)>& typed);
/// Without the mass centres that name_mass_centres has named.
Mechanism::Input without_named_centres(const Mechanism::Input& given,
                                       const std::function<bool(const std::string&)>& typed);
/// Bars with a point beyond their joints: what is there has a mass as well. Needs values, before `with_mass_centres`.
std::vector<FieldFault> check_bars(const Mechanism::Input& in);
/// Gives bars whose J is not typed that of a slender bar. Needs values.
void set_bar_inertia(Mechanism::Input& in, const std::function<bool(const std::string&)>& typed);
/// With the middles of bars among their points.
Mechanism::Input with_mass_centres(const Mechanism::Input& given);

}  // namespace loadpath::planar
