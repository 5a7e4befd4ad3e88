// Velocity and acceleration plans.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/pictures/plans.hpp"
#include "lib/draw/canvas/typeset.hpp"

#include <algorithm>
#include <cctype>

namespace loadpath::planar {

namespace {

using figure::Plan;
using mechanism::JointKind;
using mechanism::length;
using mechanism::Vec;

/// A point of the mechanism in a plan.
struct ImagePoint {
  std::string name;  // name of the point: "A"
  int link = mechanism::ground;
  Vec own;  // link frame
};

/// Velocities or accelerations.
using Quantity = Vec PointMotion::*;

Vec value(const PlanSubject& subject, const ImagePoint& p, Quantity quantity) {
  return motion_of(subject.at, p.link, p.own).*quantity;
}

constexpr const char *velocity_pole = "p", *acceleration_pole = "p_a";

/// Textbooks name the images by the small letters of the points.
std::string small(std::string name) {
  if (!name.empty()) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return name;
}

/// Where links slide on one another, the points of both that lie at the pin; the second has its link's name.
struct SlidingPair {
  ImagePoint pin, seat;
  const mechanism::Joint* joint = nullptr;
};
std::vector<SlidingPair> sliding_pairs(const PlanSubject& subject) {
  std::vector<SlidingPair> pairs;
  for (const auto& j : subject.model.joints) {
    if (j.kind != JointKind::slot && j.kind != JointKind::prismatic) continue;
    if (j.j == mechanism::ground) continue;  // that point is the pole
    const auto k = static_cast<std::size_t>(j.j);
    const mechanism::Pose& pose = subject.at.pose[k];
    const Vec place = motion_of(subject.at, j.i, j.point_i).place;
    const Vec own = mechanism::turn(pose.phi).back()(place - Vec{pose.x, pose.y});
    pairs.push_back({{j.name, j.i, j.point_i}, {j.name + "_" + subject.model.links[k].name, j.j, own}, &j});
  }
  return pairs;
}

/// The points of a link that joints hold, which its image is spanned by.
std::vector<ImagePoint> joint_points(const PlanSubject& subject, int link) {
  std::vector<ImagePoint> points;
  const auto add = [&](const std::string& name, Vec own) {
    const bool known =
        std::any_of(points.begin(), points.end(), [&](const auto& p) { return length(p.own - own) == 0.0; });
    if (!known) points.push_back({name, link, own});
  };
  for (const auto& j : subject.model.joints) {
    if (j.i == link) add(j.name, j.point_i);
    if (j.j == link && (j.kind == JointKind::revolute || j.kind == JointKind::rigid)) add(j.name, j.point_j);
  }
  for (const SlidingPair& pair : sliding_pairs(subject)) {
    if (pair.seat.link == link) add(pair.seat.name, pair.seat.own);
  }
  return points;
}

class MotionPlan {
 public:
  MotionPlan(const PlanSubject& subject, Quantity quantity, const char* unit, const char* pole)
      : subject_(subject), quantity_(quantity) {
    plan_.unit = unit;
    plan_.points.push_back({pole, {}});
    for (std::size_t k = 0; k < subject.model.links.size(); ++k) add_image(static_cast<int>(k));
    for (const TracedPoint& p : subject.points) add_point({p.name, p.link, p.at});
  }

