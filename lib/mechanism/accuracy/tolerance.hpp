// The effect of tolerances of dimensions and masses, and of the clearance of pins, on an output of a mechanism at a
// position: the worst case, sum of |df/dx| t, and the root of the sum of squares. The derivatives are exact
// (sensitivity.hpp); where the tolerances exceed the range of linearity, corners are solved again instead.
#pragma once

#include "lib/mechanism/accuracy/parameter.hpp"
#include "lib/mechanism/accuracy/sensitivity.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// A number of a position.
struct Output {
  enum class Kind { x, y, phi, effort, reaction };
  Kind kind = Kind::phi;
  std::size_t index = 0;  // link; effort: driver; reaction (magnitude of its force): joint
  Vec point = {};         // point of the link, link frame, without tolerance: x and y

  /// m, rad, N m or N.
  [[nodiscard]] double value(const Position& at) const;
  /// For a change of the position, such as `Sensitivity::by` gives it. NaN for the magnitude of a force that
  /// vanishes, as it has no derivative.
  [[nodiscard]] double change(const Position& at, const Position& by) const;
};

/// A dimension within +-`half_width` of its value in the model, which is `sigmas` standard deviations. One dimension
/// of a drawing may change several numbers of the model: a point of a link those of all joints at it.
struct Tolerance {
  struct Term {
    Parameter parameter;
    double weight = 1.0;  // the parameter's change per unit of the dimension's
  };
  /// A point of a link that goes with the dimension, for outputs of its place.
  struct Moved {
    std::size_t link = 0;
    Vec point, by;  // link frame; `by` per unit of the dimension
  };
  std::vector<Term> terms;
  double half_width = 0.0;  // in the dimension's unit, >= 0
  double sigmas = 3.0;
  std::optional<Moved> moved = {};
};

/// Diametral clearance of a revolute joint. It acts like a massless link of half that length between the two centres:
/// - `along_reaction`: directed along the reaction, so that the output shifts by one amount, the same in worst case
///   and statistics; where the joint transmits no force, it is as `any_direction`;
/// - `any_direction`: in any direction; it adds its largest effect to the worst case.
/// Contributions of the rotation of that link to velocities, and so to inertia forces, are neglected.
struct Clearance {
  enum class Direction { along_reaction, any_direction };
  std::size_t joint = 0;
  double clearance = 0.0;  // m, >= 0
  Direction direction = Direction::along_reaction;
  double sigmas = 3.0;  // half the clearance in any direction, in standard deviations
};

struct OutputError {
  /// `singular`, `jams`: as in Sensitivity::find, without numbers. `does_not_close`: some corner cannot be assembled,
  /// and the errors are those of the others.
  Status status = Status::closed;
  double nominal = 0.0;
  double shift = 0.0;            // by clearances along reactions
  double worst_low = 0.0;        // <= 0, from nominal + shift
  double worst_high = 0.0;       // >= 0, likewise
  double deviation = 0.0;        // standard deviation, of independent numbers
  std::vector<double> shares{};  // df/dx t of each tolerance, signed; then of each clearance in any direction, >= 0
  /// How far the worst corners, solved again, are from the linear ones, over the linear worst case; infinite if one
  /// does not close or the linear worst case is nothing.
  double curvature = 0.0;
  /// Worst cases and deviation come from mechanisms solved again.
  bool recomputed = false;

  [[nodiscard]] double worst() const { return worst_high > -worst_low ? worst_high : -worst_low; }
  /// For this many standard deviations.
  [[nodiscard]] double statistical(double sigmas = 3.0) const { return sigmas * deviation; }
};

class ToleranceAnalysis {
 public:
  /// Criterion: the two worst corners according to the derivatives are always solved again. If they deviate from the
  /// linear result by more than this share of it, or do not close, the linearisation is poor, as near change points:
  /// then all corners are solved, up to 2^10 of them; beyond ten tolerances, the others stay at the worse of their
  /// own two ends. The deviation then comes from half the span of the two ends of each tolerance.
  static constexpr double most_curvature = 0.05;
  static constexpr std::size_t most_varied = 10;

  explicit ToleranceAnalysis(const Model& model);
  /// At a position of the model solved at these drives, with the loads of the position. A parameter without effect on
  /// the model counts nothing.
  [[nodiscard]] OutputError find(const Position& at, std::span<const Drive> drives, const Output& output,
                                 std::span<const Tolerance> tolerances, std::span<const Clearance> clearances = {},
                                 bool statics = false);

 private:
  class Corners;
  void add_linear(const Output& output, const Position& at, std::span<const Tolerance> tolerances,
                  OutputError& error) const;
  [[nodiscard]] double share(const Output& output, const Position& at, const Tolerance& tolerance) const;
  /// Clearances count by the derivatives also where corners are solved again.
  void add_clearances(const Output& output, const Position& at, std::span<const Clearance> clearances,
                      OutputError& error) const;
  static void recompute(const Corners& corners, OutputError& error);
  [[nodiscard]] Vec slope(const Output& output, const Position& at, std::size_t joint) const;

  Model model_;
  Sensitivity sensitivity_;
};

}  // namespace loadpath::mechanism
