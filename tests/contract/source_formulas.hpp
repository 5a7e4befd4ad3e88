// The formulas as written in the sources of the calculators.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// The content of a STEP, STEP_TO or NAMED_STEP.
struct SourceFormula {
  std::string place;   // "calculators/gear/pair_mesh.cpp:13"
  std::string folder;  // "gear"
  std::string symbol;  // empty: the caller of a NAMED_STEP knows it
  std::string text;    // printed form
};

/// Those of the folders that `is_read("gear")` takes, in the order of files and lines.
std::vector<SourceFormula> source_formulas(const std::function<bool(std::string_view)>& is_read);

}  // namespace loadpath::test
