// The cells and walls of section.thin_walled: their sizes, and the equations of equal twist.
#pragma once

#include "calculators/section/torsion/thin_walled_types.hpp"

#include <array>
#include <cstddef>

namespace loadpath::section {

/// The place of a cell in the list; that behind the last for the outside.
std::size_t cell_of(const ThinWalledTypes::Input& in, const Name& name);

Length length_of(const ThinWalledTypes::Wall& wall);
/// Its longest straight part, as far as it is known.
Length longest_side(const ThinWalledTypes::Wall& wall);
Area area_of(const ThinWalledTypes::Cell& cell);
/// Its shear modulus over that of the section.
double modulus_ratio(const ThinWalledTypes::Input& in, const ThinWalledTypes::Wall& wall);
bool is_free(const ThinWalledTypes::Wall& wall);
/// Length of all walls around a cell.
Length perimeter_of(const ThinWalledTypes::Input& in, std::size_t cell);

/// For each cell its shear flow over G theta: sum over its walls of l/(n t) (f - f_beside) = 2 A.
using Flows = List<Area, most_cells>;
Flows flows_of(const ThinWalledTypes::Input& in);

}  // namespace loadpath::section
