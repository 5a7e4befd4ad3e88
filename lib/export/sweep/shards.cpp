// Folders of shards become one.
#include "lib/export/sweep/folder.hpp"
#include "lib/export/sweep/store.hpp"

#include <algorithm>
#include <map>

namespace loadpath::exports {

namespace fs = std::filesystem;

Outcome<SweepStore> SweepStore::open_shard(const fs::path& folder, SweepStore shard) {
  std::error_code error;
  if (!fs::exists(folder / state_name, error)) return refused(folder, say("no sweep in this folder"));
  auto lock = FolderLock::to_read(folder);
  if (!lock) return lock.fault();
  shard.lock_ = std::move(*lock);
  Message wrong;
  const std::string bytes = shard.read_state(wrong);
  if (wrong.empty()) wrong = shard.load(bytes);
  if (!wrong.empty()) return refused(folder, std::move(wrong));
  return shard;
}

/// Among shards in their order, those that cover the blocks, each block once; else the message names the missing
/// blocks. A shard may begin wherever another ends, so that shards of different sizes fit, and overlap does no harm.
std::vector<const SweepStore*> SweepStore::chain_of(const std::vector<SweepStore>& shards, BlockRange blocks,
                                                    std::uint64_t points, Fault& missing) {
  std::map<std::uint64_t, const SweepStore*> ending{{blocks.first, nullptr}};  // by the block behind
  for (const SweepStore& shard : shards) {
    const BlockRange own = shard.sweep_.blocks;
    if (shard.left().count() == 0 && own.count() != 0 && ending.contains(own.first)) ending.emplace(own.last, &shard);
  }
  std::vector<const SweepStore*> chain;
  const auto last = std::prev(ending.end());
  if (last->first == blocks.last) {
    for (const SweepStore* shard = last->second; shard != nullptr; shard = ending.at(shard->sweep_.blocks.first))
      chain.insert(chain.begin(), shard);
    return chain;
  }
  std::uint64_t next = blocks.last;  // end of the missing blocks
  for (const SweepStore& shard : shards) {
    const BlockRange own = shard.sweep_.blocks;
    if (own.first > last->first) next = std::min(next, own.first);
    if (own.first != last->first || shard.left().count() == 0) continue;
    const std::uint64_t left = shard.points_until(own.last) - shard.points_until(shard.next_);
    missing = refused(shard.folder_, say("it is not finished: {1} points are left", std::to_string(left)),
                      say("continue it: --resume"));
    return {};
  }
  const std::string gap = points_of({last->first, next}, points);
  missing = {0, 1, say("the points {1} are in no shard that fits the others", gap),
             say("solve them: --shard {1}", gap)};
  return {};
}

Outcome<SweepStore> SweepStore::merge(const std::vector<fs::path>& shards, const fs::path& folder,
                                      const SweepPlan& plan, StoredSweep sweep, const SweepStatistics& none) {
  std::vector<SweepStore> all;
  std::vector<fs::path> left_out;
  for (const fs::path& path : shards) {
    if (is_unbegun(path)) {
      left_out.push_back(path);
      continue;
    }
    auto shard = open_shard(path, SweepStore(path, plan, sweep, none));
    if (!shard) return shard.fault();
    all.push_back(std::move(*shard));
  }
  std::stable_sort(all.begin(), all.end(), [](const SweepStore& a, const SweepStore& b) {
    return a.sweep_.blocks.first < b.sweep_.blocks.first;
  });
  Fault missing;  // nothing is created then
  const std::vector<const SweepStore*> chain = chain_of(all, sweep.blocks, plan.space.count(), missing);
  if (!missing.message.empty()) return missing;
  auto merged = create(folder, plan, sweep, none);
  if (!merged) return merged;
  Message wrong;
  for (const SweepStore* shard : chain) {
    if (wrong.empty()) wrong = merged->append_shard(*shard);
  }
  if (wrong.empty()) wrong = merged->save();
  if (wrong.empty()) {
    for (const SweepStore& shard : all) {
      const bool taken = std::find(chain.begin(), chain.end(), &shard) != chain.end();
      if (!taken && shard.sweep_.blocks.count() != 0) left_out.push_back(shard.folder_);
    }
    merged->left_out_ = std::move(left_out);
    return merged;
  }
  std::error_code error;  // create() has made all of it
  fs::remove_all(folder, error);
  return Fault{0, 1, std::move(wrong), {}};
}

Message SweepStore::append_shard(const SweepStore& shard) {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const fs::path path = shard.folder_ / columns_[k].file;
    std::uint64_t rows = 0, check = 0;
    Message wrong;
    const Message unread = sweep::read_npy(path, [&](std::span<const double> values) {
      rows += values.size();
      check = checked(check, values);
      wrong = append(k, values);
      return wrong.empty();
    });
    if (!unread.empty()) return unread;
    if (!wrong.empty()) return wrong;
    if (rows != shard.found_.points() || check != shard.columns_[k].check) return not_what_was_written(path);
  }
  if (!found_.merge(shard.found_)) return say("'{1}': its points are in another shard too", shard.folder_.string());
  next_ = shard.next_;
  return {};
}

}  // namespace loadpath::exports
