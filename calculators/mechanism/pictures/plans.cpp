#include "calculators/mechanism/pictures/plans.hpp"

#include "lib/draw/canvas/typeset.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using figure::Plan;
using mechanism::length;
using mechanism::Vec;
using Cause = ActingForce::Cause;

constexpr std::size_t most_panels = 12;
constexpr double rounding = 1e-9;  // share of the largest: smaller ones are not drawn

double largest_reaction(const mechanism::Position& at) {
  double most = 0.0;
  for (const auto& r : at.reactions) most = std::max(most, length(r.force));
  return most;
}

double largest_side(const Plan& plan) {
  double most = 0.0;
  for (const auto& v : plan.vectors) most = std::max(most, std::hypot(v.to.x - v.from.x, v.to.y - v.from.y));
  return most;
}

bool moves(const PlanSubject& subject) {
  return std::any_of(subject.at.velocity.begin(), subject.at.velocity.end(),
                     [](const mechanism::Pose& v) { return v.x != 0.0 || v.y != 0.0 || v.phi != 0.0; });
}

/// The speed of the image of a point on the lever: its velocity turned clockwise.
Vec lever_arm(const PlanSubject& subject, int link, Vec place) {
  if (link == mechanism::ground) return {};
  const auto k = static_cast<std::size_t>(link);
  const mechanism::Pose &pose = subject.at.pose[k], &v = subject.at.velocity[k];
  const Vec velocity = Vec{v.x, v.y} + v.phi * mechanism::normal(place - Vec{pose.x, pose.y});
  return -mechanism::normal(velocity);
}

}  // namespace

Plan force_plan(const PlanSubject& subject, int link) {
  const double least = rounding * largest_reaction(subject.at);
  Plan plan{subject.model.links[static_cast<std::size_t>(link)].name, "N", {}};
  Vec end;
  for (const ActingForce& acting : acting_on(subject.model, subject.at, link, subject.statics)) {
    if (length(acting.force) <= least) continue;
    const Vec next = end + acting.force;
    plan.vectors.push_back({point(end), point(next), acting.name(), acting.tone()});
    end = next;
  }
  return plan;
}

figure::Plans force_plans(const PlanSubject& subject) {
  figure::Plans plans;
  std::vector<double> sizes;
  for (std::size_t k = 0; k < subject.model.links.size(); ++k) {
    Plan plan = force_plan(subject, static_cast<int>(k));
    if (plan.vectors.size() < 2) continue;
    sizes.push_back(largest_side(plan));
    plans.panels.push_back(std::move(plan));
  }
  while (plans.panels.size() > most_panels) {
    const auto least = std::min_element(sizes.begin(), sizes.end());
    plans.panels.erase(plans.panels.begin() + (least - sizes.begin()));
    sizes.erase(least);
  }
  return plans;
}

Plan zhukovsky_lever(const PlanSubject& subject) {
  Plan plan = velocity_plan(subject);
  const auto turned = [](figure::Point p) { return figure::Point{p.y, -p.x}; };
  for (auto& image : plan.images) {
    for (auto& p : image.points) p = turned(p);
  }
  for (auto& p : plan.points) p.at = turned(p.at);
  double largest = 0.0;
  for (const auto& v : plan.vectors) largest = std::max(largest, std::hypot(v.to.x, v.to.y));
  plan.vectors.clear();
  for (std::size_t k = 0; k < subject.model.links.size(); ++k) {
    const int link = static_cast<int>(k);
    for (const ActingForce& acting : external_forces(subject.model, subject.at, link, subject.statics)) {
      const bool load = acting.cause != Cause::weight && acting.cause != Cause::inertia;
      const figure::Point foot = point(lever_arm(subject, link, acting.at));
      const bool has_moment = length(acting.force) > 0.0 && std::hypot(foot.x, foot.y) > rounding * largest;
      if (has_moment) plan.forces.push_back({foot, point(acting.force), acting.name(), load});
      const bool turns = acting.couple != 0.0 && subject.at.velocity[k].phi != 0.0;
      if (!turns) continue;
      const bool inertia = acting.cause == Cause::inertia;  // another couple belongs to the full image of its link
      plan.moments.push_back(
          {inertia ? foot : middle_of(plan.images[k].points), acting.couple,
           inertia ? "−" + draw::symbol("J") + " " + draw::symbol("epsilon_" + subject.model.links[k].name)
                   : acting.name()});
    }
  }
  return plan;
}

std::vector<figure::Figure> plan_figures(const PlanSubject& subject) {
  std::vector<figure::Figure> figures;
  figure::Plans forces = force_plans(subject);
  if (!forces.panels.empty()) {
    const bool all = forces.panels.size() < most_panels;
    figures.push_back({"force-plans",
                       all ? "Force polygons at the same position: loads, weight, inertia and joint forces of each link"
                           : "Force polygons at the same position, links with the maximum forces: loads, weight, "
                             "inertia and joint forces",
                       std::move(forces)});
  }
  if (!moves(subject)) return figures;
  figures.push_back({"velocity-plan",
                     "Velocity plan: from the pole p to the image of every point; the image of a link is similar to it "
                     "and turned by a right angle",
                     figure::Plans{{velocity_plan(subject)}}});
  figures.push_back({"acceleration-plan",
                     "Acceleration plan, with the normal and tangential parts between the points of a link and, where "
                     "links slide, the relative part and that of Coriolis",
                     figure::Plans{{acceleration_plan(subject)}}});
  const bool rubs = std::any_of(subject.model.joints.begin(), subject.model.joints.end(),
                                [](const mechanism::Joint& j) { return j.friction.any(); });
  if (rubs) return figures;  // the lever says nothing of the forces inside the joints, which then do work
  Plan lever = zhukovsky_lever(subject);
  if (!lever.forces.empty() || !lever.moments.empty()) {
    figures.push_back(
        {"zhukovsky",
         "Zhukovsky's lever: the velocity plan turned clockwise by a right angle, with the forces at the "
         "images of their points; the moments about the pole, with couples times their angular velocity, sum "
         "to zero",
         figure::Plans{{std::move(lever)}}});
  }
  return figures;
}

}  // namespace loadpath::planar
