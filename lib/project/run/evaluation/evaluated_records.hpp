// Records that were evaluated: a search comes back to the same part, to compare it with its neighbours, to find the
// nearest one and to report it, and an evaluation of a part of many sections takes milliseconds.
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

class EvaluatedRecords {
 public:
  void add(RecordState state, Record result);
  /// The result; null if it is not known.
  [[nodiscard]] const Record* find(const RecordState& state) const;

 private:
  static constexpr std::size_t most = 512;  // then all are dropped
  struct Hash {
    std::size_t operator()(const RecordState& state) const;
  };
  std::unordered_map<RecordState, Record, Hash> known_;
};

}  // namespace loadpath::project
