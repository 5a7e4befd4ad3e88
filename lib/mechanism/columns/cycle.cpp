#include "lib/mechanism/columns/cycle.hpp"

#include "lib/mechanism/groups/chain_output.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace loadpath::mechanism {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::size_t whole_blocks(std::size_t positions) { return (positions + lane_count - 1) / lane_count * lane_count; }

bool has_motion(Status status) { return status == Status::closed || status == Status::jams; }

void copy(const Lanes<lane_count>& lanes, double* to) { std::memcpy(to, lanes.data(), sizeof lanes); }

}  // namespace

CycleColumns::CycleColumns(const Model& model, std::size_t positions, Kept kept)
    : positions_(positions),
      room_(whole_blocks(positions)),
      kept_(kept),
      joints_(model.joints.size()),
      drivers_(model.drivers.size()),
      links_(model.links.size()),
      first_effort_(kept.forces ? 3 * joints_ : 0),
      first_pose_(first_effort_ + (kept.forces ? drivers_ : 0)),
      first_velocity_(first_pose_ + (kept.poses ? 3 * links_ : 0)),
      first_acceleration_(first_velocity_ + (kept.velocities ? 3 * links_ : 0)),
      first_pin_(first_acceleration_ + (kept.accelerations ? 3 * links_ : 0)),
      system_(model),
      model_(model),
      position_(blank_position(model)),
      courses_(model.loads.size()),
      columns_((first_pin_ + (kept.pins ? 2 * joints_ : 0)) * room_),
      status_(positions),
      poses_(links_),
      pins_(joints_),
      least_sine_(room_) {
  assemble();
  const Chain* const chain = system_.chain();
  if (chain == nullptr) return;
  now_.emplace_back(*chain);
  offsets_.resize(chain->steps.size());
  course_.resize(chain->steps.size());
  for (std::size_t s = 0; s < course_.size(); ++s) {
    if (chain->steps[s].driver == none) continue;
    for (auto* x :
         {&course_[s].value, &course_[s].speed, &course_[s].acceleration, &course_[s].cosine, &course_[s].sine})
      x->resize(room_);
  }
  drives_.resize(positions * drivers_, {no_number});
  slides_ = std::ranges::any_of(model.drivers, [](const Driver& d) { return d.kind == Driver::Kind::linear; });
}

Status CycleColumns::take(const Model& model) {
  system_.take_dimensions(model);
  model_ = model;
  std::ranges::fill(courses_, std::span<const LoadNow>());
  return assemble();
}

Status CycleColumns::assemble() {
  const Status status = system_.assemble();
  assembled_ = status == Status::closed;
  return status;
}

bool CycleColumns::is_regular_at_start() {
  if (!assembled_ || system_.chain() == nullptr) return false;
  std::vector<Drive> here(drivers_);
  for (std::size_t d = 0; d < drivers_; ++d) here[d].coordinate = coordinate(d);
  return system_.solve(here, position_) == Status::closed && !system_.followed_in_steps();
}

Status CycleColumns::solve(std::span<const Drive> drives, bool statics) {
  in_lanes_ = false;
  if (positions_ == 0) return Status::closed;
  if (!assembled_) {
    system_.take_dimensions(model_);
    assemble();
  }
  assembled_ = false;
  std::ranges::fill(status_, Status::does_not_close);
  status_[0] = solve_alone(drives, 0, statics);
  if (status_[0] != Status::closed || !solve_in_lanes(drives, statics)) return go_on_alone(drives, statics);
  write(0, true, true);
  std::ranges::fill(status_, Status::closed);
  return Status::closed;
}

Status CycleColumns::solve_alone(std::span<const Drive> drives, std::size_t position, bool statics) {
  for (std::size_t n = 0; n < courses_.size(); ++n) {
    const Load& given = model_.loads[n];
    const LoadNow load = courses_[n].empty() ? LoadNow{given.force, given.moment} : courses_[n][position];
    system_.set_load(n, load.force, load.moment);
  }
  return system_.solve(drives.subspan(position * drivers_, drivers_), position_, statics);
}

/// The first position is solved.
Status CycleColumns::go_on_alone(std::span<const Drive> drives, bool statics) {
  bool passes = false;
  Status ended = Status::closed;
  for (std::size_t k = 0; k < positions_; ++k) {
    if (k > 0 && ended == Status::closed) status_[k] = solve_alone(drives, k, statics);
    write(k, has_motion(status_[k]), status_[k] == Status::closed);
    if (ended != Status::closed || has_motion(status_[k])) {
      passes = false;
      continue;
    }
    if (status_[k] == Status::singular && !passes) {
      passes = true;
      continue;
    }
    ended = status_[k];
  }
  return ended;
}

void CycleColumns::write(std::size_t column, std::size_t position, const Pose& frame) {
  *at(column, position) = frame.x;
  *at(column + 1, position) = frame.y;
  *at(column + 2, position) = frame.phi;
}

