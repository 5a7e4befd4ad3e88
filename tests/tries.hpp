// The number of repetitions of tests that depend on chance, or take long and hardly differ from time to time.
#pragma once

#include "tests/program.hpp"

#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace loadpath::test {

/// Whether all is tried: LOADPATH_IN_FULL=1, as `.ci/run --all` has it for the ctests of the label "share".
inline bool in_full() {
  const char* const said = std::getenv("LOADPATH_IN_FULL");
  return said != nullptr && std::string_view(said) == "1";
}

/// All, or one of `of`. A suite that calls it is marked takes_share (tests/parts.hpp).
inline int tries(int all, int of = 10) { return in_full() || all <= of ? all : all / of; }

/// Whether number `at` of many is tried: all, or the first of each `of`. A suite that calls it is marked takes_share.
inline bool is_tried(std::size_t at, std::size_t of) { return in_full() || at % of == 0; }

/// Every how many of many alike are tried: fewer with sanitizers, which take ten times as long.
inline std::size_t one_of(std::size_t number) { return in_full() ? 1 : sanitized ? 5 * number : number; }

/// Of cases that differ in their data alone, with sanitizers one of `of`.
class Share {
 public:
  explicit Share(std::size_t of) : of_(of) {}
  bool skips() { return sanitized && !in_full() && at_++ % of_ != 0; }

 private:
  std::size_t of_, at_ = 0;
};

}  // namespace loadpath::test
