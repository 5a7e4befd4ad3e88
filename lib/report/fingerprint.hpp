// The identification of a report's input: the same text gives the same words, another text others.
#pragma once

#include "lib/project/project.hpp"

#include <string>
#include <string_view>

namespace loadpath::report {

/// A name-based UUID, version 5 (RFC 4122, by SHA-1), of the project's text and of every file that it has read, in the
/// name space of object identifiers: of one file `uuidgen --sha1 --namespace @oid --name TEXT` prints it.
std::string fingerprint(std::string_view input, const project::Project& project);

}  // namespace loadpath::report
