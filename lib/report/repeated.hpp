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
  /// The lines of a step as blocks. Lines that an earlier step of the calculator has printed follow as numbers, under
  /// a reference to that step.
  std::vector<Block> blocks(const std::string& calculator, const std::string& title,
                            const std::vector<account::Derived>& lines);

 private:
  struct First {
    std::string title;
    std::set<std::string> formulas;
  };
  std::map<std::string, First> first_;
};

}  // namespace loadpath::report