void CycleColumns::write(std::size_t position, bool has_motion, bool has_forces) {
  const auto number = [](bool there, double x) { return there ? x : no_number; };
  for (std::size_t j = 0; kept_.forces && j < joints_; ++j) {
    const Reaction& r = position_.reactions[j];
    write(3 * j, position,
          {number(has_forces, r.force.x), number(has_forces, r.force.y), number(has_forces, r.couple)});
  }
  for (std::size_t d = 0; kept_.forces && d < drivers_; ++d)
    *at(first_effort_ + d, position) = number(has_forces, position_.effort[d]);
  constexpr Pose nowhere{no_number, no_number, no_number};
  for (std::size_t k = 0; k < links_; ++k) {
    if (kept_.poses) write(first_pose_ + 3 * k, position, has_motion ? position_.pose[k] : nowhere);
    if (kept_.velocities) write(first_velocity_ + 3 * k, position, has_motion ? position_.velocity[k] : nowhere);
    if (kept_.accelerations)
      write(first_acceleration_ + 3 * k, position, has_motion ? position_.acceleration[k] : nowhere);
  }
  for (std::size_t j = 0; kept_.pins && j < joints_; ++j)
    pins_[j].at = has_motion ? position_.reactions[j].at : Vec{no_number, no_number};
  write_pins(position);
}

void CycleColumns::write_pins(std::size_t position) {
  for (std::size_t j = 0; kept_.pins && j < joints_; ++j) {
    *at(first_pin_ + 2 * j, position) = pins_[j].at.x;
    *at(first_pin_ + 2 * j + 1, position) = pins_[j].at.y;
  }
}

/// The frames of a link from its three columns.
void CycleColumns::read_frames(std::size_t column, std::size_t link, std::size_t first, std::vector<Pose> Position::*of,
                               std::span<Position> out) const {
  const double *const x = &columns_[column * room_ + first], *const y = x + room_, *const phi = y + room_;
  for (std::size_t k = 0; k < out.size(); ++k) (out[k].*of)[link] = {x[k], y[k], phi[k]};
}

void CycleColumns::read(std::size_t first, const Kept& what, std::span<Position> out) const {
  for (std::size_t k = 0; k < links_; ++k) {
    if (what.poses) read_frames(first_pose_ + 3 * k, k, first, &Position::pose, out);
    if (what.velocities) read_frames(first_velocity_ + 3 * k, k, first, &Position::velocity, out);
    if (what.accelerations) read_frames(first_acceleration_ + 3 * k, k, first, &Position::acceleration, out);
  }
  for (std::size_t j = 0; what.forces && j < joints_; ++j) {
    const Vectors acting = force(j);
    const auto turning = couple(j);
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k].reactions[j] = {
          .at = {}, .force = {acting.x[first + k], acting.y[first + k]}, .couple = turning[first + k]};
  }
  for (std::size_t j = 0; what.pins && j < joints_; ++j) {
    const Vectors pins = pin(j);
    for (std::size_t k = 0; k < out.size(); ++k) out[k].reactions[j].at = {pins.x[first + k], pins.y[first + k]};
  }
  for (std::size_t d = 0; what.forces && d < drivers_; ++d) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k].effort[d] = effort(d)[first + k];
  }
  for (std::size_t n = 0; n < courses_.size(); ++n) {
    const LoadNow same{model_.loads[n].force, model_.loads[n].moment};
    for (std::size_t k = 0; k < out.size(); ++k) out[k].loads[n] = courses_[n].empty() ? same : courses_[n][first + k];
  }
}

/// False if some position is near a change point.
bool CycleColumns::solve_in_lanes(std::span<const Drive> drives, bool statics) {
  const Chain* const chain = system_.chain();
  if (chain == nullptr || now_.empty()) return false;
  take_drives(drives);
  if (!moves_little_) return false;
  std::ranges::copy(system_.sides(), now_[0].sides.begin());
  std::ranges::copy(position_.pose, poses_.begin());
  for (std::size_t n = 0; n < model_.loads.size(); ++n) {
    now_[0].loads[n].force.x.fill(model_.loads[n].force.x);
    now_[0].loads[n].force.y.fill(model_.loads[n].force.y);
    now_[0].loads[n].moment.fill(model_.loads[n].moment);
  }
  for (std::size_t first = 0; first < positions_; first += lane_count) {
    set_lanes(first);
    if (!solve_lanes(*chain, now_[0], statics)) return false;
    write_lanes(first);
  }
  in_lanes_ = true;
  return true;
}

/// Recompute only if the drives differ from the previous cycle; in most sweeps they do not.
void CycleColumns::take_drives(std::span<const Drive> drives) {
  const Chain& chain = *system_.chain();
  bool others = std::memcmp(drives.data(), drives_.data(), drives_.size() * sizeof(Drive)) != 0;
  for (std::size_t s = 0; s < offsets_.size(); ++s) {
    others = others || offsets_[s] != chain.steps[s].offset;
    offsets_[s] = chain.steps[s].offset;
  }
  if (others || slides_) find_least_sines(drives);
  if (!others) return;
  std::ranges::copy(drives, drives_.begin());
  for (std::size_t s = 0; s < course_.size(); ++s) {
    if (chain.steps[s].driver != none) take_course(drives, chain.steps[s], course_[s]);
  }
}

