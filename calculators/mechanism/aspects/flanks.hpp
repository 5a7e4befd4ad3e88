// Where the loaded flanks of teeth change: the play between them is passed there.
#pragma once

#include "lib/account/account.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/quantity/series.hpp"

#include <optional>

namespace loadpath::planar {

/// Of gears and racks over a cycle; nothing without them.
std::optional<account::Table> flank_table(const account::Account& account, const mechanism::Model& model,
                                          const Axis* axis);

}  // namespace loadpath::planar
