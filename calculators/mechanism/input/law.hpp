// Laws of motion of the drives of a mechanism: by points over time, or by a formula of the time.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/numerics/spline.hpp"
#include "lib/quantity/expression/law.hpp"
#include "lib/text/issue.hpp"

#include <variant>
#include <vector>

namespace loadpath::planar {

/// The motion of one drive over time; also of a drive without a law, which is `empty`.
class DriveLaw {
 public:
  explicit DriveLaw(const planar::Crank& crank);
  explicit DriveLaw(const planar::Cylinder& cylinder);

  [[nodiscard]] bool empty() const { return std::holds_alternative<std::monostate>(motion_); }
  /// The times between which it is given, s.
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  /// Place, speed and acceleration at a time; before a law by points and after it the drive rests.
  [[nodiscard]] numerics::Jet at(double t) const;
  /// Its formula; null where it has points.
  [[nodiscard]] const Law* formula() const { return std::get_if<Law>(&motion_); }

 private:
  template <class Drive>
  void take(const Drive& drive);

  std::variant<std::monostate, numerics::RestToRestSpline, numerics::MonotoneSpline, Law> motion_;
  double first_ = 0.0, last_ = 0.0;
};

/// Whether a drive follows a law of motion; the axis is time then.
bool has_law(const Mechanism::Input& in);
/// Laws that cannot be followed: two for one drive, formulas that are none, moments that do not follow one another, no
/// speed or acceleration at some time. Needs values.
std::vector<FieldFault> check_laws(const Mechanism::Input& in);
/// Splines that overshoot their points: for a warning.
std::vector<FieldFault> overshooting_laws(const Mechanism::Input& in);

}  // namespace loadpath::planar
