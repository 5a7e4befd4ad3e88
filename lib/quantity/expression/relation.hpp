// A quantity as a function of several variables, written in the language of expressions with bare names for them:
// "-3 N*s^2/m^2*v*v_x". Values only, so that kinks and steps are allowed (a law has derivatives: law.hpp). The names of
// the variables are not units.
#pragma once

#include "lib/quantity/expression/law.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

class Relation {
 public:
  using Variables = std::span<const Law::Variable>;

  Relation();
  ~Relation();
  Relation(Relation&&) noexcept;
  Relation& operator=(Relation&&) noexcept;

  /// The first fault: of grammar or dimensions, a name other than the variables, a result that is not a `result`
  /// (angles and numbers are alike; nullopt: any quantity).
  static Outcome<Relation> parse(std::string_view text, Variables variables, const std::optional<Dimension>& result);

  /// The value in SI at values of the variables in SI, in their order; NaN where the function has no value.
  [[nodiscard]] double at(std::span<const double> variables) const;

 private:
  std::unique_ptr<const expression::Tree> tree_;
  std::vector<std::string> names_;
};

}  // namespace loadpath
