#include "lib/rainflow/counter.hpp"

#include "lib/rainflow/stack.hpp"

#include <algorithm>

namespace loadpath::rainflow {

namespace {

// Samples that are taken at once, and turning points that are counted at once: both fit into the second cache.
constexpr std::size_t chunk = 4096, block = 8192;
constexpr std::size_t room = block + chunk + 256;

}  // namespace

Counter::Counter(const Rules& rules, Consumer& consumer, Course course)
    : rules_(rules),
      course_(course),
      consumer_(&consumer),
      turning_points_(rules.instructions),
      gate_(rules.gate),
      elimination_(room, rules.instructions),
      stack_(Stack::by(rules, course == Course::period, consumer)),
      values_(room),
      next_values_(room) {
  if (rules.placed) at_.resize(room);
}

Counter::~Counter() = default;

Points Counter::residue() const { return stack_->residue(); }

std::optional<Fault> Counter::feed(std::span<const double> samples) {
  while (!samples.empty()) {
    const auto some = samples.first(std::min(chunk, samples.size()));
    const auto count = turning_points_.feed(some, values_.data() + filled_, places());
    if (!count) return count.fault();
    fill(*count);
    samples = samples.subspan(some.size());
  }
  return std::nullopt;
}

/// Takes turning points that follow those that wait; counts the complete blocks.
void Counter::fill(std::size_t count) {
  filled_ += rules_.gate > 0.0 ? gate_.pass(values_.data() + filled_, places(), count) : count;
  if (filled_ < block) return;
  filled_ -= block;
  std::copy_n(values_.begin() + block, filled_, next_values_.begin());  // counting writes behind the block
  count_block(block);
  values_.swap(next_values_);
  if (rules_.placed) std::copy_n(at_.begin() + block, filled_, at_.begin());
}

void Counter::count_block(std::size_t count) {
  consumer_->pass({values_.data(), count});
  if (rules_.blocks && !rules_.placed) {
    count = elimination_.reduce(values_.data(), count);
    if (!elimination_.closed().empty()) consumer_->take({elimination_.closed(), 1.0, {}});
  }
  stack_->push({{values_.data(), count}, {at_.data(), rules_.placed ? count : 0}});
  stack_->hand_over();
}

void Counter::finish() {
  fill(turning_points_.finish(values_.data() + filled_, places()));
  if (rules_.gate > 0.0) filled_ += gate_.finish(values_.data() + filled_, places());
  count_block(filled_);
  filled_ = 0;
  // The residue of a period by the four-point method, out and back, closes as its largest cycle.
  stack_->count_residue(course_ == Course::once ? rules_.residue : Residue::repeated);
}

}  // namespace loadpath::rainflow
