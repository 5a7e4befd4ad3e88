#include "lib/mechanism/accuracy/parameter.hpp"

#include "lib/mechanism/forces/induced_source.hpp"

#include <initializer_list>

namespace loadpath::mechanism {
namespace {

using Dimension = Parameter::Dimension;

class List {
 public:
  void add(std::size_t index, std::initializer_list<Dimension> dimensions) {
    for (const Dimension dimension : dimensions) parameters_.push_back({dimension, index});
  }
  void add_joint(const Joint& joint, std::size_t k);
  [[nodiscard]] std::vector<Parameter> take() { return std::move(parameters_); }

 private:
  std::vector<Parameter> parameters_;
};

void List::add_joint(const Joint& joint, std::size_t k) {
  using enum Parameter::Dimension;
  if (joint.kind == JointKind::none) return;
  add(k, {point_i_x, point_i_y, point_j_x, point_j_y});
  switch (joint.kind) {
    case JointKind::none:
    case JointKind::revolute:
      break;
    case JointKind::prismatic:
      add(k, {direction, angle});
      break;
    case JointKind::slot:
      add(k, {direction});
      break;
    case JointKind::rigid:
      add(k, {angle});
      break;
    case JointKind::rack:
    case JointKind::rolling_on_line:
      add(k, {direction, radius_i});
      break;
    case JointKind::cam:
      add(k, {direction, joint.contact == CamContact::flat ? angle : radius_i});
      break;
    case JointKind::gear:
    case JointKind::belt:
    case JointKind::rolling:
      add(k, {radius_i, radius_j});
      break;
  }
  if (modes_of(joint) == 0) return;
  if (joint.pressure_angle != 0.0) add(k, {pressure_angle});
  if (joint.friction.coefficient > 0.0) add(k, {pin_radius, friction_coefficient});
}

}  // namespace

std::vector<Parameter> parameters_of(const Model& model) {
  using enum Parameter::Dimension;
  List list;
  for (std::size_t k = 0; k < model.joints.size(); ++k) list.add_joint(model.joints[k], k);
  for (std::size_t k = 0; k < model.links.size(); ++k) list.add(k, {mass, inertia, centre_x, centre_y});
  for (std::size_t k = 0; k < model.drivers.size(); ++k) list.add(k, {offset});
  for (std::size_t k = 0; k < model.springs.size(); ++k) {
    if (model.springs[k].kind == Spring::Kind::linear) list.add(k, {spring_i_x, spring_i_y, spring_j_x, spring_j_y});
    list.add(k, {rate, Dimension::free, damping});
  }
  for (std::size_t k = 0; k < model.loads.size(); ++k) list.add(k, {load_x, load_y, load_moment, load_at_x, load_at_y});
  return list.take();
}

}  // namespace loadpath::mechanism
