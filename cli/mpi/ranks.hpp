// The processes of one run, numbered from 0, and messages between them. Only the main thread may call. Waiting ranks
// sleep: MPI's own waiting would occupy the core of a rank that solves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace loadpath::cli {

enum class Kind : std::uint8_t {
  sweep,      // from the first rank: the project and the request; empty: there are no more
  handshake,  // to the first rank: number of parts taken at once, or the reason for none
  part,       // from the first rank: blocks; none: the sweep is finished
  solved,     // to the first rank
  failed,     // to the first rank: an exception
};

struct RankMessage {
  int from = 0;
  Kind kind = Kind::sweep;
  std::string bytes;
};

class Ranks {
 public:
  /// Starts MPI, and ends it.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int own() const { return own_; }
  [[nodiscard]] bool is_first() const { return own_ == 0; }
  /// "rank 3 on node7"
  [[nodiscard]] std::string name() const;

  void send(int to, Kind kind, const std::string& bytes) const;
  /// A message that has come.
  [[nodiscard]] std::optional<RankMessage> look() const;
  [[nodiscard]] RankMessage wait() const;
  /// Sleeps for a moment.
  static void sleep();
  /// Ends all ranks in any state.
  [[noreturn]] static void abort(int code);

 private:
  int own_ = 0, count_ = 1;
};

}  // namespace loadpath::cli
