// The power that friction and meshing take in a joint.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>

namespace loadpath::planar {

/// W.
double loss_of(const mechanism::Model& model, std::size_t joint, const mechanism::Position& at);

}  // namespace loadpath::planar
