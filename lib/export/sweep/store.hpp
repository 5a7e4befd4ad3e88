// A sweep in a folder: its columns, its progress, and its results so far, so that an interrupted sweep can be
// resumed, and shards merged.
//
//   manifest.json   description of the contents, for people and other programs
//   columns/        one file for each input and result, doubles in SI as numpy reads them
//   state           the data for resuming a sweep; independent of the division into shards
//
// The state replaces the previous one atomically, after the columns that it describes are on the disk. One process
// writes at a time.
#pragma once

#include "lib/export/sweep/lock.hpp"
#include "lib/project/sweep/sweep.hpp"
#include "lib/sweep/output/npy.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::exports {

using project::BlockRange;
using project::SweepPlan;
using project::SweepStatistics;
using project::SweptPart;

/// A sweep that is kept, and its identification.
struct StoredSweep {
  std::string program;   // "loadpath 0.2.0"
  std::string file;      // file of the project
  std::string identity;  // everything that its numbers follow from, as text
  std::uint64_t seed = 0;
  BlockRange blocks;  // blocks of this folder
  bool columns = true;
};

/// A hash of everything that the numbers follow from.
std::string fingerprint(std::string_view identity);

class SweepStore {
 public:
  SweepStore() = default;
  /// A new folder, or one in which a sweep was killed before it had a state; a Fault if there is something else in
  /// it, another process is using it, or it cannot be written.
  static Outcome<SweepStore> create(const std::filesystem::path& folder, const SweepPlan& plan, StoredSweep sweep,
                                    SweepStatistics none);
  /// Opens an existing folder of the same sweep: a Fault if it is another's, or damaged. Its columns are read back.
  /// Data written after its last state are truncated.
  static Outcome<SweepStore> resume(const std::filesystem::path& folder, const SweepPlan& plan,
                                    const StoredSweep& sweep, SweepStatistics none);
  /// Merges folders of shards into a new folder: they must be of the same sweep, and some of the finished ones must
  /// cover it, each point once. The others are left out.
  static Outcome<SweepStore> merge(const std::vector<std::filesystem::path>& shards,
                                   const std::filesystem::path& folder, const SweepPlan& plan, StoredSweep sweep,
                                   const SweepStatistics& none);

  /// Takes the next part. A Message where a file cannot be written.
  Message take(const SweptPart& part);
  /// Writes the results taken so far to the disk.
  Message save();

  [[nodiscard]] const SweepStatistics& found() const { return found_; }
  [[nodiscard]] BlockRange left() const { return {next_, sweep_.blocks.last}; }
  /// The shards left out of a merge: those whose points are in others, and those without any.
  [[nodiscard]] const std::vector<std::filesystem::path>& left_out() const { return left_out_; }

 private:
  struct Column {
    std::string name, unit, si_unit, file;
    std::uint64_t check = 0;  // CRC-64 of its numbers so far
    sweep::NpyColumn numbers;
  };

  SweepStore(std::filesystem::path folder, const SweepPlan& plan, StoredSweep sweep, SweepStatistics none);
  void name_columns(const SweepPlan& plan);
  Message open_columns(std::uint64_t rows);
  Message begin();
  [[nodiscard]] Message check_columns() const;
  static std::vector<const SweepStore*> chain_of(const std::vector<SweepStore>& shards, BlockRange blocks,
                                                 std::uint64_t points, Fault& missing);
  static Outcome<SweepStore> open_shard(const std::filesystem::path& folder, SweepStore shard);
  Message append(std::size_t column, std::span<const double> values);
  Message append_shard(const SweepStore& shard);
  [[nodiscard]] std::string state() const;
  [[nodiscard]] std::string read_state(Message& wrong) const;
  Message load(std::string_view bytes);
  bool load_known(sweep::Reader& reader);
  [[nodiscard]] std::string manifest() const;
  [[nodiscard]] std::uint64_t points_until(std::uint64_t block) const;
  [[nodiscard]] Message put(const std::string& name, const std::string& bytes) const;

  std::filesystem::path folder_;
  FolderLock lock_;
  std::uint64_t points_ = 0;  // points of the entire sweep
  StoredSweep sweep_;
  SweepStatistics found_;
  std::uint64_t next_ = 0;  // block
  std::vector<Column> columns_;
  std::vector<std::size_t> results_;  // results of a block that have a column, which follow those of the inputs
  std::vector<std::filesystem::path> left_out_;
};

}  // namespace loadpath::exports
