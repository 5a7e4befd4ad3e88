#include "lib/project/references/space/clearances.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/space/bodies.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double touching = 1e-5;  // m: sizes typed with few digits

std::string in_mm(double length) { return format_quantity(length, "mm", 4); }

/// Along the shaft; NaN if a position or a width is unknown.
double overlap(const Cylinder& a, const Cylinder& b) {
  if (std::isnan(a.from + a.to + b.from + b.to)) return std::nan("");
  return std::min(a.to, b.to) - std::max(a.from, b.from);
}

/// Another shaft in the plane of a pair, in the positions of this one: both have the same direction, as their loads.
struct Neighbour {
  const Step* shaft;
  GearOnShaft own, mate;
  double shift;  // from its positions to those here
};

Cylinder shifted(Cylinder body, double shift) {
  body.from += shift, body.to += shift;
  return body;
}

class SpaceCheck {
 public:
  SpaceCheck(const Step& shaft, const Project& project)
      : shaft_(shaft), project_(project), gears_(gears_on(shaft, project)), bearings_(bearings_of(shaft, project)) {}

  std::vector<ReducedLoad> run() {
    find_neighbours();
    for (const GearOnShaft& gear : gears_) compare_own_bearings(gear);
    for (const Neighbour& neighbour : neighbours_) compare_neighbour(neighbour);
    compare_pairs();
    compare_directions();
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) {
    const auto is_it = [&](const ReducedLoad& one) { return one.path == path; };
    if (std::none_of(found_.begin(), found_.end(), is_it)) found_.push_back({path, std::move(message)});
  }

  void find_neighbours() {
    for (const auto& other : project_.steps) {
      if (other.get() == &shaft_ || !is_shaft(*other)) continue;
      for (const GearOnShaft& mate : gears_on(*other, project_)) {
        for (const GearOnShaft& own : gears_) {
          if (own.pair == mate.pair && own.is_first != mate.is_first)
            neighbours_.push_back({other.get(), own, mate, own.x - mate.x});
        }
      }
    }
  }

  /// The bearing with its own width; the shaft by itself knows only the bore.
  void compare_own_bearings(const GearOnShaft& gear) {
    for (const Cylinder& bearing : bearings_) {
      const double shared = overlap(gear.body, bearing);
      if (!(shared > touching)) continue;
      add(gear.body.path, say("{1} and {2} overlap by {3} along the shaft: move one of them, or {4} = \"...\"",
                              gear.body.name, bearing.name, in_mm(shared), because_key(gear.body.path)));
    }
  }

  /// Common practice: the module of the gear and at least 2 mm, for run-out, deflection and oil.
  void compare(const Cylinder& own, const Cylinder& other, const Neighbour& neighbour, double m_n) {
    const double least = std::max(m_n, 0.002), gap = neighbour.own.a - (own.D + other.D) / 2.0;
    if (!(overlap(own, other) > touching) || !(gap < least - touching)) return;
    const std::string sizes = in_mm(own.D) + " and " + in_mm(other.D);
    if (gap < 0.0)
      return add(own.path,
                 say("{1} and {2}, diameters {3}, collide: their axes are {4} apart by '{5}'; change the "
                     "sizes or the position, or {6} = \"...\"",
                     own.name, other.name, sizes, in_mm(neighbour.own.a), neighbour.own.pair, because_key(own.path)));
    add(own.path, say("{1} and {2}, diameters {3}, are {4} apart, less than {5} (the module, at least 2 mm, is common "
                      "practice): change the sizes or the position, or {6} = \"...\"",
                      own.name, other.name, sizes, in_mm(gap), in_mm(least), because_key(own.path)));
  }

