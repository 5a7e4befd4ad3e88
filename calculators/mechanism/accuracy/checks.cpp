#include "calculators/mechanism/accuracy/checks.hpp"

#include "calculators/mechanism/accuracy/tolerances.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace loadpath::planar {

namespace {

bool is_driven(const Mechanism::Input& in, const Name& joint) {
  return (!in.crank.joint.empty() && joint == in.crank.joint) ||
         std::any_of(in.cylinders.begin(), in.cylinders.end(), [&](const auto& c) { return c.joint == joint; });
}

void require_driven(const Name& joint, const std::string& path, NameFaults& faults) {
  if (!faults.require_joint(joint, path) || is_driven(faults.input(), joint)) return;
  faults.add(path, say("the joint '{1}' has no drive", joint.view()),
             say("name the joint of the crank or of a cylinder"));
}

class ToleranceCheck {
 public:
  ToleranceCheck(const planar::Tolerance& t, NameFaults& faults)
      : t_(t), faults_(faults), path_(path_of("tolerances", t.name)), shape_(shape_of(t.of, faults.input(), t)) {}

  void run() {
    const std::array names{Field{"link", &t_.link, shape_.link}, Field{"point", &t_.point, shape_.point},
                           Field{"to", &t_.to, shape_.to}, Field{"joint", &t_.joint, shape_.joint},
                           Field{"spring", &t_.spring, shape_.spring}};
    bool complete = true;
    for (const Field& field : names) complete = check_name(field) && complete;
    if (!complete) return;
    check_widths();
    if (shape_.link) check_link();
    if (shape_.joint) check_joint();
    if (shape_.spring) faults_.require_spring(t_.spring, path_ + ".spring");
  }

 private:
  struct Field {
    const char* key;
    const Name* name;
    bool belongs;
  };

  bool check_name(const Field& field) {
    const bool given = !field.name->empty();
    if (given && !field.belongs) {
      faults_.add(path_ + "." + field.key, say("a tolerance of {1} has no '{2}'", word_of(t_.of), field.key),
                  say("leave it out"));
    }
    if (!given && field.belongs) {
      faults_.add(path_, say("the tolerance '{1}' of {2} needs '{3}'", t_.name.view(), word_of(t_.of), field.key),
                  say("add {1} = \"...\"", field.key));
    }
    return given == field.belongs;
  }

  /// Exactly one half width, of the right kind.
  void check_widths() {
    struct Width {
      const char* key;
      bool given, belongs;
    };
    const std::array widths{Width{"t", is_set(t_.t), shape_.t}, Width{"t_angle", is_set(t_.t_angle), shape_.t_angle},
                            Width{"t_mass", is_set(t_.t_mass), shape_.t_mass},
                            Width{"t_part", is_set(t_.t_part), shape_.t_part}};
    int count = 0;
    const char* wanted = "t";
    for (const Width& width : widths) {
      if (width.belongs) wanted = width.key;
      if (!width.given) continue;
      if (width.belongs)
        ++count;
      else
        faults_.add(path_ + "." + width.key, say("'{1}' is not a valid tolerance of {2}", width.key, word_of(t_.of)),
                    say("write {1}", hint()));
    }
    if (count == 1) return;
    const bool wrong = std::any_of(widths.begin(), widths.end(), [](const Width& w) { return w.given && !w.belongs; });
    if (count > 1)
      faults_.add(path_, say("the tolerance '{1}' has two half widths", t_.name.view()), say("leave one out"));
    else if (!wrong)
      faults_.add(path_, say("the tolerance '{1}' needs its half width '{2}'", t_.name.view(), wanted),
                  say("add {1}", hint()));
  }

  [[nodiscard]] std::string hint() const {
    if (shape_.t_angle) return "t_angle = \"0.1 deg\"";
    if (shape_.t_mass) return "t_mass = \"10 g\", or t_part = 0.05";
    return shape_.t_part ? "t_part = 0.05" : "t = \"0.05 mm\"";
  }

