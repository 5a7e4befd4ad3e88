#include "cli/parts/parts.hpp"

#include "cli/mpi/messages.hpp"
#include "cli/mpi/pool.hpp"
#include "cli/mpi/ranks.hpp"
#include "cli/mpi/scheduler.hpp"

#include <exception>

namespace loadpath::cli {

namespace {

const Ranks* ranks = nullptr;  // while the program runs
Order order;                   // order for a helping rank
bool in_sweep = false;         // the others are at work
bool greeted = false;          // the first rank knows whether this one helps

/// Sends a refusal; a rank that cannot help then waits for the end.
void greet(std::uint64_t parts, const std::string& wrong) {
  greeted = true;
  ranks->send(0, Kind::handshake, bytes_of(Handshake{wrong.empty() ? parts : 0, ranks->name(), wrong}));
  if (!wrong.empty()) static_cast<void>(ranks->wait());
}

/// Processes a message from the first rank: false if the sweep is finished.
bool take_message(const RankMessage& message, Pool& pool) {
  const project::BlockRange blocks = blocks_from(message.bytes);
  if (blocks.count() == 0) return false;
  pool.give(blocks);
  return true;
}

/// Sends solved parts to the first rank. A fault is sent too, once, and ends this rank's work.
bool send_solved(Pool& pool, bool& sent) {
  try {
    while (const auto solved = pool.take()) {
      ranks->send(0, Kind::solved, bytes_of(*solved));
      sent = true;
    }
    return true;
  } catch (const std::exception& error) {
    ranks->send(0, Kind::failed, error.what());
    return false;
  }
}

void solve_for_first(const project::SweepWork& work) {
  Pool pool(work, work.jobs);
  for (bool goes_on = true, healthy = true; goes_on;) {
    bool busy = false;
    healthy = healthy && send_solved(pool, busy);
    if (const auto message = ranks->look()) {
      goes_on = take_message(*message, pool);
      busy = true;
    }
    if (!busy) Ranks::sleep();
  }
}

}  // namespace

std::string solve_parts(const project::SweepWork& work, const SharedSweep& shared, const Listener& listener) {
  if (ranks->count() == 1) {
    project::solve(work, listener.take);
    return {};
  }
  in_sweep = true;
  std::string wrong = Scheduler(*ranks, work, listener).run(shared);
  in_sweep = false;
  return wrong;
}

int run_program(const std::function<int()>& run) {
  const Ranks all;
  ranks = &all;
  if (!all.is_first()) {
    for (RankMessage message = all.wait(); !message.bytes.empty(); message = all.wait()) {
      order = order_from(message.bytes);
      greeted = false;
      run();
      if (!greeted) greet(0, "cannot read the project");
    }
    return 0;
  }
  const int code = run();
  if (in_sweep) Ranks::abort(code);  // a fault has left them there
  for (int rank = 1; rank < all.count(); ++rank) all.send(rank, Kind::sweep, {});
  return code;
}

bool is_waited_for() { return ranks->count() == 1; }

const std::string* helped_text() { return ranks->is_first() ? nullptr : &order.shared.text; }

int help_parts(const project::SweepWork& work, const std::string& identity, const std::string& wrong) {
  const bool same = identity == order.shared.identity;
  const std::string refusal =
      !wrong.empty() || same ? wrong : "reads other files than the first rank, or is another program";
  project::SweepWork own = work;
  own.rows = order.rows;
  constexpr unsigned parts_of_a_thread = 2;  // one at work, one that waits
  greet(parts_of_a_thread * own.jobs, refusal);
  if (refusal.empty()) solve_for_first(own);
  return 0;
}

}  // namespace loadpath::cli
