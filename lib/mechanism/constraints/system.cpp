#include "lib/mechanism/constraints/system.hpp"

#include "lib/mechanism/constraints/continuation.hpp"
#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/mechanism/equations/kinetostatics.hpp"
#include "lib/mechanism/forces/induced.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

bool linear(const Driver& driver) { return driver.kind == Driver::Kind::linear; }

}  // namespace

struct WholeSystem::Work {
  explicit Work(const Model& given)
      : model(given),
        length(characteristic_length(given)),
        scaled(in_unit_of_length(given, length)),
        continuation(scaled),
        induced(model),
        goal(given.drivers.size()) {
    for (auto* x : {&velocity, &acceleration, &multipliers}) x->resize(continuation.q().size());
  }

  [[nodiscard]] double unit(std::size_t driver) const { return linear(model.drivers[driver]) ? length : 1.0; }
  [[nodiscard]] std::span<double> unknowns(std::vector<double>& x) const {
    return {x.data(), continuation.constraints().columns()};
  }
  void find_tendency(std::span<const Drive> drives, Position& out);
  void find_velocity(std::span<const Drive> drives);
  void find_acceleration(std::span<const Drive> drives);
  bool find_all_forces(bool statics, Position& out);
  void find_forces(bool statics, const Induced& modes, Position& out);
  void store(std::span<const double> x, std::span<Pose> poses) const;

  Model model;    // as given
  double length;  // the unit of length inside
  Model scaled;
  Continuation continuation;
  InducedForces induced;
  std::vector<double> goal, velocity, acceleration, multipliers;
};

WholeSystem::WholeSystem(const Model& model) : work_(std::make_unique<Work>(model)) {}
WholeSystem::~WholeSystem() = default;
WholeSystem::WholeSystem(WholeSystem&&) noexcept = default;

void WholeSystem::take_dimensions(const Model& model, double length) {
  Work& w = *work_;
  w.model = w.scaled = model;
  w.length = length;
  change_unit_of_length(w.scaled, length);
  w.continuation.take_dimensions(w.scaled);
}

Status WholeSystem::assemble() { return work_->continuation.assemble(work_->scaled); }

double WholeSystem::coordinate(std::size_t driver) const {
  return work_->unit(driver) * work_->continuation.drives()[driver];
}

void WholeSystem::hold(std::span<const Pose> poses, std::span<const Drive> drives) {
  Work& w = *work_;
  for (std::size_t k = 0; k < drives.size(); ++k) w.goal[k] = drives[k].coordinate / w.unit(k);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    w.scaled.links[k].pose = {poses[k].x / w.length, poses[k].y / w.length, poses[k].phi};
  }
  w.continuation.hold(w.scaled, w.goal);
}

void WholeSystem::store_poses(std::span<Pose> poses) const { work_->store(work_->continuation.q(), poses); }

Status WholeSystem::move(std::span<const Drive> drives) {
  for (std::size_t k = 0; k < drives.size(); ++k) work_->goal[k] = drives[k].coordinate / work_->unit(k);
  return work_->continuation.move(work_->goal);
}

Status WholeSystem::solve(std::span<const Drive> drives, Position& out, bool statics) {
  if (const Status status = move(drives); status != Status::closed) return status;
  Work& w = *work_;
  if (!moves(drives)) w.find_tendency(drives, out);
  w.find_velocity(drives);
  w.find_acceleration(drives);
  for (std::size_t n = 0; n < out.loads.size(); ++n) out.loads[n] = {w.model.loads[n].force, w.model.loads[n].moment};
  w.store(w.continuation.q(), out.pose);
  w.store(w.velocity, out.velocity);
  if (moves(drives)) std::ranges::copy(out.velocity, out.tendency.begin());
  w.store(w.acceleration, out.acceleration);
  return w.find_all_forces(statics, out) ? Status::closed : Status::jams;
}

void WholeSystem::Work::find_tendency(std::span<const Drive> drives, Position& out) {
  std::ranges::fill(velocity, 0.0);
  const std::size_t row = continuation.constraints().first_driver_row();
  for (std::size_t k = 0; k < drives.size(); ++k) velocity[row + k] = drives[k].impending / unit(k);
  continuation.factors().solve(unknowns(velocity));
  store(velocity, out.tendency);
}

void WholeSystem::Work::find_velocity(std::span<const Drive> drives) {
  std::ranges::fill(velocity, 0.0);
  const std::size_t row = continuation.constraints().first_driver_row();
  for (std::size_t k = 0; k < drives.size(); ++k) velocity[row + k] = drives[k].speed / unit(k);
  continuation.factors().solve(unknowns(velocity));
}

void WholeSystem::Work::find_acceleration(std::span<const Drive> drives) {
  continuation.constraints().centripetal(velocity, acceleration);
  const std::size_t row = continuation.constraints().first_driver_row();
  for (std::size_t k = 0; k < drives.size(); ++k) acceleration[row + k] += drives[k].acceleration / unit(k);
  continuation.factors().solve(unknowns(acceleration));
}

bool WholeSystem::Work::find_all_forces(bool statics, Position& out) {
  if (!induced.none()) {
    return induced.solve(out, [&](const Induced& modes) { find_forces(statics, modes, out); });
  }
  find_forces(statics, {}, out);
  return true;
}

void WholeSystem::Work::find_forces(bool statics, const Induced& modes, Position& out) {
  const Constraints& constraints = continuation.constraints();
  required_forces(scaled, constraints, velocity, acceleration, statics, multipliers);
  supply_springs(scaled, constraints, velocity, multipliers);
  for (std::size_t m = 0; m < modes.modes.size(); ++m) {
    const InducedMode& mode = modes.modes[m];
    take_from_required(mode, modes.amounts[m], length, constraints.pairs()[mode.joint], continuation.q(), multipliers);
  }
  continuation.factors().solve_transposed(unknowns(multipliers));
  share_out(model, constraints, multipliers, length, out.reactions, out.effort);
}

void WholeSystem::Work::store(std::span<const double> x, std::span<Pose> poses) const {
  for (std::size_t k = 0; k < poses.size(); ++k) poses[k] = {length * x[3 * k], length * x[3 * k + 1], x[3 * k + 2]};
}

Position WholeSystem::blank() const { return blank_position(work_->model); }

void WholeSystem::set_load(std::size_t load, Vec force, double moment) {
  const double length = work_->length;
  work_->model.loads[load].force = force;
  work_->model.loads[load].moment = moment;
  work_->scaled.loads[load].force = (1.0 / length) * force;
  work_->scaled.loads[load].moment = moment / (length * length);
}

Gap WholeSystem::gap() const {
  Gap gap = work_->continuation.gap();
  gap.size *= work_->length;
  return gap;
}

double WholeSystem::condition() const {
  return work_->continuation.factors().reciprocal_condition(work_->continuation.constraints().jacobian());
}

}  // namespace loadpath::mechanism
