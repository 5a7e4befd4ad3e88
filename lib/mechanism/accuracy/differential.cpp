#include "lib/mechanism/accuracy/differential.hpp"

#include "lib/mechanism/equations/kinetostatics.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

constexpr std::size_t lanes = std::tuple_size_v<decltype(Dual::d)>;

void take(std::span<const Pose> poses, double length, std::span<Dual> x) {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    x[3 * k] = poses[k].x / length;
    x[3 * k + 1] = poses[k].y / length;
    x[3 * k + 2] = poses[k].phi;
  }
}

// a += s b, of derivatives
void add(Dual& a, double s, const Dual& b) {
  for (std::size_t l = 0; l < lanes; ++l) a.d[l] += s * b.d[l];
}

bool is_constant(const Dual& a) {
  return std::ranges::all_of(a.d, [](double d) { return d == 0.0; });
}

}  // namespace

Differential::Differential(const Instant& instant)
    : instant_(instant),
      motions_(instant),
      model_(as_dual(instant.model())),
      scaled_(model_),
      constraints_(model_),
      induced_(instant.model()),
      held_(blank_position(instant.model())),
      induction_(induced_.found().modes.size()) {
  has_belt_ = std::ranges::any_of(model_.joints, [](const auto& joint) { return joint.kind == JointKind::belt; });
  const std::size_t size = constraints_.columns();
  for (auto* x : {&q_, &velocity_, &acceleration_}) x->resize(size + 3);
  for (auto* x : {&right_, &multipliers_}) x->resize(size);
  for (auto* x : {&powers_, &multiplier_}) x->resize(size);
  for (auto* x : {&poses_, &velocities_, &accelerations_}) x->resize(model_.links.size());
  no_targets_.resize(model_.drivers.size());
  reactions_.resize(model_.joints.size());
  effort_.resize(model_.drivers.size());
  for (const auto& source : induced_.sources()) sources_.push_back({.joint = source.joint, .first = source.first});
  for (const auto& mode : induced_.found().modes) modes_.push_back({.joint = mode.joint, .at = {}, .force = {}});
  for (auto* x : {&amounts_, &induced_amounts_}) x->resize(modes_.size());
  change_.resize(modes_.size());
}

bool Differential::start(bool statics) {
  statics_ = statics;
  motions_.find(instant_);
  for (std::size_t n = 0; n < model_.loads.size(); ++n) {  // they may vary over the cycle
    const LoadNow& now = instant_.at().loads[n];
    model_.loads[n].force = {now.force.x, now.force.y};
    model_.loads[n].moment = now.moment;
  }
  const double length = instant_.length();
  for (std::size_t row = 0; row < powers_.size(); ++row) {
    double sum = 0.0;
    for (const ActiveForce& force : instant_.external()) {
      sum += power(force, motions_.velocity(row, force.link));
    }
    powers_[row] = sum / (length * length);
  }
  find_multipliers({});
  if (modes_.empty()) return true;
  held_ = instant_.at();
  const auto find_reactions = [&](const Induced& modes) {
    find_multipliers(modes);
    share_out(instant_.model(), instant_.constraints(), multiplier_, length, held_.reactions, held_.effort);
  };
  return induced_.solve(held_, find_reactions) && find_induction();
}

// Each from the power of all loads when only its constraint is released.
void Differential::find_multipliers(const Induced& modes) {
  const double area = instant_.length() * instant_.length();
  for (std::size_t row = 0; row < multiplier_.size(); ++row) {
    multiplier_[row] = -powers_[row];
    for (std::size_t m = 0; m < modes.modes.size(); ++m) {
      multiplier_[row] -= modes.amounts[m] * mode_power(modes.modes[m], row) / area;
    }
  }
}

double Differential::mode_power(const InducedMode& mode, std::size_t row) const {
  const Joint& joint = instant_.model().joints[mode.joint];
  const auto on = [&](int link) {
    if (link == ground) return 0.0;
    const auto k = static_cast<std::size_t>(link);
    const Pose& pose = instant_.at().pose[k];
    const Pose velocity = motions_.velocity(row, k);
    return dot(mode.force, point_velocity(velocity, mode.at - Vec{pose.x, pose.y})) + mode.couple * velocity.phi;
  };
  return on(joint.i) - on(joint.j);
}

// Amounts induced in turn by the reactions that the amounts cause: the equations for changes of the amounts.
bool Differential::find_induction() {
  const std::size_t count = modes_.size();
  place();
  find_motion();
  move_induced();
  for (std::size_t first = 0; first < count; first += lanes) {
    for (std::size_t m = 0; m < count; ++m) {
      amounts_[m] = induced_.found().amounts[m];
      if (m >= first && m < first + lanes) amounts_[m].d[m - first] = 1.0;
    }
    find_forces();
    induce();
    for (std::size_t m = first; m < std::min(first + lanes, count); ++m) {
      for (std::size_t r = 0; r < count; ++r) {
        induction_.at(r, m) = (r == m ? 1.0 : 0.0) - induced_amounts_[r].d[m - first];
      }
    }
  }
  return induction_.factor();
}

void Differential::find() {
  place();
  find_motion();
  if (!modes_.empty()) find_induced_forces();
  find_forces();
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    BasicReaction<Dual>& reaction = reactions_[modes_[m].joint];
    reaction.force = reaction.force + amounts_[m] * modes_[m].force;
    reaction.couple += amounts_[m] * modes_[m].couple;
  }
}

void Differential::take_position() {
  const Position& at = instant_.at();
  take(at.pose, instant_.length(), q_);
  take(at.velocity, instant_.length(), velocity_);
  take(at.acceleration, instant_.length(), acceleration_);
}

