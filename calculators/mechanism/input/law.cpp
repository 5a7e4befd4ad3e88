#include "calculators/mechanism/input/law.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace loadpath::planar {

namespace {

Outcome<Law> parsed(const Formula& formula, const Dimension& dimension) {
  return Law::parse(formula.view(), {"t", sec.dimension()}, dimension);
}

using planar::path_of;

/// Names of the parts of a law in crank and cylinders, in one place.
const Formula& formula_of(const Crank& crank) { return crank.angle_of_t; }
const Formula& formula_of(const Cylinder& cylinder) { return cylinder.place_of_t; }
const char* formula_key(const Crank&) { return "angle_of_t"; }
const char* formula_key(const Cylinder&) { return "place_of_t"; }
const char* unit_of(const Crank&) { return "deg"; }
const char* unit_of(const Cylinder&) { return "mm"; }
Dimension dimension_of(const Crank&) { return deg.dimension(); }
Dimension dimension_of(const Cylinder&) { return mm.dimension(); }
std::string path_of(const Crank&) { return "crank"; }
std::string path_of(const Cylinder& cylinder) { return path_of("cylinders", cylinder.name); }
double place_of(const Crank::Moment& moment) { return moment.angle; }
double place_of(const Cylinder::Moment& moment) { return in_si(moment.place); }

template <class Visit>
void for_each_drive(const Mechanism::Input& in, Visit visit) {
  visit(in.crank, in.crank.positions);
  for (const Cylinder& cylinder : in.cylinders)
    visit(cylinder, in.crank.joint.empty() ? in.positions : in.crank.positions);
}

/// The times of a law by points, and the places then.
struct Points {
  std::vector<double> t, place;
};
template <class Drive>
Points points_of(const Drive& drive) {
  Points points;
  for (const auto& moment : drive.law) {
    points.t.push_back(in_si(moment.t));
    points.place.push_back(place_of(moment));
  }
  return points;
}

template <class Drive>
bool follows_law(const Drive& drive) {
  return !drive.law.empty() || !formula_of(drive).empty();
}

class LawCheck {
 public:
  std::vector<FieldFault> run(const Mechanism::Input& in) {
    for_each_drive(in, [this](const auto& drive, Whole positions) { check(drive, positions); });
    if (faults_.empty()) check_times(in);
    return std::move(faults_);
  }

 private:
  template <class Drive>
  void check(const Drive& drive, Whole positions) {
    const std::string path = path_of(drive), formula = path + "." + formula_key(drive);
    if (!drive.law.empty() && !formula_of(drive).empty())
      return add(formula, say("'law' and '{1}' both define the motion of the drive", formula_key(drive)),
                 say("leave out one of the two"));
    if (drive.law.empty() && drive.law_shape != planar::LawShape::spline)
      add(path + ".law_shape", say("'law_shape' belongs to a law by points, and there is none"), say("leave it out"));
    if (formula_of(drive).empty() && is_set(drive.duration))
      add(path + ".duration", say("'duration' belongs to a formula, and '{1}' is missing", formula_key(drive)),
          say("leave it out, or add the formula"));
    if (follows_law(drive) && drive.impending != planar::Impending::either)
      add(path + ".impending", say("'impending' belongs to a drive at rest, and this one follows a law"),
          say("leave it out"));
    if (!drive.law.empty()) check_points(drive, path + ".law");
    if (!formula_of(drive).empty()) check_formula(drive, formula, positions);
  }

  /// A formula is not used outside of the time for which it holds; points rest before and after theirs.
  void check_times(const Mechanism::Input& in) {
    double first = 0.0, last = 0.0;
    for_each_drive(in, [&](const auto& drive, Whole) {
      if (follows_law(drive))
        first = std::min(first, DriveLaw(drive).first()), last = std::max(last, DriveLaw(drive).last());
    });
    for_each_drive(in, [&](const auto& drive, Whole) {
      if (formula_of(drive).empty() || (first == 0.0 && last == DriveLaw(drive).last())) return;
      add(path_of(drive) + ".duration",
          say("the law of '{1}' holds from 0 s to {2}, and other drives move from {3} to {4}", path_of(drive),
              format_quantity(DriveLaw(drive).last(), "s", 4), format_quantity(first, "s", 4),
              format_quantity(last, "s", 4)),
          say("let all laws hold over the same time"));
    });
  }

