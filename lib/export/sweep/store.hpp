// A sweep in a folder: its columns, how far it is, and what it has found so far, so that what was stopped or killed
// goes on, and shards become one.
//
//   manifest.json   what stands here, for people and other programs
//   columns/        one file for each input and result, doubles in SI as numpy reads them
//   state           what a sweep goes on from; the same bytes for the same points, however they were shared out
//
// The state is put in place whole, after the columns that it tells of are on the disk.
#pragma once

#include "lib/project/sweep/sweep.hpp"
#include "lib/sweep/output/npy.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace loadpath::exports {

using project::BlockRange;
using project::Found;
using project::SweepPlan;
using project::SweptPart;

/// A sweep that is kept, and by what it is known again.
struct StoredSweep {
  std::string program;   // "loadpath 0.1.0"
  std::string file;      // of the project
  std::string identity;  // everything that its numbers follow from, as text
  std::uint64_t seed = 0;
  BlockRange blocks;  // of this folder
  bool columns = true;
};

class SweepStore {
 public:
  SweepStore() = default;
  /// A new folder; a Fault where there is something in it already, or it cannot be written.
  static Outcome<SweepStore> create(const std::filesystem::path& folder, const SweepPlan& plan, StoredSweep sweep,
                                    Found none);
  /// A folder that is there, of the same sweep: a Fault where it is another's. What was written after its last state is
  /// cut off.
  static Outcome<SweepStore> resume(const std::filesystem::path& folder, const SweepPlan& plan,
                                    const StoredSweep& sweep, Found none);
  /// Folders of shards as one new folder: they must be done, of the same sweep, and make the whole.
  static Outcome<SweepStore> merge(const std::vector<std::filesystem::path>& shards,
                                   const std::filesystem::path& folder, const SweepPlan& plan, StoredSweep sweep,
                                   const Found& none);

  /// Takes the next part. A Message where a file cannot be written.
  Message take(const SweptPart& part);
  /// Puts on the disk what has been taken.
  Message save();

  [[nodiscard]] const Found& found() const { return found_; }
  [[nodiscard]] BlockRange left() const { return {next_, sweep_.blocks.last}; }

 private:
  struct Column {
    std::string name, unit, si_unit, file;
    std::uint64_t check = 0;  // CRC-64 of its numbers so far
    sweep::NpyColumn numbers;
  };

  SweepStore(std::filesystem::path folder, const SweepPlan& plan, StoredSweep sweep, Found none);
  void name_columns(const SweepPlan& plan);
  Message open_columns(std::uint64_t rows);
  Message append(std::size_t column, std::span<const double> values);
  Message append_shard(const SweepStore& shard);
  [[nodiscard]] std::string state() const;
  bool load(std::string_view bytes, bool same_blocks);
  [[nodiscard]] std::string manifest() const;
  [[nodiscard]] std::uint64_t points_until(std::uint64_t block) const;
  [[nodiscard]] Message put(const std::string& name, const std::string& bytes) const;

  std::filesystem::path folder_;
  std::uint64_t points_ = 0;  // of the whole sweep
  StoredSweep sweep_;
  Found found_;
  std::uint64_t next_ = 0;  // block
  std::vector<Column> columns_;
};

}  // namespace loadpath::exports
