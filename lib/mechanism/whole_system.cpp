#include "lib/mechanism/whole_system.hpp"

#include "lib/mechanism/continuation.hpp"
#include "lib/mechanism/kinematics.hpp"
#include "lib/mechanism/kinetostatics.hpp"

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
        goal(given.drivers.size()) {
    for (auto* x : {&velocity, &acceleration, &multipliers}) x->resize(continuation.q().size());
  }

  [[nodiscard]] double unit(std::size_t driver) const { return linear(model.drivers[driver]) ? length : 1.0; }
  [[nodiscard]] std::span<double> unknowns(std::vector<double>& x) const {
    return {x.data(), continuation.constraints().columns()};
  }
  void find_velocity(std::span<const Drive> drives);
  void find_acceleration(std::span<const Drive> drives);
  void find_multipliers(bool statics);
  void store(std::span<const double> x, std::vector<Pose>& poses) const;

  Model model;    // as given
  double length;  // the unit of length inside
  Model scaled;
  Continuation continuation;
  std::vector<double> goal, velocity, acceleration, multipliers;
};

WholeSystem::WholeSystem(const Model& model) : work_(std::make_unique<Work>(model)) {}
WholeSystem::~WholeSystem() = default;
WholeSystem::WholeSystem(WholeSystem&&) noexcept = default;

Status WholeSystem::assemble() { return work_->continuation.assemble(work_->scaled); }

double WholeSystem::coordinate(std::size_t driver) const {
  return work_->unit(driver) * work_->continuation.drives()[driver];
}

Status WholeSystem::move(std::span<const Drive> drives) {
  for (std::size_t k = 0; k < drives.size(); ++k) work_->goal[k] = drives[k].coordinate / work_->unit(k);
  return work_->continuation.move(work_->goal);
}

Status WholeSystem::solve(std::span<const Drive> drives, Position& out, bool statics) {
  if (const Status status = move(drives); status != Status::closed) return status;
  Work& w = *work_;
  w.find_velocity(drives);
  w.find_acceleration(drives);
  w.find_multipliers(statics);
  w.store(w.continuation.q(), out.pose);
  w.store(w.velocity, out.velocity);
  w.store(w.acceleration, out.acceleration);
  const Constraints& constraints = w.continuation.constraints();
  share_out(w.model, constraints, w.continuation.q(), w.multipliers, w.length, out.reactions, out.effort);
  return Status::closed;
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

void WholeSystem::Work::find_multipliers(bool statics) {
  required_forces(scaled, continuation.constraints(), velocity, acceleration, statics, multipliers);
  continuation.factors().solve_transposed(unknowns(multipliers));
}

void WholeSystem::Work::store(std::span<const double> x, std::vector<Pose>& poses) const {
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

WholeSystem::Gap WholeSystem::gap() const {
  Gap gap = work_->continuation.gap();
  gap.size *= work_->length;
  return gap;
}

double WholeSystem::condition() const {
  return work_->continuation.factors().reciprocal_condition(work_->continuation.constraints().jacobian());
}

}  // namespace loadpath::mechanism