  void check_link() {
    if (!faults_.require_link(t_.link, path_ + ".link")) return;
    const int link = link_index(faults_.input(), t_.link);
    const bool first = !shape_.point || faults_.require_point(link, t_.point, path_ + ".point");
    const bool second = !shape_.to || faults_.require_point(link, t_.to, path_ + ".to");
    if (!shape_.point && link == mechanism::ground)
      faults_.add(path_ + ".link", say("the ground does not move: its mass has no effect"), say("name a moving link"));
    if (first && second && shape_.to && t_.point == t_.to)
      faults_.add(path_ + ".to", say("'{1}' is measured from itself", t_.to.view()), say("name another point"));
  }

  void check_joint() {
    const std::string path = path_ + ".joint";
    if (t_.of == Toleranced::drive) return require_driven(t_.joint, path, faults_);
    if (!faults_.require_joint(t_.joint, path)) return;
    const planar::Joint& joint = *find_named(faults_.input().joints, t_.joint);
    const bool two = is_set(joint.radii.first), one = is_set(joint.radius) || two;
    const bool line = joint.type == Type::prismatic || joint.type == Type::slot || joint.type == Type::rack ||
                      joint.type == Type::rolling_on_line;
    const bool fits = t_.of == Toleranced::radius          ? one
                      : t_.of == Toleranced::radius_second ? two
                      : t_.of == Toleranced::direction     ? line
                                                           : joint.mu > 0.0;
    if (fits) return;
    faults_.add(path,
                say("the joint '{1}' of type {2} has no {3}", t_.joint.view(), word_of(joint.type), word_of(t_.of)),
                say("name another joint"));
  }

  const planar::Tolerance& t_;
  NameFaults& faults_;
  std::string path_;
  ToleranceShape shape_;
};

/// The dimension that has the tolerance, SI; none where it may be zero, or has no half width of its own kind.
std::optional<double> value_of(const Mechanism::Input& in, const planar::Tolerance& t) {
  switch (t.of) {
    case Toleranced::length: {
      const int link = link_index(in, t.link);
      return mechanism::length(vector_of(*find_point(in, link, t.to)) - vector_of(*find_point(in, link, t.point)));
    }
    case Toleranced::mass: {
      const double mass = in_si(in.links[static_cast<std::size_t>(link_index(in, t.link))].mass);
      return mass == 0.0 ? std::nullopt : std::optional(mass);
    }
    case Toleranced::radius:
    case Toleranced::radius_second: {
      const planar::Joint& joint = *find_named(in.joints, t.joint);
      const Length radius = !is_set(joint.radii.first)   ? joint.radius
                            : t.of == Toleranced::radius ? joint.radii.first
                                                         : joint.radii.second;
      return in_si(radius);
    }
    case Toleranced::x:
    case Toleranced::y:
    case Toleranced::angle:
    case Toleranced::J:
    case Toleranced::direction:
    case Toleranced::mu:
    case Toleranced::rate:
    case Toleranced::drive:
      break;
  }
  return std::nullopt;
}

void need(const planar::Accuracy& wanted, const char* field, NameFaults& faults) {
  faults.add(path_of("accuracy", wanted.name),
             say("the output '{1}' of kind {2} needs '{3}'", wanted.name.view(), word_of(wanted.of), field),
             say("add {1} = \"...\"", field));
}

void check_point(const planar::Accuracy& wanted, const std::string& path, NameFaults& faults) {
  if (!wanted.link.empty()) {
    if (!faults.require_link(wanted.link, path + ".link")) return;
    const int link = link_index(faults.input(), wanted.link);
    faults.require_point(link, wanted.point, path + ".point");
    if (link == mechanism::ground)
      faults.add(path + ".link", say("a point of the ground does not move"), say("name a moving link"));
    return;
  }
  std::vector<std::string> names;
  for (const TracedPoint& p : traced_points(faults.input())) names.push_back(p.name);
  if (std::find(names.begin(), names.end(), wanted.point.view()) != names.end()) return;
  faults.add(path + ".point", say("unknown moving point '{1}'", wanted.point.view()),
             did_you_mean(wanted.point.view(), names, there_is(names)));
}

void check_drive(const planar::Accuracy& wanted, const std::string& path, NameFaults& faults) {
  const Mechanism::Input& in = faults.input();
  const std::size_t drives = in.cylinders.size() + (in.crank.joint.empty() ? 0 : 1);
  if (!wanted.joint.empty()) return require_driven(wanted.joint, path + ".joint", faults);
  if (drives == 0) faults.add(path, say("the mechanism has no drive whose effort could have an error"));
  if (drives > 1)
    faults.add(path, say("{1} drives: state which one", std::to_string(drives)),
               say("add joint = \"...\", the driven joint"));
}

/// Whether there is a field that the kind of output does not take.
bool has_idle_field(const planar::Accuracy& wanted, const std::string& path, bool place, NameFaults& faults) {
  struct Field {
    const char* key;
    const Name& name;
    bool belongs;
  };
  const std::array fields{Field{"point", wanted.point, place},
                          Field{"link", wanted.link, place || wanted.of == Watched::angle},
                          Field{"joint", wanted.joint, wanted.of == Watched::drive || wanted.of == Watched::force}};
  bool idle = false;
  for (const Field& field : fields) {
    if (field.name.empty() || field.belongs) continue;
    idle = true;
    faults.add(path + "." + field.key, say("an output of kind {1} has no '{2}'", word_of(wanted.of), field.key),
               say("leave it out"));
  }
  return idle;
}

void check_output(const planar::Accuracy& wanted, NameFaults& faults) {
  const std::string path = path_of("accuracy", wanted.name);
  const bool place = wanted.of == Watched::x || wanted.of == Watched::y;
  if (has_idle_field(wanted, path, place, faults)) return;
  if (place) return wanted.point.empty() ? need(wanted, "point", faults) : check_point(wanted, path, faults);
  if (wanted.of == Watched::drive) return check_drive(wanted, path, faults);
  if (wanted.of == Watched::force) {
    if (wanted.joint.empty()) return need(wanted, "joint", faults);
    faults.require_joint(wanted.joint, path + ".joint");
    return;
  }
  if (wanted.link.empty()) return need(wanted, "link", faults);
  if (faults.require_link(wanted.link, path + ".link") && wanted.link.view() == "ground")
    faults.add(path + ".link", say("the ground does not turn"), say("name a moving link"));
}

}  // namespace

