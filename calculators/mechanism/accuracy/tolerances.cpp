#include "calculators/mechanism/accuracy/tolerances.hpp"

#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using mechanism::Output;
using mechanism::Parameter;
using mechanism::Vec;
using Dimension = Parameter::Dimension;
using Term = mechanism::Tolerance::Term;

/// Moves a named point of a link along `by`: every number of the model that is its place.
class PointMove {
 public:
  PointMove(const Mechanism::Input& in, const mechanism::Model& model, const Name& link, const Name& point)
      : in_(in), model_(model), link_(link_index(in, link)), point_(point) {}

  [[nodiscard]] mechanism::Tolerance along(Vec by) const {
    using enum Parameter::Dimension;
    mechanism::Tolerance tolerance;
    const auto add = [&](Dimension x, Dimension y, std::size_t k) {
      if (by.x != 0.0) tolerance.terms.push_back({{x, k}, by.x});
      if (by.y != 0.0) tolerance.terms.push_back({{y, k}, by.y});
    };
    for (std::size_t k = 0; k < model_.joints.size(); ++k) {
      const auto [first, second] = point_names(in_.joints[k]);
      if (model_.joints[k].i == link_ && first == point_) add(point_i_x, point_i_y, k);
      if (model_.joints[k].j == link_ && second == point_) add(point_j_x, point_j_y, k);
    }
    for (std::size_t k = 0; k < model_.springs.size(); ++k) {
      if (model_.springs[k].kind == mechanism::Spring::Kind::turning) continue;
      const auto [first, second] = end_of(in_.springs[k]);
      if (model_.springs[k].i == link_ && first == point_) add(spring_i_x, spring_i_y, k);
      if (model_.springs[k].j == link_ && second == point_) add(spring_j_x, spring_j_y, k);
    }
    for (std::size_t k = 0; k < model_.loads.size(); ++k) {
      if (model_.loads[k].link == link_ && in_.loads[k].at == point_) add(load_at_x, load_at_y, k);
    }
    if (link_ == mechanism::ground) return tolerance;
    const auto k = static_cast<std::size_t>(link_);
    if (in_.links[k].S == point_) add(centre_x, centre_y, k);
    tolerance.moved = {k, place(), by};
    return tolerance;
  }
  [[nodiscard]] Vec place() const { return vector_of(*find_point(in_, link_, point_)); }

 private:
  const Mechanism::Input& in_;
  const mechanism::Model& model_;
  int link_;
  const Name& point_;
};

mechanism::Tolerance of_points(const Mechanism::Input& in, const mechanism::Model& model, const planar::Tolerance& t) {
  if (t.of == Toleranced::x || t.of == Toleranced::y) {
    return PointMove(in, model, t.link, t.point).along(t.of == Toleranced::x ? Vec{1.0, 0.0} : Vec{0.0, 1.0});
  }
  const PointMove far(in, model, t.link, t.to);
  const Vec apart = far.place() - PointMove(in, model, t.link, t.point).place();
  return far.along(t.of == Toleranced::length ? (1.0 / mechanism::length(apart)) * apart : normal(apart));
}

mechanism::Tolerance single(Dimension dimension, std::size_t index) {
  mechanism::Tolerance tolerance;
  tolerance.terms.push_back({{dimension, index}});
  return tolerance;
}

std::size_t driver_of(const mechanism::Model& model, const Mechanism::Input& in, const Name& joint) {
  for (std::size_t d = 0; d < model.drivers.size(); ++d) {
    const mechanism::Driver& driver = model.drivers[d];
    const bool rotary = driver.kind == mechanism::Driver::Kind::rotary;
    if (joint == (rotary ? in.crank.joint : in.joints[static_cast<std::size_t>(driver.joint)].name)) return d;
  }
  return 0;
}

