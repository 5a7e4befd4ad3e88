#include "tests/program.hpp"

namespace loadpath::test {

const char* const program = LOADPATH_PROGRAM;
const bool sanitized = LOADPATH_SANITIZED;

}  // namespace loadpath::test
