// The results of a solved mechanism in addition to their declarations.
#pragma once

#include "calculators/mechanism/results/declaration.hpp"
#include "lib/account/account.hpp"

#include <string_view>
#include <vector>

namespace loadpath::planar {

struct Output;

class Results {
 public:
  struct Line {
    const Output* output;
    const account::Entry* entry;

    [[nodiscard]] Kind kind() const;
    [[nodiscard]] const Facts& facts() const;
  };
  /// `entries`: of the first of these outputs, in their order.
  Results(const std::vector<Output>& outputs, const std::vector<account::Entry>& entries);

  [[nodiscard]] auto begin() const { return lines_.begin(); }
  [[nodiscard]] auto end() const { return lines_.end(); }
  /// The first of its kind, where a name is given of what has it; null where there is none.
  [[nodiscard]] const account::Entry* find(Kind kind, std::string_view name = {}) const;

 private:
  std::vector<Line> lines_;
};

}  // namespace loadpath::planar
