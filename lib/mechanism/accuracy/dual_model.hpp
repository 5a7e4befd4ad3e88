// A mechanism whose numbers carry derivatives.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/numerics/dual.hpp"

namespace loadpath::mechanism {

using numerics::Dual;

/// The same, its numbers as constants.
BasicModel<Dual> as_dual(const Model& model);

}  // namespace loadpath::mechanism
