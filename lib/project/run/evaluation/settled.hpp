// Records whose sizes have settled: a search comes back to the same part, to compare it with its neighbours and to
// report it, and an evaluation of a part of many sections takes milliseconds.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/project/run/evaluation/providers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// The values of a record, and the rows that some of them are from.
struct RecordState {
  std::vector<std::uint64_t> numbers;  // bits of values, addresses of series
  std::string words;
  friend bool operator==(const RecordState&, const RecordState&) = default;
};
RecordState state_of(const Record& record, const std::vector<Provided>& provided);

class SettledRecords {
 public:
  struct Found {
    double size = 0.0;
    bool is_newest = false;  // the record that settled last
  };

  void add(RecordState state, double from, double size);
  /// A record that settled from `from`, or at it; nothing if it is none of the last ones.
  [[nodiscard]] std::optional<Found> find(const RecordState& state, double from) const;

 private:
  struct Settled {
    RecordState state;
    double from = 0.0, size = 0.0;
  };
  std::array<std::optional<Settled>, 2> last_;  // a part and its neighbour
  std::size_t next_ = 0;
};

}  // namespace loadpath::project
