#include "lib/quantity/expression/resolved.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace loadpath {

namespace {

constexpr std::size_t first_pieces = 64, most_pieces = 200'000;
constexpr double least_piece = 1e-12;  // relative to the full range
constexpr double nothing = 1e-250;

struct Piece {
  double from, to, at_from, at_to;
  double beyond;  // deviation of the law beyond the values at both ends
  bool operator<(const Piece& other) const { return beyond < other.beyond; }
};

class Resolving {
 public:
  Resolving(const Law& law, double tolerance, Followed what) : law_(law), tolerance_(tolerance), what_(what) {}

  Resolved run(double from, double to) {
    const double least = least_piece * (to - from);
    double last = from, at_last = value(from);
    for (std::size_t i = 1; i <= first_pieces; ++i) {
      const double next = i == first_pieces ? to : from + (to - from) * static_cast<double>(i) / first_pieces;
      const double at_next = value(next);
      add(last, next, at_last, at_next);
      last = next, at_last = at_next;
    }
    while (!open_.empty() && !is_near(open_.top())) {
      const Piece piece = open_.top();
      open_.pop();
      if (piece.to - piece.from <= least || open_.size() + done_.size() >= most_pieces) {
        resolved_.complete = false;
        done_.push_back(piece);
        if (open_.size() + done_.size() >= most_pieces) break;
        continue;
      }
      const double middle = 0.5 * (piece.from + piece.to), at_middle = value(middle);
      add(piece.from, middle, piece.at_from, at_middle);
      add(middle, piece.to, at_middle, piece.at_to);
    }
    collect();
    return std::move(resolved_);
  }

 private:
  double value(double place) {
    const numerics::Jet jet = law_.at(place);
    const double y = what_ == Followed::value ? jet.value : jet.second;
    if (std::isfinite(y)) most_ = std::max(most_, std::abs(y));
    return y;
  }
  [[nodiscard]] bool is_near(const Piece& piece) const {
    return piece.beyond <= tolerance_ * most_ || piece.beyond <= nothing;
  }

  void add(double from, double to, double at_from, double at_to) {
    const IntervalJet all = law_.over({from, to});
    const Interval& bounds = what_ == Followed::value ? all.value : all.second;
    const double beyond = std::max(bounds.high - std::max(at_from, at_to), std::min(at_from, at_to) - bounds.low);
    const bool known = std::isfinite(beyond) && std::isfinite(at_from) && std::isfinite(at_to);
    open_.push({from, to, at_from, at_to, known ? beyond : std::numeric_limits<double>::infinity()});
  }

  void collect() {
    for (; !open_.empty(); open_.pop()) done_.push_back(open_.top());
    std::sort(done_.begin(), done_.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
    resolved_.corners.reserve(done_.size() + 1);
    for (const Piece& piece : done_) {
      if (resolved_.corners.empty()) resolved_.corners.emplace_back(piece.from, piece.at_from);
      resolved_.corners.emplace_back(piece.to, piece.at_to);
    }
  }

  const Law& law_;
  double tolerance_;
  Followed what_;
  double most_ = 0.0;  // largest value so far
  std::priority_queue<Piece> open_;
  std::vector<Piece> done_;
  Resolved resolved_;
};

}  // namespace

Resolved resolve(const Law& law, double from, double to, double tolerance, Followed what) {
  return Resolving(law, tolerance, what).run(from, to);
}

}  // namespace loadpath
