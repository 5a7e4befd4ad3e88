// What a design must satisfy, as the user writes it: "every mode passes", "rod passes", "rod.mass <= 5 kg".
#pragma once

#include "lib/project/read/sweep_settings.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/sweep/search/problem.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

struct Demand {
  std::string text;    // as requested
  std::string column;  // of a comparison: empty until it is formed
  sweep::Constraint::Kind kind;
  double bound = 1.0;
  std::string less = {}, more = {};  // both sides of a comparison
};

/// Results by their names: "mass", "rod.A*rod.l*rho".
using NamedResults = std::vector<std::pair<std::string, std::string>>;

/// An error in an option.
Issue refusal(const Placed& at, Message message, Message hint = {});

/// The expression behind a name of a result; other texts unchanged.
std::string meant(const std::string& text, const NamedResults& results);

/// Whether a text names the utilisation of the project, a part or a failure mode, which no expression contains.
bool is_utilisation(const std::string& text);

/// The constraints of a design. A verdict is a flag; its utilisation, before it, guides a search, if there is one: a
/// mechanism by itself has none.
std::vector<Demand> demands_of(const std::vector<Placed>& such_that, const NamedResults& results,
                               std::vector<Issue>& issues);

/// The column of a demand: of a comparison a number that is at most 1 where it holds, whatever the signs of its sides
/// are. Issues if it cannot be read, or if its sides have different dimensions.
void form(Demand& demand, const Place& place, Project& project, std::vector<Issue>& issues);

/// A demand on a column of a sweep over all points. With scatter a design satisfies it if the share `quantile` of its
/// samples does: of a verdict by their number, of a bound by the quantile, as for `find_best`.
struct SweptDemand {
  std::string text;
  std::size_t column = 0;
  sweep::Constraint::Kind kind = sweep::Constraint::Kind::at_most_one;
  double bound = 1.0;

  [[nodiscard]] bool is_met(double value) const;
  /// `met`: the number of samples that meet it; `level`: the quantile of those that have a value.
  [[nodiscard]] bool is_met(std::uint64_t met, std::uint64_t valued, std::uint64_t samples, double level,
                            double quantile) const;
};

}  // namespace loadpath::project
