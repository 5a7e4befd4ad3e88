#include "cli/mpi/scheduler.hpp"

#include <algorithm>
#include <stdexcept>

namespace loadpath::cli {

Scheduler::Scheduler(const Ranks& ranks, const project::SweepWork& work, const Listener& listener)
    : ranks_(ranks),
      work_(work),
      listener_(listener),
      none_(project::nothing_found(work.plan, work.read(), work.keep)),
      helpers_(static_cast<std::size_t>(ranks.count())),
      next_(work.blocks.first),
      taken_(work.blocks.first) {}

std::string Scheduler::run(const SharedSweep& shared) {
  const std::string order = bytes_of(Order{shared, work_.rows});
  for (int rank = 1; rank < ranks_.count(); ++rank) ranks_.send(rank, Kind::sweep, order);
  while (!is_over()) {
    const auto message = ranks_.look();
    if (message) receive(*message);
    hand_out();
    if (hand_on() || message) continue;
    report_late_ranks();
    Ranks::sleep();
  }
  for (int rank = 1; rank < ranks_.count(); ++rank) ranks_.send(rank, Kind::part, bytes_of(project::BlockRange{}));
  return wrong_;
}

void Scheduler::receive(const RankMessage& message) {
  Helper& helper = helpers_[static_cast<std::size_t>(message.from)];
  last_message_ = Clock::now();
  if (message.kind == Kind::handshake) return hear(helper, handshake_from(message.bytes));
  if (message.kind == Kind::solved) return receive_part(helper, message.bytes);
  throw std::runtime_error(helper.name + ": " + message.bytes);
}

void Scheduler::hear(Helper& helper, const Handshake& handshake) {
  helper.heard = true;
  helper.room = handshake.parts;
  helper.name = handshake.name;
  room_ += handshake.parts;
  if (handshake.wrong.empty()) return;
  if (wrong_.empty()) wrong_ = handshake.name + " " + handshake.wrong;
  stopped_ = true;
}

void Scheduler::receive_part(Helper& helper, const std::string& bytes) {
  Solved solved = solved_from(bytes, none_);
  const std::uint64_t first = solved.part.blocks.first;
  std::erase_if(helper.parts, [&](const project::BlockRange& part) { return part.first == first; });
  seconds_of_block_ = solved.seconds / static_cast<double>(solved.part.blocks.count());
  done_.emplace(first, std::move(solved.part));
}

/// Blocks that take a quarter of a second, fewer towards the end; one while it is not known how long one takes.
std::uint64_t Scheduler::size_of_part() const {
  constexpr double seconds = 0.25;
  const double most = work_.rows ? 32.0 : 1024.0;
  const double wanted = seconds_of_block_ > 0.0 ? std::clamp(seconds / seconds_of_block_, 1.0, most) : 1.0;
  const std::uint64_t share = (work_.blocks.last - next_) / (2 * std::max(room_, std::uint64_t{1}));
  return std::clamp(static_cast<std::uint64_t>(wanted), std::uint64_t{1}, std::max(share, std::uint64_t{1}));
}

bool Scheduler::can_give() const { return !stopped_ && next_ < work_.blocks.last && done_.size() < room_; }

void Scheduler::hand_out() {
  for (std::size_t rank = 1; rank < helpers_.size(); ++rank) {
    Helper& helper = helpers_[rank];
    while (can_give() && helper.parts.size() < helper.room) {
      const project::BlockRange blocks{next_, std::min(next_ + size_of_part(), work_.blocks.last)};
      ranks_.send(static_cast<int>(rank), Kind::part, bytes_of(blocks));
      helper.parts.push_back(blocks);
      next_ = blocks.last;
    }
  }
}

/// The next part, where it is done.
bool Scheduler::hand_on() {
  const auto part = done_.find(taken_);
  if (stopped_ || part == done_.end()) return false;
  taken_ = part->second.blocks.last;
  stopped_ = !listener_.take(std::move(part->second));
  done_.erase(part);
  return true;
}

bool Scheduler::is_over() const {
  const bool all_told = stopped_ || taken_ == work_.blocks.last;
  return all_told && std::all_of(helpers_.begin() + 1, helpers_.end(),
                                 [](const Helper& helper) { return helper.heard && helper.parts.empty(); });
}

/// Some are not done, and the others wait for them.
void Scheduler::report_late_ranks() {
  constexpr std::chrono::seconds patience{2};
  if (can_give() || stopped_ || Clock::now() - last_message_ < patience) return;
  std::string listed;
  int late = 0;
  constexpr int most = 3;  // ranks named in a message
  for (std::size_t rank = 1; rank < helpers_.size(); ++rank) {
    const Helper& helper = helpers_[rank];
    if (helper.heard && helper.parts.empty()) continue;
    if (++late > most) continue;
    if (late > 1) listed += ", ";
    listed += helper.heard ? helper.name + ": " + points_of(helper.parts.front())
                           : "rank " + std::to_string(rank) + ": it has not begun";
  }
  if (late > most) listed += " and " + std::to_string(late - most) + " more";
  if (late == 0 || late + 1 == ranks_.count() || listed == told_late_) return;  // all are at work
  listener_.wait_for_late(listed);
  told_late_ = listed;
}

/// "points 512 to 1023"
std::string Scheduler::points_of(const project::BlockRange& part) const {
  const std::uint64_t last = std::min(part.last * project::block_size, work_.plan.space.count()) - 1;
  return "points " + std::to_string(part.first * project::block_size) + " to " + std::to_string(last);
}

}  // namespace loadpath::cli
