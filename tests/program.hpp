// What differs between the programs that the test cases are linked to: loadpath with sanitizers, or without.
#pragma once

namespace loadpath::test {

extern const char* const program;  // path of the program under test
extern const bool sanitized;       // built with sanitizers, which make it ten times as slow

}  // namespace loadpath::test
