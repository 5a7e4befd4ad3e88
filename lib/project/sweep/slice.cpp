#include "lib/project/sweep/slice.hpp"

#include "lib/sweep/point/uniform.hpp"

namespace loadpath::project {

Slice::Slice(sweep::Function& all, std::vector<double> point, std::vector<std::size_t> inputs, std::size_t outputs)
    : all_(all), inputs_(std::move(inputs)), outputs_(outputs), rest_(std::move(point)) {}

void Slice::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  std::vector<std::vector<double>> same(rest_.size()), unseen(all_.outputs() - outputs_, std::vector<double>(n));
  std::vector<const double*> columns;
  columns.reserve(rest_.size());
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    same[i].assign(n, rest_[i]);
    columns.push_back(same[i].data());
  }
  for (std::size_t k = 0; k < inputs_.size(); ++k) columns[inputs_[k]] = in[k];
  std::vector<double*> all(out.begin(), out.end());
  for (std::vector<double>& column : unseen) all.push_back(column.data());
  all_.evaluate(columns, all, n);
}

sweep::Sampler sampler_of(const std::vector<SweptInput>& inputs, const std::vector<std::size_t>& which,
                          std::uint64_t seed) {
  std::vector<sweep::Distribution> laws;
  laws.reserve(which.size());
  for (const std::size_t i : which) laws.push_back(*inputs[i].distribution);
  return [laws, seed](std::uint64_t first, std::size_t n, std::span<double* const> columns) {
    for (std::size_t k = 0; k < laws.size(); ++k) {
      const std::span<double> column(columns[k], n);
      sweep::uniform(seed, first, k, column, sweep::Purpose::search);
      laws[k].quantile(column, column);
    }
  };
}

}  // namespace loadpath::project