mechanism::Tolerance tolerance_of(const Mechanism::Input& in, const mechanism::Model& model,
                                  const planar::Tolerance& t) {
  using enum Parameter::Dimension;
  const auto link = [&] { return index_of(in.links, t.link); };
  const auto joint = [&] { return index_of(in.joints, t.joint); };
  switch (t.of) {
    case Toleranced::length:
    case Toleranced::x:
    case Toleranced::y:
    case Toleranced::angle:
      return of_points(in, model, t);
    case Toleranced::mass:
      return single(mass, link());
    case Toleranced::J:
      return single(inertia, link());
    case Toleranced::radius:
      return single(radius_i, joint());
    case Toleranced::radius_second:
      return single(radius_j, joint());
    case Toleranced::direction:
      return single(direction, joint());
    case Toleranced::mu:
      return single(friction_coefficient, joint());
    case Toleranced::rate:
      return single(rate, index_of(in.springs, t.spring));
    case Toleranced::drive:
      break;
  }
  return single(offset, driver_of(model, in, t.joint));
}

}  // namespace

ToleranceShape shape_of(Toleranced of, const Mechanism::Input& in, const planar::Tolerance& tolerance) {
  switch (of) {
    case Toleranced::length:
      return {.link = true, .point = true, .to = true, .t = true};
    case Toleranced::x:
    case Toleranced::y:
      return {.link = true, .point = true, .t = true};
    case Toleranced::angle:
      return {.link = true, .point = true, .to = true, .t_angle = true};
    case Toleranced::mass:
      return {.link = true, .t_mass = true, .t_part = true};
    case Toleranced::J:
      return {.link = true, .t_part = true};
    case Toleranced::radius:
    case Toleranced::radius_second:
      return {.joint = true, .t = true};
    case Toleranced::direction:
      return {.joint = true, .t_angle = true};
    case Toleranced::mu:
      return {.joint = true, .t_part = true};
    case Toleranced::rate:
      return {.spring = true, .t_part = true};
    case Toleranced::drive:
      break;
  }
  const bool turns = tolerance.joint == in.crank.joint;
  return {.joint = true, .t = !turns, .t_angle = turns};
}

HalfWidth half_width(const planar::Tolerance& t) {
  if (is_set(t.t_angle)) return {t.t_angle, "deg"};
  if (is_set(t.t_mass)) return {in_si(t.t_mass), "kg"};
  if (is_set(t.t_part)) return {t.t_part, "-"};
  return {in_si(t.t), "mm"};
}

std::vector<mechanism::Tolerance> tolerances_of(const Mechanism::Input& in, const mechanism::Model& model) {
  mechanism::Model numbers = model;
  std::vector<mechanism::Tolerance> all;
  for (const planar::Tolerance& t : in.tolerances) {
    mechanism::Tolerance tolerance = tolerance_of(in, model, t);
    tolerance.half_width = half_width(t).si;
    if (is_set(t.t_part)) tolerance.half_width *= std::abs(number(numbers, tolerance.terms[0].parameter));
    tolerance.sigmas = t.sigmas;
    all.push_back(std::move(tolerance));
  }
  return all;
}

std::vector<mechanism::Clearance> clearances_of(const Mechanism::Input& in) {
  std::vector<mechanism::Clearance> all;
  for (std::size_t k = 0; k < in.joints.size(); ++k) {
    const double clearance = in_si(in.joints[k].clearance);
    if (clearance > 0.0) all.push_back({k, clearance, mechanism::Clearance::Direction::any_direction});
  }
  return all;
}

Output output_of(const Mechanism::Input& in, const mechanism::Model& model, const planar::Accuracy& wanted) {
  using planar::Watched;
  switch (wanted.of) {
    case Watched::x:
    case Watched::y: {
      const Output::Kind kind = wanted.of == Watched::x ? Output::Kind::x : Output::Kind::y;
      if (!wanted.link.empty()) {
        const int link = link_index(in, wanted.link);
        return {kind, static_cast<std::size_t>(link), vector_of(*find_point(in, link, wanted.point))};
      }
      const auto points = traced_points(in);
      const auto point =
          std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.name == wanted.point.view(); });
      return {kind, static_cast<std::size_t>(point->link), point->at};
    }
    case Watched::angle:
      return {Output::Kind::phi, index_of(in.links, wanted.link), {}};
    case Watched::force:
      return {Output::Kind::reaction, index_of(in.joints, wanted.joint), {}};
    case Watched::drive:
      break;
  }
  return {Output::Kind::effort, driver_of(model, in, wanted.joint), {}};
}

}  // namespace loadpath::planar
