#include "lib/sweep/statistics/worst.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::sweep {

namespace {

bool is_worse(const Worst::Row& a, const Worst::Row& b) {
  return a.key > b.key || (a.key == b.key && a.index < b.index);
}

}  // namespace

void Worst::insert(Row row) {
  rows_.push_back(std::move(row));
  std::push_heap(rows_.begin(), rows_.end(), is_worse);
  if (rows_.size() <= most_) return;
  std::pop_heap(rows_.begin(), rows_.end(), is_worse);
  rows_.pop_back();
}

void Worst::merge(const Worst& other) {
  for (const Row& row : other.rows_) {
    if (enters(row.key, row.index)) insert(row);
  }
}

std::vector<Worst::Row> Worst::rows() const {
  auto sorted = rows_;
  std::sort(sorted.begin(), sorted.end(), is_worse);
  return sorted;
}

void Worst::store(Writer& writer) const {
  writer.put(std::uint64_t{most_});
  writer.put(std::uint64_t{rows_.size()});
  for (const Row& row : rows()) {
    writer.put(row.key);
    writer.put(row.index);
    writer.put(std::uint64_t{row.values.size()});
    for (const double value : row.values) writer.put(value);
  }
}

void Worst::load(Reader& reader) {
  most_ = reader.number();
  rows_.clear();
  for (std::uint64_t left = reader.count(3); left > 0 && !reader.failed(); --left) {
    Row row{reader.real(), reader.number(), {}};
    row.values.resize(reader.count(1));
    for (double& value : row.values) value = reader.real();
    insert(std::move(row));
  }
}

}  // namespace loadpath::sweep
