// Columns divided into blocks, and blocks assigned to shards arbitrarily, as threads and computers do.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace loadpath::sweep::test {

inline constexpr std::size_t block_size = 64;

/// Values over some powers of two, of both signs, one in fifty of them missing.
inline std::vector<double> column(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::lognormal_distribution<double> size(1.0, 1.2);
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t kind = random() % 50;
    const double x = kind % 5 == 1 ? -size(random) : size(random);
    values.push_back(kind == 0 ? std::numeric_limits<double>::quiet_NaN() : x);
  }
  return values;
}

template <class Reduction>
std::string bytes_of(const Reduction& reduction) {
  Writer writer;
  reduction.store(writer);
  return writer.bytes();
}

/// The result if `blocks` blocks go to shards, by `feed(shard, block)`, and shards are merged in some order.
template <class Reduction, class Feed, class Merge>
Reduction sharded(const Reduction& empty, std::size_t blocks, unsigned seed, const Feed& feed, const Merge& merge) {
  std::mt19937 random(seed);
  std::vector<Reduction> shards(1 + random() % 9, empty);
  std::size_t owner = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (random() % 7 == 0) owner = random() % shards.size();  // runs of blocks, as ranks request them
    feed(shards[owner], block);
  }
  std::shuffle(shards.begin(), shards.end(), random);
  while (shards.size() > 1) {
    const std::size_t into = random() % (shards.size() - 1);
    merge(shards[into], shards.back());
    shards.pop_back();
  }
  return shards.front();
}

}  // namespace loadpath::sweep::test
