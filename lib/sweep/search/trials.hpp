// Points of a search, assessed many at once and counted.
#pragma once

#include "lib/sweep/column_block.hpp"
#include "lib/sweep/search/problem.hpp"

namespace loadpath::sweep {

struct Trial {
  Places at;
  PointRank standing;
};

class Trials {
 public:
  Trials(const Problem& searched, std::uint64_t most);

  /// Fills in the standings.
  void judge(std::span<Trial> trials);
  [[nodiscard]] Trial judged(Places at);
  /// The outputs of each point, one after the other.
  [[nodiscard]] std::vector<double> outputs(std::span<const Places> points);

  [[nodiscard]] const Problem& problem() const { return searched; }
  [[nodiscard]] std::uint64_t count() const { return evaluated; }
  [[nodiscard]] std::uint64_t left() const { return evaluated < budget ? budget - evaluated : 0; }
  void add(std::uint64_t elsewhere) { evaluated += elsewhere; }

 private:
  static constexpr std::size_t block = 256;

  template <class PlacesOf, class Take>
  void run(std::size_t n, const PlacesOf& places_of, const Take& take);

  const Problem& searched;
  std::uint64_t budget, evaluated = 0;
  Columns in, out;
  std::vector<double> row;
};

}  // namespace loadpath::sweep
