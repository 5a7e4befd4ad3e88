// A search through designs that are too many to go through, or continuous.
#pragma once

#include "lib/sweep/search/trials.hpp"

#include <map>

namespace loadpath::sweep {

/// From the best of points spread over all ranges it moves from neighbour to neighbour in the stock while one is
/// better, at each with the continuous variables at their best. If the stock has few combinations, all are tried.
class MixedSearch {
 public:
  explicit MixedSearch(Trials& at_work);

  /// The best that is found from so many starts.
  [[nodiscard]] Trial run(std::size_t starts);
  /// The best that is found from there.
  [[nodiscard]] Trial climb(Trial from);
  /// The continuous variables of this point at their best.
  [[nodiscard]] Trial settled(const Trial& from);

  [[nodiscard]] bool saw_every_combination() const { return every; }

 private:
  [[nodiscard]] std::vector<Trial> scan(std::uint64_t count, const Places* fixed);
  [[nodiscard]] std::vector<Trial> apart(const std::vector<Trial>& points, std::size_t most) const;
  void spread_out(const Places& stock, Trial& best);
  void each_combination(std::uint64_t count, Trial& best);
  [[nodiscard]] bool widen(Trial& best);
  [[nodiscard]] Trial from_scan(std::size_t starts);
  [[nodiscard]] bool step(Trial& current);
  [[nodiscard]] bool step_to(Trial& current, std::vector<Trial> around);
  void remember(const Trial& trial);
  [[nodiscard]] std::vector<double> stock_of(const Places& at) const;

  Trials& trials;
  std::size_t continuous = 0;
  bool every = false;
  double scale = 1.0;
  std::map<std::vector<double>, Trial> solved;  // by the places of the discrete variables
};

}  // namespace loadpath::sweep
