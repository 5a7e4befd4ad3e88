// Records whose sizes have settled: a search comes back to the same part, to compare it with its neighbours, to find
// the nearest one and to report it, and an evaluation of a part of many sections takes milliseconds.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/project/run/evaluation/providers.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace loadpath::project {

/// The values of a record, and the rows that some of them are from.
struct RecordState {
  std::vector<std::uint64_t> numbers;  // bits of values, of series a checksum
  std::string words;
  friend bool operator==(const RecordState&, const RecordState&) = default;
};
RecordState state_of(const Record& record, const std::vector<Provided>& provided);

/// How a record settles that begins with the values of rows that it has.
struct Settled {
  double size = 0.0;   // at which the values of rows are looked up in the end
  Record result = {};  // of a step without positions
};

class SettledRecords {
 public:
  /// Both the record as it began and the record as it settled: from there it settles the same way.
  void add(RecordState began, RecordState settled, const Settled& found);
  /// Null if it is not known.
  [[nodiscard]] const Settled* find(const RecordState& state) const;

 private:
  static constexpr std::size_t most = 512;  // then all are dropped
  struct Hash {
    std::size_t operator()(const RecordState& state) const;
  };
  std::unordered_map<RecordState, Settled, Hash> known_;
};

}  // namespace loadpath::project
