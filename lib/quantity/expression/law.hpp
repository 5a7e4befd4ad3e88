// A quantity as a smooth function of one variable, written in the language of expressions with a bare name for the
// variable: "30 deg + 90 deg*sin(2*pi*t/(2 s))". Its derivatives are exact. The name of the variable is not a unit:
// with t for the time, `2 t` is not two tonnes.
#pragma once

#include "lib/numerics/jet.hpp"
#include "lib/quantity/dimension.hpp"
#include "lib/quantity/expression/interval.hpp"
#include "lib/text/issue.hpp"

#include <memory>
#include <string_view>

namespace loadpath {

namespace expression {
struct Tree;
}

class Law {
 public:
  struct Variable {
    std::string_view name;
    Dimension dimension;
  };

  Law();
  ~Law();
  Law(Law&&) noexcept;
  Law& operator=(Law&&) noexcept;

  /// The first fault: of grammar or dimensions, a name other than the variable, a result that is not a `result`
  /// (angles and numbers are alike), a function with kinks (abs, min, max).
  static Outcome<Law> parse(std::string_view text, const Variable& variable, const Dimension& result);

  /// The value in SI and its derivatives; not finite where the law is not smooth, as a root of zero.
  [[nodiscard]] numerics::Jet at(double variable) const;

  /// Intervals that hold the value and both derivatives everywhere between two places; without bounds where the law
  /// may have a pole or leave its domain.
  [[nodiscard]] IntervalJet over(const Interval& places) const;

 private:
  std::unique_ptr<const expression::Tree> tree_;
};

}  // namespace loadpath
