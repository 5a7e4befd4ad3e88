// The governing derivations of page 3, within its height.
#pragma once

#include "lib/report/brief/governing.hpp"
#include "lib/report/document.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::report {

struct Derivations {
  std::vector<Panel> panels;
  std::set<std::string> sources;  // keys that their reasons name
  double height = 0.0;            // mm
};
/// The derivation of the governing mode of each component, in the order of the rows, as far as the height suffices, mm.
/// At most 30 lines of each are set in full; the lines before are a text, so that each factor has its formula or
/// source.
Derivations governing_derivations(const project::Project& project, const std::vector<Governing>& rows, double height);

/// Whether they lose no line if `used` of the height, mm, is that of something else.
bool keeps_lines(const project::Project& project, const std::vector<Governing>& rows, double height, double used);

/// The height of a derivation as it is set, mm.
double height_of(const Derivation& derivation);

}  // namespace loadpath::report
