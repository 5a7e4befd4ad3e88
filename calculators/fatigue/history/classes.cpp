#include "calculators/fatigue/history/classes.hpp"

#include "calculators/fatigue/history/cycles.hpp"
#include "lib/rainflow/spectrum.hpp"

#include <algorithm>

namespace loadpath::fatigue {

namespace {

using rainflow::Classes;

/// Hands on the cycles that the gate keeps, and every turning point.
class AboveGate : public rainflow::Consumer {
 public:
  AboveGate(double gate, rainflow::Consumers& consumers) : gate_(gate), consumers_(&consumers) {}

  void take(const rainflow::Batch& batch) override {
    kept_.clear();
    for (const rainflow::Loop& loop : batch.loops) {
      if (loop.range() >= gate_) kept_.push_back(loop);
    }
    consumers_->take({kept_, batch.count, {}});
  }
  void pass(std::span<const double> turning_points) override { consumers_->pass(turning_points); }

 private:
  double gate_;
  rainflow::Consumers* consumers_;
  std::vector<rainflow::Loop> kept_;
};

Stress middle(const Classes& classes, std::size_t i) {
  return from_si<Stress>((classes.bound(i) + classes.bound(i + 1)) / 2.0);
}

void put_matrix(const HistoryTypes::Input& in, const rainflow::RainflowMatrix& matrix, HistoryTypes::Result& r) {
  const Classes& classes = matrix.classes();
  for (std::size_t from = 0; from < classes.count(); ++from) {
    for (std::size_t to = 0; to < classes.count(); ++to) {
      if (matrix.count(from, to) > 0.0)
        r.matrix.push_back({in.K_A * middle(classes, from), in.K_A * middle(classes, to), matrix.count(from, to)});
    }
  }
}

void put_pairs(const HistoryTypes::Input& in, const rainflow::RangePairs& pairs, HistoryTypes::Result& r) {
  const auto at_least = pairs.exceedances();
  for (std::size_t i = pairs.classes().count(); i-- > 0;) {
    r.range_pairs.push_back({in.K_A * from_si<Stress>(pairs.classes().bound(i)),
                             in.K_A * from_si<Stress>(pairs.classes().bound(i + 1)), pairs.counts()[i], at_least[i]});
  }
}

void put_crossings(const HistoryTypes::Input& in, const rainflow::LevelCrossings& levels, HistoryTypes::Result& r) {
  const auto crossings = levels.crossings();
  for (auto it = crossings.rbegin(); it != crossings.rend(); ++it) {
    r.crossings.push_back(
        {in.K_A * from_si<Stress>(it->level), static_cast<double>(it->up), static_cast<double>(it->down)});
  }
}

}  // namespace

void classify(const HistoryTypes::Input& in, HistoryTypes::Result& r) {
  if (in.classes == 0 || !in.sigma.is_series()) return;
  const auto [least, largest] = std::minmax_element(in.sigma.series->si.begin(), in.sigma.series->si.end());
  const auto count = static_cast<std::size_t>(in.classes);
  const double width = (*largest - *least) / static_cast<double>(count);
  // A hair wider than the history, so that its extremes lie in a class whatever the bounds are rounded to.
  const auto classes = Classes::make(*least - 1e-12 * width, width * (1.0 + 1e-11), count);
  const auto ranges = Classes::make(0.0, width * (1.0 + 1e-11), count);
  if (!classes || !ranges) return;
  rainflow::RainflowMatrix matrix(*classes);
  rainflow::RangePairs pairs(*ranges);
  std::vector<double> levels;
  for (std::size_t i = 1; i < count; ++i) levels.push_back(classes->bound(i));
  rainflow::LevelCrossings crossings(std::move(levels));
  rainflow::Consumers all({&matrix, &pairs, &crossings});
  AboveGate kept(in_si(in.gate), all);
  count_into(in, kept, false);
  put_matrix(in, matrix, r), put_pairs(in, pairs, r), put_crossings(in, crossings, r);
}

std::vector<figure::Figure> class_figures(const HistoryTypes::Result& r) {
  if (r.range_pairs.empty()) return {};
  figure::Plot pairs;
  pairs.x = {"n", "cycles that are at least so large", "-", true};
  pairs.y = {"range", "range", "MPa"};
  figure::Curve steps{"range pairs", {}, {}};
  for (const auto& pair : r.range_pairs) {
    if (!(pair.n_least > 0.0)) continue;
    steps.x.insert(steps.x.end(), {pair.n_least, pair.n_least});
    steps.y.insert(steps.y.end(), {in_si(pair.to), in_si(pair.from)});
  }
  pairs.curves.push_back(std::move(steps));
  figure::Plot levels;
  levels.x = {"n", "crossings upwards", "-", true};
  levels.y = {"sigma", "level", "MPa"};
  figure::Curve ups{"level crossings", {}, {}};
  for (const auto& crossing : r.crossings) {
    if (crossing.up > 0.0) ups.x.push_back(crossing.up), ups.y.push_back(in_si(crossing.sigma));
  }
  levels.curves.push_back(std::move(ups));
  return {{"range_pairs", "Range pairs: how many cycles have at least this range", std::move(pairs)},
          {"crossings", "How often each level is crossed upwards", std::move(levels)}};
}

}  // namespace loadpath::fatigue
