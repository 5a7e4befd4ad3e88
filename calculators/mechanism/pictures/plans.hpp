// The plans of a planar mechanism at a position, as textbooks draw them.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/pictures/forces.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::planar {

/// Data of a plan.
struct PlanSubject {
  const mechanism::Model& model;
  const std::vector<TracedPoint>& points;
  const mechanism::Position& at;
  bool statics = false;
};

/// The forces on a link head to tail: a closed polygon. Forces that rounding leaves of zeros are left out.
figure::Plan force_plan(const PlanSubject& subject, int link);
/// The links with the largest forces, at most a dozen, in their order.
figure::Plans force_plans(const PlanSubject& subject);

/// From the pole, at which the ground is, to the velocity of every point. Where links slide on each other the point of
/// the second link has the second link's name.
figure::Plan velocity_plan(const PlanSubject& subject);
/// The same of accelerations, with their parts towards and across the lines between the points of a link, and with
/// those of sliding: relative and Coriolis.
figure::Plan acceleration_plan(const PlanSubject& subject);

/// The velocity plan turned clockwise by a right angle, with the forces at the images of their points: their moments
/// about the pole, and couples times angular velocities, sum to zero.
figure::Plan zhukovsky_lever(const PlanSubject& subject);

/// The figures of all plans that say something at this position.
std::vector<figure::Figure> plan_figures(const PlanSubject& subject);

}  // namespace loadpath::planar
