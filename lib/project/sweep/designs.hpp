// The designs of a sweep: each combination of values, with the samples of its uncertain inputs. The samples of a design
// are successive points; its row is closed with the last of them.
//
// The result is the same whatever the order of blocks and parts, and can be stored and taken up again.
#pragma once

#include "lib/project/sweep/blocks.hpp"
#include "lib/project/sweep/demands.hpp"
#include "lib/sweep/statistics/pareto.hpp"
#include "lib/sweep/statistics/summary.hpp"
#include "lib/sweep/statistics/values.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace loadpath::project {

/// The states of a project that count as passing.
inline constexpr std::array passing_states{account::State::pass, account::State::accepted, account::State::open};

/// The samples of a design by their outcome. A sample that violates a rule of its calculator counts as failing.
struct DesignTally {
  std::uint64_t samples = 0, passing = 0, failing = 0, refused = 0;  // refused ones are part of the failing ones
  std::vector<std::uint64_t> by_mode;                                // failures of each mode
  sweep::Extreme worst;                                              // largest utilisation

  void merge(const DesignTally& other);
  /// Samples that are not assessed or have no result.
  [[nodiscard]] std::uint64_t open() const { return samples - passing - failing; }
};

/// A design with all of its samples.
struct DesignRow {
  std::uint64_t design = 0;
  DesignTally tally;
  double median = 0.0, quantile = 0.0;  // of the utilisation; NaN if it has none
  std::vector<double> results;          // medians; of objectives the quantile on their unfavourable side
};

/// The number of designs by their samples.
struct DesignCounts {
  std::uint64_t all_pass = 0, some_fail = 0, all_fail = 0, not_assessed = 0, invalid = 0;

  [[nodiscard]] std::uint64_t valid() const { return all_pass + some_fail + all_fail + not_assessed; }
};

/// The number of designs, or of points, that satisfy each demand on a Pareto set, and all of them.
struct DemandCounts {
  std::vector<std::uint64_t> of_each;
  std::uint64_t all = 0;

  explicit DemandCounts(std::size_t demands = 0) : of_each(demands) {}
  void merge(const DemandCounts& other);
  void store(sweep::Writer& writer) const;
  void load(sweep::Reader& reader);
};

/// What is asked of the designs.
struct DesignsRequest {
  std::uint64_t samples = 1;  // of each design; 0: there is one only, and nothing to compare
  std::size_t results = 0, modes = 0;
  double quantile = 0.99;
  std::size_t most = 1000;                // rows that are kept
  std::vector<std::size_t> columns = {};  // objectives of a Pareto set: indices of results
  std::vector<sweep::Aim> aims = {};      // of each
  std::vector<SweptDemand> demands = {};  // on the designs of this set
};

class Designs {
 public:
  Designs() = default;
  explicit Designs(DesignsRequest asked);

  void add(const SolvedBlock& block);
  void merge(const Designs& other);

  /// Without samples, the outcomes of the points are counted elsewhere: see SweepStatistics.
  [[nodiscard]] const DesignCounts& counts() const { return counts_; }
  /// First those that always pass, by the first result; then by the share of samples that fail or are not assessed.
  [[nodiscard]] std::vector<DesignRow> rows() const;
  /// Of the quantiles of the objectives, of the designs that satisfy all demands; the index of a point is that of its
  /// design.
  [[nodiscard]] std::vector<sweep::Pareto::Point> pareto() const { return pareto_.points(); }
  [[nodiscard]] const DemandCounts& demands_met() const { return demands_met_; }
  [[nodiscard]] const DesignsRequest& asked() const { return asked_; }

  void store(sweep::Writer& writer) const;
  void load(sweep::Reader& reader);

 private:
  /// A design some samples of which are still missing.
  struct Open {
    DesignTally tally;
    sweep::Values utilisation;
    std::vector<sweep::Values> results;
    std::vector<std::uint64_t> met;  // samples that meet each demand

    void clear();
    void merge(const Open& other);
  };
  using Key = std::array<double, 4>;  // shares that fail and are not assessed, first result, number of the design

  [[nodiscard]] Open none() const;
  void add_single(const SolvedBlock& block);
  void add_part(const SolvedBlock& block, std::uint64_t design, std::size_t first, std::size_t n);
  void take(const SolvedBlock& block, std::size_t first, std::size_t n, Open& open) const;
  void close(std::uint64_t design, const Open& open);
  bool satisfies_demands(const Open& open);
  void add_to_front(const DesignRow& row);
  void count(const DesignTally& tally);
  void keep(const Key& key, DesignRow row);
  [[nodiscard]] Key key_of(std::uint64_t design, const DesignTally& tally, double first) const;
  [[nodiscard]] bool is_among_the_first(const Key& key) const;
  /// The quantile of a result in the row of a design.
  [[nodiscard]] double level_of(std::size_t result) const;

  DesignsRequest asked_;
  DesignCounts counts_;
  std::map<Key, DesignRow> rows_;
  std::map<std::uint64_t, Open> open_;  // by number
  sweep::Pareto pareto_;
  DemandCounts demands_met_;
  Open scratch_;
  std::vector<Key> candidates_;
};

}  // namespace loadpath::project
