#include "lib/rainflow/stack.hpp"

#include "lib/rainflow/methods.hpp"

#include <utility>

namespace loadpath::rainflow {

namespace {

template <bool placed>
void count_halves(const Points& points, Loops& loops) {
  for (std::size_t i = 0; i + 1 < points.values.size(); ++i) {
    const Where where = placed ? Where{points.at[i], points.at[i + 1]} : Where{};
    loops.put<placed>({points.values[i], points.values[i + 1]}, where, 0.5);
  }
}

/// A residue repeated after itself: turning points only, because its end and its start may not be such at the joint.
class Joined {
 public:
  explicit Joined(const Points& residue) : residue_(residue) {
    const std::size_t count = residue.values.size();
    for (std::size_t i = 0; i < count; ++i) put(i);
    for (std::size_t i = 0; i < count; ++i) put(i);
  }
  [[nodiscard]] Points points() const { return {values_, at_}; }

 private:
  void put(std::size_t i) {
    const double value = residue_.values[i];
    const std::size_t size = values_.size();
    if (size > 0 && value == values_[size - 1]) return;
    if (size > 1 && (value > values_[size - 1]) == (values_[size - 1] > values_[size - 2])) {
      values_.pop_back();
      if (!at_.empty()) at_.pop_back();
    }
    values_.push_back(value);
    if (!residue_.at.empty()) at_.push_back(residue_.at[i]);
  }

  Points residue_;
  std::vector<double> values_;
  std::vector<std::uint64_t> at_;
};

template <class Counting, bool placed>
class StackOf final : public Stack {
 public:
  StackOf(Counting counting, Consumer& consumer) : Stack(consumer), counting_(std::move(counting)) {}

  void push(const Points& points) override { counting_.push(points, loops_); }
  [[nodiscard]] Points residue() const override { return counting_.residue(); }
  void count_residue(Residue rule) override {
    switch (rule) {
      case Residue::ignore:
        break;
      case Residue::half_cycles:
        count_halves<placed>(residue(), loops_);
        break;
      case Residue::repeated: {
        const Joined twice(residue());
        FourPoint<placed>().push(twice.points(), loops_);
        break;
      }
      case Residue::astm: {
        Astm<placed> astm(AtStart::half);
        astm.push(residue(), loops_);
        count_halves<placed>(astm.residue(), loops_);
        break;
      }
    }
    loops_.hand_over();
  }

 private:
  Counting counting_;
};

template <bool placed>
std::unique_ptr<Stack> stack_by(const Rules& rules, bool period, Consumer& consumer) {
  const AtStart at_start = period                             ? AtStart::whole
                           : rules.residue == Residue::ignore ? AtStart::nothing
                                                              : AtStart::half;
  switch (rules.method) {
    case Method::hcm:
      return std::make_unique<StackOf<Hcm<placed>, placed>>(Hcm<placed>{}, consumer);
    case Method::astm:
      return std::make_unique<StackOf<Astm<placed>, placed>>(Astm<placed>(at_start), consumer);
    case Method::four_point:
      break;
  }
  return std::make_unique<StackOf<FourPoint<placed>, placed>>(FourPoint<placed>{}, consumer);
}

}  // namespace

std::unique_ptr<Stack> Stack::by(const Rules& rules, bool period, Consumer& consumer) {
  return rules.placed ? stack_by<true>(rules, period, consumer) : stack_by<false>(rules, period, consumer);
}

}  // namespace loadpath::rainflow
