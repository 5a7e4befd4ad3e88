// A calculator over columns, on several threads.
#pragma once

#include "api/given.hpp"

#include <loadpath/sweep.hpp>

namespace loadpath::api {

Sweep sweep_of(const loadpath::Calculator& calculator, const Call& call, const SweepOptions& options);

}  // namespace loadpath::api
