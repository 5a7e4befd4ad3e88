// Reads a table of a project file into the record of a calculator.
#pragma once

#include "lib/project/read/reading.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

/// Reads `table` into a fresh record, or into one that `from` lays out: an existing element is updated with the
/// values given under its name. Keys in `reserved` are left to the caller; `prefix` starts the keys of issues.
Reading read_record(const toml::Tree& table, const RecordType& type, const Template* from, const std::string& prefix,
                    const std::vector<std::string>& reserved, std::vector<Issue>& issues);

/// Marks the fields that are not typed as faulty: a record with an error might have given them.
void mark_untyped(Reading& reading);

}  // namespace loadpath::project
