#include "lib/mechanism/structure/group_class.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace loadpath::mechanism {
namespace {

/// A joint of the chain with two constraints, between two of its members.
struct Edge {
  char letter;  // R or P
  std::size_t a, b;
};

/// The equivalent chain of a group: members are numbers, 0 is everything that was there before.
class Chain {
 public:
  static constexpr std::size_t outside = 0;

  Chain(const Model& model, const Group& group) : group_(group), members_(1 + group.links.size()) {
    for (const std::size_t k : group.joints) {
      if (model.joints[k].kind != JointKind::rigid) add(model.joints[k]);
    }
    for (const std::size_t k : group.joints) {
      if (model.joints[k].kind == JointKind::rigid) add(model.joints[k]);
    }
    order_ = outer_joints();
    for (const std::size_t k : group.drivers) lock(model, model.drivers[k]);
  }

  /// The order of the group as it is: a driven member is still attached by its joint.
  [[nodiscard]] int order() const { return order_; }

  [[nodiscard]] int contour_class() const {
    int sides = 1;
    for (std::size_t member = 1; member < members_; ++member) sides = std::max(sides, joints_on(member));
    for (std::size_t e = 0; e < edges_.size(); ++e) sides = std::max(sides, shortest_loop(e));
    return sides;
  }

  /// The letters of two members and their three joints from end to end, turning pairs first; else empty.
  [[nodiscard]] std::string kind() const {
    if (edges_.size() != 3) return {};
    std::string ends;
    std::string middle;
    for (const Edge& e : edges_) (e.a == outside || e.b == outside ? ends : middle) += e.letter;
    if (middle.size() != 1) return {};
    return std::max(ends[0], ends[1]) + middle + std::min(ends[0], ends[1]);
  }

 private:
  [[nodiscard]] std::size_t member(int link) const {
    const auto found = std::find(group_.links.begin(), group_.links.end(), static_cast<std::size_t>(link));
    if (link == ground || found == group_.links.end()) return outside;
    return 1 + static_cast<std::size_t>(found - group_.links.begin());
  }

  void add(const Joint& joint) {
    const std::size_t i = member(joint.i), j = member(joint.j);
    switch (joint.kind) {
      case JointKind::revolute:
      case JointKind::rolling:
      case JointKind::rolling_on_line:
        return edges_.push_back({'R', i, j});
      case JointKind::prismatic:
        return edges_.push_back({'P', i, j});
      case JointKind::rigid:
        return merge(i, j);
      case JointKind::slot:
      case JointKind::rack:
        return add_between(i, 'R', 'P', j);
      case JointKind::gear:
      case JointKind::belt:
        return add_between(i, 'R', 'R', j);
      case JointKind::cam:  // the second joint is at the centre of curvature
        return add_between(i, joint.contact == CamContact::flat ? 'P' : 'R', 'R', j);
      case JointKind::none:
        return;
    }
  }

  /// A joint with one constraint is equivalent to a member with two joints.
  void add_between(std::size_t i, char first, char second, std::size_t j) {
    const std::size_t between = members_++;
    edges_.push_back({first, i, between});
    edges_.push_back({second, between, j});
  }

  /// The members on both sides of a driver become one; joints between only these two vanish.
  void lock(const Model& model, const Driver& driver) {
    const bool linear = driver.kind == Driver::Kind::linear;
    const Joint* joint = linear ? &model.joints[static_cast<std::size_t>(driver.joint)] : nullptr;
    const std::size_t i = member(linear ? joint->i : driver.i), j = member(linear ? joint->j : driver.j);
    merge(i, j);
  }

  void merge(std::size_t i, std::size_t j) {
    const auto [kept, merged] = std::minmax(i, j);
    for (Edge& e : edges_) {
      if (e.a == merged) e.a = kept;
      if (e.b == merged) e.b = kept;
    }
    std::erase_if(edges_, [](const Edge& e) { return e.a == e.b; });
  }

  [[nodiscard]] int outer_joints() const {
    return static_cast<int>(
        std::count_if(edges_.begin(), edges_.end(), [](const Edge& e) { return e.a == outside || e.b == outside; }));
  }
  [[nodiscard]] int joints_on(std::size_t member) const {
    return static_cast<int>(
        std::count_if(edges_.begin(), edges_.end(), [=](const Edge& e) { return e.a == member || e.b == member; }));
  }

  /// The number of members in the shortest loop inside the chain through this joint; 0 if there is none.
  [[nodiscard]] int shortest_loop(std::size_t through) const {
    const Edge& start = edges_[through];
    if (start.a == outside || start.b == outside) return 0;
    constexpr int unreached = std::numeric_limits<int>::max();
    std::vector<int> members_to(members_, unreached);
    members_to[start.a] = 1;
    std::queue<std::size_t> next({start.a});
    for (; !next.empty(); next.pop()) {
      for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [letter, a, b] = edges_[e];
        if (e == through || (a != next.front() && b != next.front())) continue;
        const std::size_t to = a == next.front() ? b : a;
        if (to == outside || members_to[to] != unreached) continue;
        members_to[to] = members_to[next.front()] + 1;
        next.push(to);
      }
    }
    return members_to[start.b] == unreached ? 0 : members_to[start.b];
  }

  const Group& group_;
  std::size_t members_;
  std::vector<Edge> edges_;
  int order_ = 0;
};

}  // namespace

void classify(const Model& model, Group& group) {
  const Chain chain(model, group);
  group.order = chain.order();
  group.contour_class = chain.contour_class();
  group.kind = chain.kind();
}

}  // namespace loadpath::mechanism