  void compare_neighbour(const Neighbour& neighbour) {
    const bool is_earlier = is_before(*neighbour.shaft);  // what concerns both alike is reported once
    for (const GearOnShaft& own : gears_) {
      const bool is_linking = own.pair == neighbour.own.pair;
      for (const Cylinder& body : segments_of(*neighbour.shaft, project_)) {
        const bool is_under_mate = is_linking && body.D <= neighbour.mate.d_f * (1.0 + 1e-6);
        if (!is_under_mate) compare(own.body, shifted(body, neighbour.shift), neighbour, own.m_n);
      }
      for (const Cylinder& body : bearings_of(*neighbour.shaft, project_))
        compare(own.body, shifted(body, neighbour.shift), neighbour, own.m_n);
      for (const GearOnShaft& other : gears_on(*neighbour.shaft, project_)) {
        if (is_earlier && other.pair != own.pair && !is_linking_pair(other.pair, own.pair, *neighbour.shaft))
          compare(own.body, shifted(other.body, neighbour.shift), neighbour, std::max(own.m_n, other.m_n));
      }
    }
    for (const Cylinder& own : bearings_) {
      for (const Cylinder& body : bearings_of(*neighbour.shaft, project_)) {
        if (is_earlier) compare(own, shifted(body, neighbour.shift), neighbour, 0.0);
      }
    }
  }

  bool is_before(const Step& other) const {
    for (const auto& step : project_.steps) {
      if (step.get() == &shaft_ || step.get() == &other) return step.get() == &shaft_;
    }
    return false;
  }

  /// An idler is one gear of two pairs at one place: its neighbour there meshes with it.
  bool is_linking_pair(const std::string& there, const std::string& here, const Step& other) const {
    const auto at = [](const std::vector<GearOnShaft>& gears, const std::string& pair) {
      const auto gear = std::find_if(gears.begin(), gears.end(), [&](const auto& g) { return g.pair == pair; });
      return gear == gears.end() ? std::nan("") : gear->x;
    };
    const std::vector<GearOnShaft> theirs = gears_on(other, project_);
    return std::abs(at(gears_, here) - at(gears_, there)) < touching ||
           std::abs(at(theirs, here) - at(theirs, there)) < touching;
  }

  /// Pairs that connect the same two shafts have one centre distance, and one distance along both shafts.
  void compare_pairs() {
    for (const Neighbour& one : neighbours_) {
      const auto first = std::find_if(neighbours_.begin(), neighbours_.end(),
                                      [&](const Neighbour& other) { return other.shaft == one.shaft; });
      if (first->own.pair == one.own.pair || !is_before(*one.shaft)) continue;
      if (std::abs(first->own.a - one.own.a) > 1e-3 * one.own.a)
        add(one.own.body.path, say("'{1}' and '{2}' connect '{3}' and '{4}', and their centre distances are {5} and "
                                   "{6}: give both the same a_w, or {7} = \"...\"",
                                   first->own.pair, one.own.pair, shaft_.name(), one.shaft->name(), in_mm(first->own.a),
                                   in_mm(one.own.a), because_key(one.own.body.path)));
      if (std::abs(first->shift - one.shift) > 0.1 * one.own.b)
        add(one.own.body.path,
            say("'{1}' and '{2}' are {3} apart on '{4}' and {5} on '{6}': their gears must face each "
                "other, or {7} = \"...\"",
                first->own.pair, one.own.pair, in_mm(std::abs(first->own.x - one.own.x)), shaft_.name(),
                in_mm(std::abs(first->mate.x - one.mate.x)), one.shaft->name(), because_key(one.own.body.path)));
    }
  }

  /// Two gears that mesh with two shafts: without an angle both shafts would lie in the same direction.
  void compare_directions() {
    for (const Neighbour& one : neighbours_) {
      const Neighbour& first = neighbours_.front();
      if (first.shaft == one.shaft || first.own.has_angle || one.own.has_angle) continue;
      add(one.own.seat + "angle",
          say("gears of '{1}' and '{2}' have no angle, so both mating shafts lie in direction X: "
              "give the direction to each, or {3} = \"...\"",
              first.own.pair, one.own.pair, because_key(one.own.seat + "angle")));
    }
  }

  const Step& shaft_;
  const Project& project_;
  std::vector<GearOnShaft> gears_;
  std::vector<Cylinder> bearings_;
  std::vector<Neighbour> neighbours_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> values_in_collision(const Step& step, const Project& project) {
  return is_shaft(step) ? SpaceCheck(step, project).run() : std::vector<ReducedLoad>();
}

}  // namespace loadpath::project