std::span<const Drive> CycleColumns::drives_at(std::span<const Drive> drives, std::size_t position) const {
  return drives.subspan(std::min(position, positions_ - 1) * drivers_, drivers_);
}

void CycleColumns::find_least_sines(std::span<const Drive> drives) {
  least_sine_[0] = near_change;  // no change: already at the first position
  moves_little_ = true;
  for (std::size_t k = 1; k < room_; ++k) {
    const double change = system_.change(drives_at(drives, k - 1), drives_at(drives, k));
    least_sine_[k] = near_change + change;
    moves_little_ = moves_little_ && change < longest_way;
  }
}

void CycleColumns::take_course(std::span<const Drive> drives, const ChainStep& step, Course& course) const {
  DriveLanes<1> drive;
  for (std::size_t k = 0; k < room_; ++k) {
    set_drive(step, drives_at(drives, k)[step.driver], 0, drive);
    course.value[k] = drive.value[0];
    course.speed[k] = drive.speed[0];
    course.acceleration[k] = drive.acceleration[0];
    course.cosine[k] = drive.turned.cosine[0];
    course.sine[k] = drive.turned.sine[0];
  }
}

void CycleColumns::set_lanes(std::size_t first) {
  const auto load = [&](const std::vector<double>& from, Lanes<lane_count>& to) {
    std::memcpy(to.data(), from.data() + first, sizeof to);
  };
  for (std::size_t s = 0; s < course_.size(); ++s) {
    if (course_[s].value.empty()) continue;
    DriveLanes<lane_count>& drive = now_[0].drives[s];
    load(course_[s].value, drive.value);
    load(course_[s].speed, drive.speed);
    load(course_[s].acceleration, drive.acceleration);
    load(course_[s].cosine, drive.turned.cosine);
    load(course_[s].sine, drive.turned.sine);
  }
  load(least_sine_, now_[0].least_sine);
  set_loads(first);
}

void CycleColumns::set_loads(std::size_t first) {
  for (std::size_t n = 0; n < courses_.size(); ++n) {
    if (courses_[n].empty()) continue;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const LoadNow& load = courses_[n][std::min(first + lane, positions_ - 1)];
      now_[0].loads[n].force.set(lane, load.force);
      now_[0].loads[n].moment[lane] = load.moment;
    }
  }
}

void CycleColumns::write_lanes(std::size_t first) {
  for (std::size_t j = 0; kept_.forces && j < joints_; ++j) {
    const ReactionLanes<lane_count>& r = now_[0].reactions[j];
    copy(r.force.x, at(3 * j, first));
    copy(r.force.y, at(3 * j + 1, first));
    copy(r.couple, at(3 * j + 2, first));
  }
  for (std::size_t d = 0; kept_.forces && d < drivers_; ++d) copy(now_[0].effort[d], at(first_effort_ + d, first));
  if (kept_.poses || kept_.velocities || kept_.accelerations) write_motion(first);
  for (std::size_t lane = 0; kept_.pins && lane < lane_count; ++lane) {
    take_pins(*system_.chain(), now_[0], lane, pins_);
    write_pins(first + lane);
  }
}

void CycleColumns::write_motion(std::size_t first) {
  const Chain& chain = *system_.chain();
  for (std::size_t lane = 0; kept_.poses && kept_.angles && lane < lane_count; ++lane) {
    if (first + lane > 0) follow_poses(chain, now_[0], lane, poses_);
    for (std::size_t k = 0; k < links_; ++k) write(first_pose_ + 3 * k, first + lane, poses_[k]);
  }
  for (std::size_t k = 0; k < links_; ++k) {
    if (kept_.poses && !kept_.angles) {
      write_frames(first_pose_ + 3 * k, first, [&](std::size_t lane) {
        const Vec place = place_of(chain, now_[0], k, lane);
        return Pose{place.x, place.y, no_number};
      });
    }
    if (kept_.velocities)
      write_frames(first_velocity_ + 3 * k, first,
                   [&](std::size_t lane) { return velocity_of(chain, now_[0], k, lane); });
    if (kept_.accelerations)
      write_frames(first_acceleration_ + 3 * k, first,
                   [&](std::size_t lane) { return acceleration_of(chain, now_[0], k, lane); });
  }
}

template <class FrameOf>
void CycleColumns::write_frames(std::size_t column, std::size_t first, FrameOf frame_of) {
  double* const x = at(column, first);
  double* const y = at(column + 1, first);
  double* const phi = at(column + 2, first);
  each_lane<lane_count>([&](std::size_t lane) {
    const Pose frame = frame_of(lane);
    x[lane] = frame.x;
    y[lane] = frame.y;
    phi[lane] = frame.phi;
  });
}

}  // namespace loadpath::mechanism
