// The steps of a body that contradict one another: they are solved together at each point, as in a single design,
// between steps that go by columns.
#pragma once

#include "lib/project/sweep/points/single_step.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace loadpath::project {

/// Holds the place of a step that is solved with a later one.
class EarlierStep final : public PointStep {
 public:
  void evaluate(PointColumns&, std::vector<account::ModeColumns>&) override {}
};

/// All of them, in the place of the last.
class SingleBody final : public PointStep {
 public:
  using Modes = std::vector<account::ModeColumns>;
  struct Member {
    std::unique_ptr<SingleStep> step;
    std::function<Modes&()> modes;  // those of an earlier step; null for the last one
  };
  enum class Handed { settled, again, contradicts };
  /// `hand_out`: after they are solved, whether they have to be solved again, since the body requires something else.
  SingleBody(std::vector<Member> members, std::function<Handed()> hand_out);

  void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) override;
  [[nodiscard]] bool reads_axes() const override;

 private:
  bool solve(PointColumns& points, std::size_t point);

  std::vector<Member> members_;
  std::function<Handed()> hand_out_;
};

}  // namespace loadpath::project