// The change of the places, by the opening of the joints where the links are.
void Differential::place() {
  take_position();
  take_phases(model_);
  for (std::size_t k = 0; k < model_.joints.size(); ++k) {
    model_.joints[k].phase.value = instant_.model().joints[k].phase;  // to the bit
  }
  scaled_ = model_;
  change_unit_of_length(scaled_, instant_.length());
  constraints_.take_dimensions(scaled_);
  constraints_.place(q_, no_targets_);
  constraints_.count_turns();
  constraints_.place(q_, no_targets_);
  // The second step is for belts, whose Jacobian assumes the centre distance that other joints keep.
  for (int step = 0; step < (has_belt_ ? 2 : 1); ++step) {
    subtract_solution(constraints_.residual(), q_);
    constraints_.place(q_, no_targets_);
  }
  store_motion(q_, poses_);
}

void Differential::find_motion() {
  std::ranges::fill(right_, Dual(0.0));
  take_product(velocity_);
  subtract_solution(right_, velocity_);
  constraints_.centripetal(velocity_, right_);
  for (Dual& r : right_) r = -r;
  take_product(acceleration_);
  subtract_solution(right_, acceleration_);
  store_motion(velocity_, velocities_);
  store_motion(acceleration_, accelerations_);
}

void Differential::move_induced() {
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    BasicInducedSource<Dual>& source = sources_[k];
    const auto& joint = model_.joints[source.joint];
    source.shape = shape_of(joint);
    source.tendency = induced_.sources()[k].tendency;  // a sense does not change with a dimension
    set_up(joint, poses_, velocities_, source);
    set_modes(joint, source, std::span(modes_).subspan(source.first));
  }
}

void Differential::find_forces() {
  required_forces(scaled_, constraints_, velocity_, acceleration_, statics_, right_);
  supply_springs(scaled_, constraints_, velocity_, right_);
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    take_from_required(modes_[m], amounts_[m], instant_.length(), constraints_.pairs()[modes_[m].joint], q_, right_);
  }
  take_transposed_product();
  for (std::size_t row = 0; row < multipliers_.size(); ++row) {
    multipliers_[row] = multiplier_[row];
    const std::span<const double> motion = motions_.of(row);
    for (std::size_t c = 0; c < motion.size(); ++c) add(multipliers_[row], motion[c], right_[c]);
  }
  share_out(model_, constraints_, multipliers_, instant_.length(), reactions_, effort_);
}

// First the change of the induced forces at constant amounts, then the amounts consistent with it.
void Differential::find_induced_forces() {
  move_induced();
  for (std::size_t m = 0; m < amounts_.size(); ++m) amounts_[m] = induced_.found().amounts[m];
  find_forces();
  induce();
  for (std::size_t l = 0; l < lanes; ++l) {
    for (std::size_t m = 0; m < amounts_.size(); ++m) change_[m] = induced_amounts_[m].d[l];
    induction_.solve(change_);
    for (std::size_t m = 0; m < amounts_.size(); ++m) amounts_[m].d[l] = change_[m];
  }
}

void Differential::induce() {
  for (const auto& source : sources_) {
    mechanism::induce(model_.joints[source.joint], source, reactions_[source.joint], 1.0,
                      std::span(induced_amounts_).subspan(source.first));
  }
}

void Differential::subtract_solution(std::span<const Dual> right, std::span<Dual> x) const {
  for (std::size_t row = 0; row < right.size(); ++row) {
    if (is_constant(right[row])) continue;
    const std::span<const double> motion = motions_.of(row);
    for (std::size_t c = 0; c < motion.size(); ++c) add(x[c], -motion[c], right[row]);
  }
}

// J x, of which the values do not count.
void Differential::take_product(std::span<const Dual> x) {
  const auto pattern = constraints_.pattern();
  const auto jacobian = constraints_.jacobian();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    add(right_[static_cast<std::size_t>(pattern[n].row)], x[static_cast<std::size_t>(pattern[n].column)].value,
        jacobian[n]);
  }
}

void Differential::take_transposed_product() {
  const auto pattern = constraints_.pattern();
  const auto jacobian = constraints_.jacobian();
  for (std::size_t n = 0; n < pattern.size(); ++n) {
    add(right_[static_cast<std::size_t>(pattern[n].column)], -multiplier_[static_cast<std::size_t>(pattern[n].row)],
        jacobian[n]);
  }
}

void Differential::store_motion(std::span<const Dual> x, std::span<BasicPose<Dual>> poses) const {
  const Dual length = instant_.length();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    poses[k] = {length * x[3 * k], length * x[3 * k + 1], x[3 * k + 2]};
  }
}

void Differential::store(std::size_t lane, Position& out) const {
  const auto pose = [&](const BasicPose<Dual>& p) { return Pose{p.x.d[lane], p.y.d[lane], p.phi.d[lane]}; };
  const auto vec = [&](const BasicVec<Dual>& v) { return Vec{v.x.d[lane], v.y.d[lane]}; };
  std::ranges::transform(poses_, out.pose.begin(), pose);
  std::ranges::transform(velocities_, out.velocity.begin(), pose);
  std::ranges::transform(accelerations_, out.acceleration.begin(), pose);
  std::ranges::transform(reactions_, out.reactions.begin(), [&](const BasicReaction<Dual>& r) {
    return Reaction{vec(r.at), vec(r.force), r.couple.d[lane]};
  });
  std::ranges::transform(effort_, out.effort.begin(), [&](const Dual& e) { return e.d[lane]; });
}

}  // namespace loadpath::mechanism
