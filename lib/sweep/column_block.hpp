// Numbers in columns of one length, as a Function reads and writes them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::sweep {

class Columns {
 public:
  Columns(std::size_t columns, std::size_t rows) : numbers(columns * rows), starts(columns) {
    for (std::size_t i = 0; i < columns; ++i) starts[i] = numbers.data() + i * rows;
  }
  Columns(const Columns&) = delete;
  Columns& operator=(const Columns&) = delete;
  Columns(Columns&&) = default;
  Columns& operator=(Columns&&) = default;
  ~Columns() = default;

  [[nodiscard]] double* operator[](std::size_t column) const { return starts[column]; }
  [[nodiscard]] std::span<double* const> write() const { return starts; }
  [[nodiscard]] std::span<const double* const> read() const { return {starts.data(), starts.size()}; }

 private:
  std::vector<double> numbers;
  std::vector<double*> starts;
};

}  // namespace loadpath::sweep
