// Where the loaded flanks of teeth change: the play between them is passed there.
#pragma once

#include "lib/mechanism/model.hpp"
#include "lib/project/step.hpp"
#include "lib/quantity/series.hpp"
#include "lib/report/document.hpp"

#include <optional>

namespace loadpath {

/// Of gears and racks over a cycle; nothing without them.
std::optional<report::Table> flank_table(const project::Account& account, const mechanism::Model& model,
                                         const Axis* axis);

}  // namespace loadpath
