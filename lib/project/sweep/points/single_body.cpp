#include "lib/project/sweep/points/single_body.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::project {

namespace {

/// What other steps contradict stays: no number that varies decides about it.
void forget_sizes_and_facts(Step& step) {
  const auto contradictions = step.contradictions();
  step.forget_body();
  if (contradictions) step.set_contradictions(*contradictions);
}

}  // namespace

SingleBody::SingleBody(std::vector<Member> members, std::function<Handed()> hand_out)
    : members_(std::move(members)), hand_out_(std::move(hand_out)) {}

bool SingleBody::reads_axes() const {
  return std::ranges::any_of(members_, [](const Member& member) { return member.step->reads_axes(); });
}

bool SingleBody::solve(PointColumns& points, std::size_t point) {
  constexpr int most_rounds = 20;
  for (const Member& member : members_) forget_sizes_and_facts(member.step->step());
  for (int round = 0; round < most_rounds; ++round) {
    const bool solved =
        std::ranges::all_of(members_, [&](const Member& member) { return member.step->solve_at(points, point); });
    if (!solved) return false;
    const Handed handed = hand_out_();
    if (handed != Handed::again) return handed == Handed::settled;
  }
  return false;
}

void SingleBody::evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) {
  const auto modes_of = [&](const Member& member) -> Modes& { return member.modes ? member.modes() : modes; };
  for (const Member& member : members_) member.step->start(points, modes_of(member));
  for (std::size_t point = 0; point < points.count; ++point) {
    if (points.is_other[point] != 0) continue;
    bool is_ordinary = solve(points, point);
    for (const Member& member : members_)
      is_ordinary = is_ordinary && member.step->take(points, point, modes_of(member));
    if (!is_ordinary) points.is_other[point] = 1;
  }
}

}  // namespace loadpath::project
