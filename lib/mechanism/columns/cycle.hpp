// A cycle of positions as columns of numbers, for one mechanism after another of the same structure: sweeps of
// lengths, masses and loads. Constructed once; `take` and `solve` allocate nothing if the mechanism is a chain of
// drives and dyads without springs and friction (chain.hpp), and solve it eight positions at once.
//
// Every position has the bits that GroupSystem gives, one position after the other from the assembly of the stated
// poses: if small steps are needed somewhere, or the mechanism is not such a chain, GroupSystem solves the entire
// cycle.
#pragma once

#include "lib/mechanism/columns/chain_lanes.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The results kept of every position: joint forces with the drives' efforts, and the motion of the links' frames.
struct Kept {
  bool forces = true;
  bool poses = false;
  bool angles = true;  // angles of the poses; otherwise they are NaN
  bool velocities = false;
  bool accelerations = false;
  bool pins = false;  // points of action of the joints' forces
};

class CycleColumns {
 public:
  /// The model has passed `diagnose`, as have those that are taken later.
  CycleColumns(const Model& model, std::size_t positions, Kept kept = {});

  /// A model of the same structure, and closes it near its stated poses. Load curves are forgotten.
  Status take(const Model& model);
  /// The drivers' coordinates of that assembly.
  [[nodiscard]] double coordinate(std::size_t driver) const { return system_.coordinate(driver); }
  /// Whether that assembly keeps clear of change points, of a chain of dyads.
  [[nodiscard]] bool is_regular_at_start();
  /// A load as it is at every position, in the axes that it has; it must outlive the next `solve`.
  void vary_load(std::size_t load, std::span<const LoadNow> course) { courses_[load] = course; }

  /// From the assembly through the positions; `drives`: all of the first position, all of the second... Positions
  /// that do not close, and the forces of jamming ones, are NaN. Returns the first status that ends the cycle, and
  /// those of the positions: a single singular one is skipped.
  Status solve(std::span<const Drive> drives, bool statics = false);
  [[nodiscard]] std::span<const Status> status() const { return status_; }
  /// Whether the last cycle was solved in lanes.
  [[nodiscard]] bool in_lanes() const { return in_lanes_; }

  // Columns over the positions, as selected: of link j on link i of a joint, N, N m at its pin; N m or N on link i of
  // a driver; m, rad and their rates.
  struct Vectors {
    std::span<const double> x, y;
  };
  struct Frames {
    std::span<const double> x, y, phi;
  };
  [[nodiscard]] Vectors force(std::size_t joint) const { return {column(3 * joint), column(3 * joint + 1)}; }
  [[nodiscard]] std::span<const double> couple(std::size_t joint) const { return column(3 * joint + 2); }
  [[nodiscard]] std::span<const double> effort(std::size_t driver) const { return column(first_effort_ + driver); }
  [[nodiscard]] Frames pose(std::size_t link) const { return frames(first_pose_ + 3 * link); }
  [[nodiscard]] Frames velocity(std::size_t link) const { return frames(first_velocity_ + 3 * link); }
  [[nodiscard]] Frames acceleration(std::size_t link) const { return frames(first_acceleration_ + 3 * link); }
  [[nodiscard]] Vectors pin(std::size_t joint) const {
    return {column(first_pin_ + 2 * joint), column(first_pin_ + 2 * joint + 1)};
  }
  /// Positions from the first on as GroupSystem gives them, of a cycle that was solved in lanes: `what` of all that is
  /// kept. `out` is made by `blank_position`.
  void read(std::size_t first, const Kept& what, std::span<Position> out) const;
  /// The first position, in full.
  [[nodiscard]] const Position& first() const { return position_; }

 private:
  /// A drive of a step of the chain at all positions.
  struct Course {
    std::vector<double> value, speed, acceleration, cosine, sine;
  };

  [[nodiscard]] std::span<const double> column(std::size_t k) const { return {&columns_[k * room_], positions_}; }
  [[nodiscard]] Frames frames(std::size_t k) const { return {column(k), column(k + 1), column(k + 2)}; }
  [[nodiscard]] double* at(std::size_t column, std::size_t position) { return &columns_[column * room_ + position]; }

  Status assemble();
  Status solve_alone(std::span<const Drive> drives, std::size_t position, bool statics);
  Status go_on_alone(std::span<const Drive> drives, bool statics);
  void write(std::size_t position, bool has_motion, bool has_forces);
  void write(std::size_t column, std::size_t position, const Pose& frame);
  void write_pins(std::size_t position);
  void read_frames(std::size_t column, std::size_t link, std::size_t first, std::vector<Pose> Position::*of,
                   std::span<Position> out) const;

  bool solve_in_lanes(std::span<const Drive> drives, bool statics);
  void take_drives(std::span<const Drive> drives);
  [[nodiscard]] std::span<const Drive> drives_at(std::span<const Drive> drives, std::size_t position) const;
  void find_least_sines(std::span<const Drive> drives);
  void take_course(std::span<const Drive> drives, const ChainStep& step, Course& course) const;
  void set_lanes(std::size_t first);
  void set_loads(std::size_t first);
  void write_lanes(std::size_t first);
  void write_motion(std::size_t first);
  /// A frame's three columns, from a function of the lane.
  template <class FrameOf>
  void write_frames(std::size_t column, std::size_t first, FrameOf frame_of);

  std::size_t positions_, room_;  // capacity: a multiple of the lane block
  Kept kept_;
  std::size_t joints_, drivers_, links_;
  std::size_t first_effort_, first_pose_, first_velocity_, first_acceleration_, first_pin_;
  GroupSystem system_;
  Model model_;
  Position position_;
  std::vector<std::span<const LoadNow>> courses_;
  std::vector<double> columns_;
  std::vector<Status> status_;
  bool in_lanes_ = false;
  bool slides_ = false;     // a drive slides: how far it moves goes by the mechanism's size
  bool assembled_ = false;  // and not moved since

  std::vector<ChainState<lane_count>> now_;  // one, of a chain
  std::vector<Pose> poses_;                  // poses of the last position written
  std::vector<Reaction> pins_;               // likewise
  std::vector<Drive> drives_;                // drives of the courses below
  std::vector<double> offsets_;              // and of their steps
  std::vector<Course> course_;               // motion of the steps
  std::vector<double> least_sine_;
  bool moves_little_ = true;  // from each position to the next
};

}  // namespace loadpath::mechanism
