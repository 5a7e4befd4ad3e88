// Several complete records that an input takes in turn, written in place of one record:
//   crank = { each = [{ n = "1200 rpm", ... }, { n = "1500 rpm", ... }] }
//   crank = { each = { slow = { ... }, fast = { ... } } }    which gives them names
// Every number in which they differ becomes one of the values of one input.
#pragma once

#include "lib/project/read/reading.hpp"

#include <functional>

namespace loadpath::project {

/// A table as one record.
using ReadOne = std::function<Reading(const toml::Tree& table, std::vector<Issue>& issues)>;

/// The table with the first of the records in each place, and the changes by the others.
Reading read_in_turn(const toml::Tree& table, const std::string& prefix, const ReadOne& read,
                     std::vector<Issue>& issues);

}  // namespace loadpath::project
