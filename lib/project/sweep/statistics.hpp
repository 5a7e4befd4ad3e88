// The statistics of a sweep: states of the parts, distribution of every result, notable points.
//
// It is the same to the bit however the points were shared out, and can be stored and taken up again.
#pragma once

#include "lib/account/conclusion.hpp"
#include "lib/project/sweep/designs.hpp"
#include "lib/project/sweep/plan.hpp"
#include "lib/sweep/statistics/covariances.hpp"
#include "lib/sweep/statistics/forest.hpp"
#include "lib/sweep/statistics/summary.hpp"
#include "lib/sweep/statistics/worst.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// An objective of a Pareto set: the index of a requested result.
struct Objective {
  std::size_t column = 0;
  sweep::Aim aim = sweep::Aim::min;
};

struct Keep {
  std::size_t worst = 5;                   // points with the largest utilisation
  std::vector<Objective> objectives = {};  // none: no Pareto set
  std::vector<SweptDemand> demands = {};   // on its designs
  double quantile = 0.99;                  // of the samples of a design
};

/// The frequency of each state of a mode, or of the project, and the point of maximum utilisation.
struct Tally {
  static constexpr std::size_t states = 8;  // values of account::State, and account::refused_state
  std::array<std::uint64_t, states> counts{};
  sweep::Extreme largest;

  void add(std::uint64_t first, std::span<const double> state, std::span<const double> utilisation);
  void merge(const Tally& other);
  [[nodiscard]] std::uint64_t of(account::State state) const { return counts[static_cast<std::size_t>(state)]; }
  [[nodiscard]] std::uint64_t refused_points() const {
    return counts[static_cast<std::size_t>(account::refused_state)];
  }
  /// Points that it concerns.
  [[nodiscard]] std::uint64_t total() const;
  /// The number of those that are assessed and pass, or are accepted or open.
  [[nodiscard]] std::uint64_t passing() const;
};

/// Points that were refused for one reason.
struct Refused {
  std::uint64_t count = 0, first = 0;
  std::string key, message;  // path and message of the first
};

class SweepStatistics {
 public:
  SweepStatistics() = default;
  /// For a plan with so many inputs and results, and samples of each design, 0 if there is one only; the columns behind
  /// the results are those of verdict_columns().
  SweepStatistics(std::size_t inputs, std::size_t results, std::size_t verdicts, std::uint64_t samples, Keep keep);

  void add(const SolvedBlock& block);
  /// Merges other blocks; false if both contain one.
  bool merge(const SweepStatistics& other);

  [[nodiscard]] std::uint64_t points() const { return points_; }
  [[nodiscard]] const std::vector<sweep::Summary>& results() const { return results_; }
  /// First the tally of the project, then of every mode, in the order of verdict_columns().
  [[nodiscard]] const std::vector<Tally>& tallies() const { return tallies_; }
  [[nodiscard]] const std::map<std::string, Refused>& refusals() const { return refusals_; }
  /// Rows hold inputs, then results.
  [[nodiscard]] std::vector<sweep::Worst::Row> worst() const { return worst_.rows(); }
  /// Of points; with uncertain inputs, see designs().
  [[nodiscard]] std::vector<sweep::Pareto::Point> pareto() const { return pareto_.points(); }
  [[nodiscard]] const Designs& designs() const { return designs_; }
  /// Of designs, or of points if each is a design of its own.
  [[nodiscard]] const DemandCounts& demands_met() const {
    return designs_.asked().samples > 1 ? designs_.demands_met() : demands_met_;
  }
  [[nodiscard]] DesignCounts design_counts() const;
  /// Points of designs of which every sample is refused: invalid designs.
  [[nodiscard]] std::uint64_t points_of_invalid() const;
  /// The covariances of inputs and results, in this order.
  [[nodiscard]] sweep::Covariances covariances() const { return covariances_.total(); }
  [[nodiscard]] const Keep& keep() const { return keep_; }

  void store(sweep::Writer& writer) const;
  void load(sweep::Reader& reader);

 private:
  void add_to_front(const SolvedBlock& block);

  std::uint64_t points_ = 0;
  Keep keep_;
  std::vector<sweep::Summary> results_;
  std::vector<Tally> tallies_;
  std::map<std::string, Refused> refusals_;
  sweep::Worst worst_;
  sweep::Pareto pareto_;
  DemandCounts demands_met_;
  Designs designs_;
  sweep::Forest<sweep::Covariances> covariances_;
};

/// The headline of a complete sweep that compares designs: that of its best design. A design with samples passes if the
/// share `quantile` of them passes. Nothing for a part of a sweep, and for the scatter of one design: it has no demand.
std::optional<account::Headline> headline_of(const SweepPlan& plan, const SweepStatistics& found);

}  // namespace loadpath::project
