// The best design within a project: inputs to choose, objective, constraints, and the reason why no neighbouring
// design is better.
#pragma once

#include "lib/project/sweep/blocks.hpp"
#include "lib/project/sweep/demands.hpp"
#include "lib/sweep/search/goal_seek.hpp"
#include "lib/sweep/search/minimise.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// The request as the user writes it.
struct BestRequest {
  Placed objective;  // "rod.mass", or "m = rod.mass"
  bool maximise = false;
  std::vector<Placed> such_that;        // "every mode passes", "rod passes", "rod.mass <= 5 kg"; none: the first
  std::optional<double> quantile = {};  // probability of objective and constraints over the uncertain inputs
  NamedResults results = {};
};

struct Best {
  std::vector<SweptInput> inputs;
  std::vector<std::size_t> chosen;  // variables of the search; the others stay at their middle
  std::vector<double> point;        // values of all inputs
  std::string objective;            // its name
  std::string unit;                 // unit of the objective
  std::vector<Demand> demands;
  sweep::Optimum optimum;        // over the chosen ones; its outputs are the objective, then the demands
  std::vector<Message> reasons;  // per neighbour, why the violated constraint has no value, or the mode that fails
  Message fails;                 // the failure mode that the best design fails, where no constraint is about it
  Message reason;                // the same of the nearest design, if none satisfies the constraints
  std::optional<double> quantile = {};  // the requested one
  std::uint64_t samples = 0;            // of each design; 0: no input scatters
};

/// Samples of a design that all pass, with which it passes with this probability: with 95 % confidence.
double samples_needed(double quantile);
/// The probability that so many passing samples show, with 95 % confidence.
double shown_by(std::uint64_t samples);

/// Inputs with values, words and stocks are chosen from these, { from, to } from the interval; uncertain inputs
/// stay at their mean, or scatter if a quantile is requested: the samples of a design are those of a sweep with the
/// same settings. Issues if the request cannot be read.
std::optional<Best> find_best(const Searching& searching, const BestRequest& asked, const SweepSettings& settings,
                              std::vector<Issue>& issues);

struct SoughtValue {
  SweptInput input;
  std::string unit;  // unit of the result
  double target = 0.0;
  sweep::SeekResult sought;
};
/// "rod.u = 0.9" over the one input that goes through a range; the others stay at their middle.
std::optional<SoughtValue> seek_value(const Searching& searching, const Placed& goal, std::vector<Issue>& issues);

}  // namespace loadpath::project
