#include "lib/mechanism/groups/assemblies.hpp"

#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/groups/positions.hpp"
#include "lib/mechanism/model/whole_turn.hpp"

#include <algorithm>
#include <cstdint>

namespace loadpath::mechanism {
namespace {

// Relative to the mechanism's size, and for a unit vector: assemblies that differ by less are one.
constexpr double same = 1e-6;
constexpr int starts = 200;

/// Evenly spread numbers between 0 and 1 that are the same in every run (splitmix64).
class Spread {
 public:
  double next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 0;
};

/// Also true for a cam: the point of contact determines the side.
bool has_wheels(const Plan& plan, const GroupPlan& group) {
  return std::any_of(plan.cuts.begin() + static_cast<std::ptrdiff_t>(group.first_cut),
                     plan.cuts.begin() + static_cast<std::ptrdiff_t>(group.last_cut),
                     [](const Cut& cut) { return cut.shape.radius_i != 0.0 || cut.shape.profile != nullptr; });
}

class Search {
 public:
  Search(const Model& model, const Plan& plan, std::span<const Pose> stated, std::span<const Drive> drives)
      : model_(model),
        plan_(plan),
        dyads_(dyad_closings(model, plan)),
        length_(characteristic_length(model)),
        positions_(plan, length_),
        stated_(stated.begin(), stated.end()) {
    positions_.adopt(stated);
    for (std::size_t t = 0; t < plan.tree.size(); ++t) values_.push_back(positions_.hung(t).value);
    for (std::size_t g = 0; g < plan.groups.size(); ++g) branches_.push_back(positions_.branch(g));
    positions_.aim(drives);
  }

  Assemblies run() {
    close_group(0);
    return std::move(found_);
  }

 private:
  /// Every assembly of this group on the placed links, the stated one first, each with those of the groups after it.
  void close_group(std::size_t g) {
    if (g == plan_.groups.size()) return keep();
    if (found_.list.size() >= most_assemblies) {
      found_.complete = false;
    } else if (plan_.groups[g].closing == Closing::by_newton) {
      iterate(g);
    } else {
      close_on_sides(g);
    }
  }

  void close_on_sides(std::size_t g) {
    const auto dyad = std::ranges::find(dyads_, g, &DyadClosing::group);
    if (dyad == dyads_.end()) {
      if (positions_.close_on_side(g, 1.0)) close_group(g + 1);
      return;
    }
    const double stated = branches_[g];
    for (const double branch : {stated, -stated}) {
      if (!positions_.close_on_side(g, branch)) continue;
      sides_.push_back(side_name(model_, *dyad, closing_angle(model_, *dyad, poses()).sine));
      close_group(g + 1);
      sides_.pop_back();
    }
  }

  /// The unknown coordinates at which a group closes, and where that puts the first of its links.
  struct Closed {
    std::vector<double> coordinates;
    std::vector<Placed> links;
    double angle = 0.0;
    bool stated = false;
    int number = 0;
  };

  void iterate(std::size_t g) {
    const GroupPlan& group = plan_.groups[g];
    const bool wheels = has_wheels(plan_, group);
    found_.complete = false;
    std::vector<Closed> all;
    Spread spread;
    for (int k = 0; k < (wheels ? 1 : starts); ++k) {
      if (positions_.close_from(g, start(group, k, spread))) add(group, k == 0, all);
    }
    number(all);
    for (const Closed& closed : all) {
      if (!positions_.close_from(g, closed.coordinates)) continue;
      if (!wheels) sides_.push_back(model_.links[first_link(plan_, group)].name + "_" + std::to_string(closed.number));
      close_group(g + 1);
      if (!wheels) sides_.pop_back();
    }
  }

  static void number(std::vector<Closed>& all) {
    std::ranges::sort(all, {}, &Closed::angle);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].number = static_cast<int>(k) + 1;
    std::stable_partition(all.begin(), all.end(), [](const Closed& c) { return c.stated; });
  }

  /// The first is as stated; of the others angles lie anywhere, slides within twice the mechanism's size.
  std::vector<double> start(const GroupPlan& group, int k, Spread& spread) const {
    std::vector<double> values;
    for (const std::size_t t : group.unknowns) {
      const bool turns = plan_.tree[t].kind == TreeJoint::Kind::turn;
      const double anywhere = turns ? whole_turn * spread.next() : 4.0 * length_ * (spread.next() - 0.5);
      values.push_back(k == 0 ? values_[t] : turns ? anywhere : values_[t] + anywhere);
    }
    return values;
  }

  void add(const GroupPlan& group, bool stated, std::vector<Closed>& all) const {
    Closed closed;
    closed.stated = stated;
    for (const std::size_t t : group.unknowns) closed.coordinates.push_back(positions_.hung(t).value);
    for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
      if (plan_.tree[t].link < plan_.ground) closed.links.push_back(positions_.link(plan_.tree[t].link));
    }
    const auto is_same = [&](const Closed& other) {
      return std::ranges::equal(closed.links, other.links,
                                [&](const Placed& a, const Placed& b) { return coincide(a, b); });
    };
    if (std::ranges::any_of(all, is_same)) return;
    const double angle = angle_of(positions_.link(first_link(plan_, group)).turned);
    closed.angle = angle < -same ? angle + whole_turn : angle;  // a rounded zero is not a full revolution
    all.push_back(std::move(closed));
  }

  [[nodiscard]] bool coincide(const Placed& a, const Placed& b) const {
    const Vec turned{a.turned.cosine - b.turned.cosine, a.turned.sine - b.turned.sine};
    return mechanism::length(a.origin - b.origin) <= same * length_ && mechanism::length(turned) <= same;
  }

  [[nodiscard]] std::vector<Pose> poses() const {
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < plan_.ground; ++k) {
      const Placed& link = positions_.link(k);
      poses.push_back({link.origin.x, link.origin.y, link.phi});
    }
    return poses;
  }

  void keep() {
    Assembly assembly{sides_, poses()};
    const auto placed = [](const Pose& p) { return Placed{turn(p.phi), {p.x, p.y}, p.phi}; };
    const auto near = [&](const Pose& a, const Pose& b) { return coincide(placed(a), placed(b)); };
    const auto known = [&](const Assembly& other) { return std::ranges::equal(assembly.poses, other.poses, near); };
    if (std::ranges::any_of(found_.list, known)) return;  // at a change point both sides are one
    assembly.followed = std::ranges::equal(assembly.poses, stated_, near);
    if (assembly.followed) assembly.poses = stated_;
    found_.list.push_back(std::move(assembly));
  }

  const Model& model_;
  const Plan& plan_;
  std::vector<DyadClosing> dyads_;
  double length_;
  GroupPositions positions_;
  std::vector<Pose> stated_;
  std::vector<double> values_, branches_;  // coordinates of the tree joints and sides of the groups, as stated
  std::vector<std::string> sides_;
  Assemblies found_;
};

}  // namespace

std::string Assembly::name() const {
  std::string all;
  for (const std::string& side : sides) all += (all.empty() ? "" : ", ") + side;
  return all.empty() ? "the only one" : all;
}

Assemblies assemblies(const Model& model) {
  WholeSystem system(model);
  if (system.assemble() != Status::closed) return {};
  std::vector<Pose> stated(model.links.size());
  system.store_poses(stated);
  std::vector<Drive> drives(model.drivers.size());
  for (std::size_t d = 0; d < drives.size(); ++d) drives[d].coordinate = system.coordinate(d);
  const Plan plan = plan_of(model);
  return Search(model, plan, stated, drives).run();
}

}  // namespace loadpath::mechanism
