// The content of messages between ranks, as bytes. All ranks run one program on one kind of processor.
#pragma once

#include "cli/parts/parts.hpp"

#include <string>
#include <string_view>

namespace loadpath::cli {

/// The sweep that ranks are to help with.
struct Order {
  SharedSweep shared;
  bool rows = false;  // whether individual points are requested
};
std::string bytes_of(const Order& order);
Order order_from(std::string_view bytes);

/// The number of parts that a rank takes at once; or none, with the reason.
struct Handshake {
  std::uint64_t parts = 0;
  std::string name, wrong;  // "rank 3 on node7"
};
std::string bytes_of(const Handshake& handshake);
Handshake handshake_from(std::string_view bytes);

std::string bytes_of(project::BlockRange blocks);
project::BlockRange blocks_from(std::string_view bytes);

/// A part that is solved, and in which time.
struct Solved {
  project::SweptPart part;
  double seconds = 0.0;
};
std::string bytes_of(const Solved& solved);
/// `none`: an empty result of the same plan. Throws if the bytes are not such a part.
Solved solved_from(std::string_view bytes, const project::SweepStatistics& none);

}  // namespace loadpath::cli