  template <class Drive>
  void check_points(const Drive& drive, const std::string& path) {
    if (drive.law.size() == 1)
      add(path, say("a law of motion needs at least two instants"),
          say("write law = [[\"0 s\", ...], [\"1 s\", ...]]"));
    const auto late = [](const auto& a, const auto& b) { return !(b.t > a.t); };
    if (std::adjacent_find(drive.law.begin(), drive.law.end(), late) != drive.law.end())
      add(path, say("the times of a law must increase"));
  }

  template <class Drive>
  void check_formula(const Drive& drive, const std::string& path, Whole positions) {
    if (!is_set(drive.duration))
      return add(path, say("a law by a formula needs the time for which it holds"), say("add duration = \"2 s\""));
    const auto law = parsed(formula_of(drive), dimension_of(drive));
    if (!law) return add(path, law.fault().message, law.fault().hint);
    for (int k = 0; k < positions; ++k) {
      const double t = positions > 1 ? in_si(drive.duration) * k / (positions - 1) : 0.0;
      const numerics::Jet at = law->at(t);
      if (std::isfinite(at.value) && std::isfinite(at.first) && std::isfinite(at.second)) continue;
      return add(path, say("the law has no position, speed or acceleration at t = {1}", format_quantity(t, "s", 4)),
                 say("it divides by zero there, or takes a root or an arc function outside its range"));
    }
  }

  void add(std::string path, Message message, Message hint = {}) {
    faults_.push_back({std::move(path), std::move(message), std::move(hint)});
  }

  std::vector<FieldFault> faults_;
};

}  // namespace

template <class Drive>
void DriveLaw::take(const Drive& drive) {
  if (!drive.law.empty()) {
    const auto [t, place] = points_of(drive);
    first_ = t.front();
    last_ = t.back();
    if (drive.law_shape == planar::LawShape::monotone) {
      motion_ = numerics::MonotoneSpline(t, place);
    } else {
      motion_ = numerics::RestToRestSpline(t, place);
    }
  }
  if (formula_of(drive).empty()) return;
  auto law = parsed(formula_of(drive), dimension_of(drive));
  if (!law) return;  // reported by check_laws
  motion_ = std::move(*law);
  last_ = in_si(drive.duration);
}

DriveLaw::DriveLaw(const Crank& crank) { take(crank); }

DriveLaw::DriveLaw(const Cylinder& cylinder) { take(cylinder); }

numerics::Jet DriveLaw::at(double t) const {
  return std::visit(
      [t](const auto& motion) {
        if constexpr (std::is_same_v<std::decay_t<decltype(motion)>, std::monostate>) {
          return numerics::Jet{};
        } else {
          return motion.at(t);
        }
      },
      motion_);
}

bool has_law(const Mechanism::Input& in) {
  bool any = false;
  for_each_drive(in, [&any](const auto& drive, Whole) { any = any || follows_law(drive); });
  return any;
}

std::vector<FieldFault> check_laws(const Mechanism::Input& in) { return LawCheck().run(in); }

std::vector<FieldFault> overshooting_laws(const Mechanism::Input& in) {
  constexpr double negligible = 1e-3;  // share of the range from the lowest to the highest point
  std::vector<FieldFault> warnings;
  for_each_drive(in, [&](const auto& drive, Whole) {
    if (drive.law.size() < 2 || drive.law_shape != planar::LawShape::spline) return;
    const auto [t, place] = points_of(drive);
    const auto [low, high] = std::minmax_element(place.begin(), place.end());
    const auto over = numerics::RestToRestSpline(t, place).largest_overshoot();
    if (!(over.by > negligible * (*high - *low))) return;
    warnings.push_back({path_of(drive) + ".law",
                        say("the law swings beyond its points: to {1} at {2}, which is {3} too far",
                            format_quantity(over.y, unit_of(drive), 4), format_quantity(over.x, "s", 4),
                            format_quantity(over.by, unit_of(drive), 3)),
                        say("add points, or law_shape = \"monotone\", which stays between them")});
  });
  return warnings;
}

}  // namespace loadpath::planar
