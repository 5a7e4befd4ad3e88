// Columns in SI for the benchmarks of sweeps, and a calculator's sweep over them.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace loadpath::bench {

constexpr std::size_t points = 1000;

inline std::vector<double> spread(double low, double high, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(low, high);
  std::vector<double> column(points);
  for (double& x : column) x = between(random);
  return column;
}

/// The place of a leaf inside its record.
inline std::size_t offset_of(const Record& record, const std::string& path) {
  const Leaf leaf = find_leaf(record, path);
  return static_cast<std::size_t>(reinterpret_cast<const char*>(leaf.field->address(leaf.owner)) -
                                  static_cast<const char*>(record.data.get()));
}

/// A calculator's sweep over columns of its input, with a column for each result.
class Sweep {
 public:
  struct Varied {
    std::string path;
    const std::vector<double>& column;
  };
  Sweep(const Calculator& calculator, Record input, const std::vector<Varied>& varied,
        const std::vector<std::string>& results, std::vector<std::vector<double>>& columns)
      : calculator_(calculator), input_(std::move(input)) {
    for (const auto& [path, column] : varied) in_.push_back({offset_of(input_, path), column.data()});
    const Record result(*calculator.result);
    columns.assign(results.size(), std::vector<double>(points));
    for (std::size_t k = 0; k < results.size(); ++k) out_.push_back({offset_of(result, results[k]), columns[k].data()});
  }
  void operator()() const { calculator_.sweep(input_.data.get(), in_, out_, points); }

 private:
  const Calculator& calculator_;
  Record input_;
  std::vector<InputColumn> in_;
  std::vector<ResultColumn> out_;
};

template <class C>
Record record_of(const typename C::Input& input) {
  Record record(*erased<C>().input);
  *static_cast<typename C::Input*>(record.data.get()) = input;
  return record;
}

}  // namespace loadpath::bench