  void add_sliding_points() {
    for (const SlidingPair& pair : sliding_pairs(subject_)) name(pair.seat);
  }
  void add_sliding_velocities() {
    for (const SlidingPair& pair : sliding_pairs(subject_))
      add_part(of(pair.seat), of(pair.pin), "v_r_" + pair.joint->name);
  }
  /// a = a of the point of the slot + Coriolis + relative.
  void add_sliding_accelerations() {
    for (const SlidingPair& pair : sliding_pairs(subject_)) {
      const Vec relative =
          value(subject_, pair.pin, &PointMotion::velocity) - value(subject_, pair.seat, &PointMotion::velocity);
      const double omega = subject_.at.velocity[static_cast<std::size_t>(pair.seat.link)].phi;
      const Vec corner = of(pair.seat) + 2.0 * omega * mechanism::normal(relative);
      add_part(of(pair.seat), corner, "a_c_" + pair.joint->name);
      add_part(corner, of(pair.pin), "a_r_" + pair.joint->name);
    }
  }
  /// From the image of a link's fixed joint, or else its first, to those of the others: towards it, then across.
  void add_turning_accelerations() {
    for (std::size_t k = 0; k < subject_.model.links.size(); ++k) {
      auto points = joint_points(subject_, static_cast<int>(k));
      std::stable_partition(points.begin(), points.end(), [&](const auto& p) { return length(of(p)) <= negligible(); });
      const double omega = subject_.at.velocity[k].phi, phi = subject_.at.pose[k].phi;
      for (std::size_t n = 1; n < points.size(); ++n) {
        const Vec arm = mechanism::turn(phi)(points[n].own - points[0].own);
        const Vec corner = of(points[0]) - omega * omega * arm;
        const std::string pair = points[n].name.substr(0, points[n].name.find('_')) + points[0].name;
        const bool bare = length(of(points[0])) <= negligible() && length(of(points[n]) - corner) <= negligible();
        if (bare) continue;  // the vector from the pole says it
        add_part(of(points[0]), corner, "a_" + pair + "_n");
        add_part(corner, of(points[n]), "a_" + pair + "_t");
      }
    }
  }
  [[nodiscard]] const Plan& plan() const { return plan_; }

 private:
  [[nodiscard]] Vec of(const ImagePoint& p) const { return value(subject_, p, quantity_); }

  void add_image(int link) {
    Plan::Image image{subject_.model.links[static_cast<std::size_t>(link)].name, {}};
    for (const ImagePoint& p : joint_points(subject_, link)) image.points.push_back(point(of(p)));
    plan_.images.push_back(std::move(image));
  }

  /// Points at rest lie in the pole.
  void add_point(const ImagePoint& p) {
    if (length(of(p)) <= negligible()) return;
    plan_.vectors.push_back({{}, point(of(p)), "", Plan::Tone::first});
    name(p);
  }
  void name(const ImagePoint& p) { plan_.points.push_back({label(small(p.name)), point(of(p))}); }
  /// A label equal to that of a pole, or of another point (A and a), gets a prime.
  [[nodiscard]] std::string label(const std::string& name) const {
    const auto taken = [&](const std::string& text) {
      return text == velocity_pole || text == acceleration_pole ||
             std::any_of(plan_.points.begin(), plan_.points.end(),
                         [&](const auto& other) { return other.name == text; });
    };
    std::string text = name, primes;
    for (; taken(text); text = draw::symbol(name) + primes) primes += "′";
    return text;
  }

  void add_part(Vec from, Vec to, std::string label) {
    if (length(to - from) <= negligible()) return;
    plan_.vectors.push_back({point(from), point(to), std::move(label), Plan::Tone::part});
  }

  [[nodiscard]] double negligible() const { return 1e-6 * largest(); }
  [[nodiscard]] double largest() const {
    double most = 0.0;
    for (const TracedPoint& p : subject_.points) most = std::max(most, length(of({p.name, p.link, p.at})));
    return most;
  }

  const PlanSubject& subject_;
  Quantity quantity_;
  Plan plan_;
};

}  // namespace

Plan velocity_plan(const PlanSubject& subject) {
  MotionPlan plan(subject, &PointMotion::velocity, "m/s", velocity_pole);
  plan.add_sliding_points();
  plan.add_sliding_velocities();
  return plan.plan();
}

Plan acceleration_plan(const PlanSubject& subject) {
  MotionPlan plan(subject, &PointMotion::acceleration, "m/s^2", acceleration_pole);
  plan.add_sliding_points();
  plan.add_turning_accelerations();
  plan.add_sliding_accelerations();
  return plan.plan();
}

}  // namespace loadpath::planar
