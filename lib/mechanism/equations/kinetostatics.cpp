#include "lib/mechanism/equations/kinetostatics.hpp"

#include "lib/mechanism/model/spring.hpp"
#include "lib/numerics/dual.hpp"

namespace loadpath::mechanism {

using numerics::Dual;

namespace {

template <class Scalar>
BasicVec<Scalar> at(std::span<const Scalar> q, std::size_t link) {
  return {q[3 * link], q[3 * link + 1]};
}

template <class Scalar>
void add_spring(const BasicSpring<Scalar>& spring, const BasicConstraints<Scalar>& constraints,
                std::span<const Scalar> velocity, std::span<Scalar> required) {
  const auto speeds = [&](int link) {
    const std::size_t k = constraints.index(link);
    return BasicSpeeds<Scalar>{at(velocity, k), velocity[3 * k + 2]};
  };
  const BasicPlaced<Scalar>&i = constraints.placed(spring.i), &j = constraints.placed(spring.j);
  const BasicSpringNow<Scalar> now = spring_now(spring, i, j, speeds(spring.i), speeds(spring.j));
  const auto supply = [&](int link, const BasicPlaced<Scalar>& frame, BasicVec<Scalar> place, double sense) {
    if (link == ground) return;
    Scalar* const of_link = &required[3 * constraints.index(link)];
    of_link[0] -= sense * now.force.x;
    of_link[1] -= sense * now.force.y;
    of_link[2] -= sense * (now.couple + cross(place - frame.origin, now.force));
  };
  supply(spring.i, i, now.at_i, 1.0);
  supply(spring.j, j, now.at_j, -1.0);
}

}  // namespace

template <class Scalar>
void required_forces(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
                     std::span<const std::type_identity_t<Scalar>> velocity,
                     std::span<const std::type_identity_t<Scalar>> acceleration, bool statics,
                     std::span<std::type_identity_t<Scalar>> required) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const BasicAcceleration<Scalar> a{at(acceleration, k), velocity[3 * k + 2], acceleration[3 * k + 2]};
    const BasicWrench<Scalar> needed = inertia_less_weight(model.links[k], constraints.turned(k),
                                                           statics ? BasicAcceleration<Scalar>{} : a, model.gravity);
    required[3 * k] = needed.force.x;
    required[3 * k + 1] = needed.force.y;
    required[3 * k + 2] = needed.moment;
  }
  for (const auto& load : model.loads) {
    const auto k = static_cast<std::size_t>(load.link);
    const BasicWrench<Scalar> acting = wrench_of(load, constraints.turned(k));
    required[3 * k] -= acting.force.x;
    required[3 * k + 1] -= acting.force.y;
    required[3 * k + 2] -= acting.moment;
  }
}

template <class Scalar>
void supply_springs(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
                    std::span<const std::type_identity_t<Scalar>> velocity,
                    std::span<std::type_identity_t<Scalar>> required) {
  for (const auto& spring : model.springs) add_spring(spring, constraints, velocity, required);
}

template <class Scalar>
void share_out(const BasicModel<Scalar>& model, const BasicConstraints<Scalar>& constraints,
               std::span<const std::type_identity_t<Scalar>> multipliers, double length,
               std::span<BasicReaction<std::type_identity_t<Scalar>>> reactions,
               std::span<std::type_identity_t<Scalar>> effort) {
  for (std::size_t k = 0; k < reactions.size(); ++k) {
    const BasicPair<Scalar>& pair = constraints.pairs()[k];
    BasicReaction<Scalar>& reaction = reactions[k];
    reaction = {};
    for (std::size_t r = 0; r < pair.shape.rows(); ++r) {
      const Scalar multiplier = length * multipliers[pair.row + r];
      reaction.force = reaction.force + multiplier * pair.at.rows[r].e;
      reaction.couple += length * multiplier * pair.at.rows[r].m;
    }
    reaction.at = length * pair.at.at;
    reaction.touch = numerics::value_of(pair.at.touch.parameter);
  }
  const auto efforts = multipliers.subspan(constraints.first_driver_row());
  for (std::size_t k = 0; k < effort.size(); ++k) {
    const bool rotary = model.drivers[k].kind == Driver::Kind::rotary;
    effort[k] = (rotary ? length * length : length) * efforts[k];
  }
}

template void required_forces(const BasicModel<double>&, const BasicConstraints<double>&, std::span<const double>,
                              std::span<const double>, bool, std::span<double>);
template void supply_springs(const BasicModel<double>&, const BasicConstraints<double>&, std::span<const double>,
                             std::span<double>);
template void share_out(const BasicModel<double>&, const BasicConstraints<double>&, std::span<const double>, double,
                        std::span<BasicReaction<double>>, std::span<double>);
template void required_forces(const BasicModel<Dual>&, const BasicConstraints<Dual>&, std::span<const Dual>,
                              std::span<const Dual>, bool, std::span<Dual>);
template void supply_springs(const BasicModel<Dual>&, const BasicConstraints<Dual>&, std::span<const Dual>,
                             std::span<Dual>);
template void share_out(const BasicModel<Dual>&, const BasicConstraints<Dual>&, std::span<const Dual>, double,
                        std::span<BasicReaction<Dual>>, std::span<Dual>);

}  // namespace loadpath::mechanism
