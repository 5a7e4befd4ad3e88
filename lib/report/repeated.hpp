// Formula sets that several steps share: printed once.
#pragma once

#include "lib/account/account.hpp"
#include "lib/report/document.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace loadpath::report {

/// Remembers the formulas that the steps of a calculator have printed.
class PrintedFormulas {
 public:
  /// The lines of a step as blocks. Lines that earlier steps of the calculator have printed are numbers only, under a
  /// reference to the step that has printed their formulas.
  std::vector<Block> blocks(const std::string& calculator, const std::string& title,
                            const std::vector<account::Derived>& lines);

 private:
  struct Printed {  // each formula is of the step that printed it first
    std::string title;
    std::set<std::string> formulas;
  };
  std::map<std::string, std::vector<Printed>> printed_;  // by calculator
};

}  // namespace loadpath::report
