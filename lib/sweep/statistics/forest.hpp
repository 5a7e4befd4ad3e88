// Sums of blocks that are the same to the bit for any grouping and order of the blocks.
//
// Sums of doubles depend on the order. Here it is fixed by the numbers of the blocks: blocks 2k and 2k + 1 are merged
// to one of the next level, and so on, as far as both are there. The remaining parts are in the order of their
// blocks, at most two per level for consecutive blocks, and are merged from the left when the total is requested.
#pragma once

#include "lib/sweep/statistics/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

namespace loadpath::sweep {

/// `Part` has merge(const Part& right), store(Writer&) and load(Reader&).
template <class Part>
class Forest {
 public:
  /// False, and nothing is done, if the block is there already.
  bool add(std::uint64_t block, Part part) {
    if (overlaps(block, 0)) return false;
    insert(block, {0, std::move(part)});
    return true;
  }

  /// False, and nothing is done, if both contain a block.
  bool merge(const Forest& other) {
    for (const auto& [first, tree] : other.trees_) {
      if (overlaps(first, tree.level)) return false;
    }
    for (const auto& [first, tree] : other.trees_) insert(first, tree);
    return true;
  }

  [[nodiscard]] Part total() const {
    Part all{};
    bool begun = false;
    for (const auto& [first, tree] : trees_) {
      if (begun)
        all.merge(tree.part);
      else
        all = tree.part;
      begun = true;
    }
    return all;
  }

  [[nodiscard]] std::uint64_t blocks() const {
    std::uint64_t sum = 0;
    for (const auto& [first, tree] : trees_) sum += std::uint64_t{1} << tree.level;
    return sum;
  }
  /// The number of parts kept.
  [[nodiscard]] std::size_t parts() const { return trees_.size(); }

  void store(Writer& writer) const {
    writer.put(std::uint64_t{trees_.size()});
    for (const auto& [first, tree] : trees_) {
      writer.put(first);
      writer.put(tree.level);
      tree.part.store(writer);
    }
  }
  void load(Reader& reader) {
    trees_.clear();
    for (std::uint64_t left = reader.count(2); left > 0 && !reader.failed(); --left) {
      const std::uint64_t first = reader.number(), level = reader.number();
      Tree tree{level, {}};
      tree.part.load(reader);
      const bool whole = level < 63 && (first & ((std::uint64_t{1} << level) - 1)) == 0;
      if (!whole || overlaps(first, level))
        reader.fail();
      else
        insert(first, std::move(tree));
    }
  }

 private:
  struct Tree {
    std::uint64_t level;  // it holds 2^level blocks
    Part part;
  };

  [[nodiscard]] bool overlaps(std::uint64_t first, std::uint64_t level) const {
    const auto after = trees_.lower_bound(first);
    if (after != trees_.end() && (after->first - first) >> level == 0) return true;
    return after != trees_.begin() && (first - std::prev(after)->first) >> std::prev(after)->second.level == 0;
  }

  void insert(std::uint64_t first, Tree tree) {
    while (tree.level < 63) {
      const std::uint64_t size = std::uint64_t{1} << tree.level;
      const auto sibling = trees_.find(first ^ size);
      if (sibling == trees_.end() || sibling->second.level != tree.level) break;
      if (sibling->first < first) {
        first = sibling->first;
        std::swap(tree.part, sibling->second.part);
      }
      tree.part.merge(sibling->second.part);
      ++tree.level;
      trees_.erase(sibling);
    }
    trees_.emplace(first, std::move(tree));
  }

  std::map<std::uint64_t, Tree> trees_;  // by their first block
};

}  // namespace loadpath::sweep