void check_accuracy(NameFaults& faults) {
  const Mechanism::Input& in = faults.input();
  const auto play =
      std::find_if(in.joints.begin(), in.joints.end(), [](const auto& j) { return in_si(j.clearance) > 0.0; });
  const bool any = !in.tolerances.empty() || play != in.joints.end();
  const Message hint = say("name an output: accuracy = { end = { of = \"x\", point = \"B\" } }");
  if (in.accuracy.empty() && !in.tolerances.empty())
    faults.add("tolerances", say("the tolerances have no effect: no output is named under 'accuracy'"), hint);
  else if (in.accuracy.empty() && any)
    faults.add(path_of("joints", play->name, "clearance"),
               say("the clearance in '{1}' has no effect: no output is named under 'accuracy'", play->name.view()),
               hint);
  if (!in.accuracy.empty() && !any)
    faults.add("accuracy", say("no tolerance or clearance is given, so outputs have no error"),
               say("add tolerances = { rod = { link = \"rod\", point = \"A\", to = \"B\", t = \"0.05 mm\" } }"));
  for (const planar::Tolerance& t : in.tolerances) ToleranceCheck(t, faults).run();
  for (const planar::Accuracy& wanted : in.accuracy) check_output(wanted, faults);
}

void check_half_widths(const Mechanism::Input& in, const mechanism::Model&, std::vector<FieldFault>& faults) {
  for (const planar::Tolerance& t : in.tolerances) {
    const auto own = value_of(in, t);
    const HalfWidth half = half_width(t);
    if (!own || is_set(t.t_part) || half.si < std::abs(*own)) continue;
    faults.push_back(
        {path_of("tolerances", t.name, is_set(t.t_mass) ? "t_mass" : "t"),
         say("the tolerance '{1}', {2}, is not smaller than its {3}, {4}", t.name.view(),
             format_quantity(half.si, half.unit), word_of(t.of), format_quantity(std::abs(*own), half.unit)),
         say("the half width must be smaller; check its unit")});
  }
}

}  // namespace loadpath::planar
