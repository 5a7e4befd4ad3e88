#include "calculators/mechanism/input/joints.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/structure/phases.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace loadpath::planar {

namespace {

using mechanism::JointKind;
using mechanism::Vec;

/// A field that only some types take, and whether a joint has it.
struct Special {
  const char* key;
  Some<Type> types;
  const char* of;
  bool (*given)(const planar::Joint&);
};

constexpr Some wheels{Type::gear, Type::ring_gear, Type::belt, Type::crossed_belt, Type::rolling, Type::rolling_inside};
constexpr Some losing{Type::gear, Type::ring_gear, Type::rack, Type::belt, Type::crossed_belt};
constexpr Some cams{Type::cam, Type::cam_flat};
constexpr Some rubbing{Type::revolute, Type::prismatic, Type::slot, Type::cam, Type::cam_flat};
constexpr auto rubbing_names = "revolute joints, prismatic joints, slots and cams";

constexpr std::array specials{
    Special{"angle",
            {Type::prismatic, Type::rigid},
            "prismatic and rigid joints",
            [](const auto& j) { return is_set(j.angle); }},
    Special{"radii", wheels, "joints of two wheels", [](const auto& j) { return is_set(j.radii.first); }},
    Special{"radius",
            {Type::rack, Type::rolling_on_line, Type::cam},
            "racks, wheels on a line and rollers on a cam",
            [](const auto& j) { return is_set(j.radius); }},
    Special{"profile", cams, "cams", [](const auto& j) { return !j.profile.empty(); }},
    Special{"face", {Type::cam_flat}, "flat faces on a cam", [](const auto& j) { return j.face != 0.0; }},
    Special{"holding", cams, "cams", [](const auto& j) { return j.holding != planar::Holding::one_side; }},
    Special{"slack", {Type::belt, Type::crossed_belt}, "belts", [](const auto& j) { return in_si(j.slack) != 0.0; }},
    Special{"mu", rubbing, rubbing_names, [](const auto& j) { return j.mu != 0.0; }},
    Special{"mu_s", rubbing, rubbing_names, [](const auto& j) { return is_set(j.mu_s); }},
    Special{"v_s", rubbing, rubbing_names, [](const auto& j) { return is_set(j.v_s); }},
    Special{"pin_radius",
            {Type::revolute, Type::slot},
            "pins: revolute and slot",
            [](const auto& j) { return is_set(j.pin_radius); }},
    Special{
        "guide_length", {Type::prismatic}, "prismatic joints", [](const auto& j) { return is_set(j.guide_length); }},
    Special{"guide_width", {Type::prismatic}, "prismatic joints", [](const auto& j) { return is_set(j.guide_width); }},
    Special{"rolling_arm",
            {Type::rolling, Type::rolling_inside, Type::rolling_on_line},
            "rolling wheels",
            [](const auto& j) { return in_si(j.rolling_arm) != 0.0; }},
    Special{"efficiency", losing, "teeth and belts", [](const auto& j) { return j.efficiency != 1.0; }},
    Special{"efficiency_back", losing, "teeth and belts", [](const auto& j) { return is_set(j.efficiency_back); }},
    Special{"clearance",
            {Type::revolute},
            "pins: revolute joints",
            [](const auto& j) { return in_si(j.clearance) != 0.0; }},
    Special{"c",
            {Type::prismatic, Type::slot, Type::cam, Type::cam_flat},
            "sliding joints: prismatic, slot and cams",
            [](const auto& j) { return in_si(j.c) != 0.0; }},
    Special{"c_turn",
            {Type::revolute, Type::rolling, Type::rolling_inside, Type::rolling_on_line},
            "joints that turn: revolute and rolling",
            [](const auto& j) { return in_si(j.c_turn) != 0.0; }},
    Special{"gamma_min",
            {Type::revolute, Type::prismatic, Type::slot},
            "inner joints of dyads: revolute joints, prismatic joints and slots",
            [](const auto& j) { return is_set(j.gamma_min); }},
    Special{"h_max", {Type::prismatic}, "prismatic joints", [](const auto& j) { return is_set(j.h_max); }}};

class FieldCheck {
 public:
  explicit FieldCheck(const planar::Joint& joint) : joint_(joint) {}

  std::vector<FieldFault> run() {
    for (const Special& special : specials) {
      if (special.given(joint_) && !special.types.has(joint_.type)) refuse(special);
    }
    if (wheels.has(joint_.type) && !is_set(joint_.radii.first)) need("radii", "radii = [\"20 mm\", \"50 mm\"]");
    const bool on_line = joint_.type == Type::rack || joint_.type == Type::rolling_on_line;
    if (on_line && !is_set(joint_.radius)) need("radius", "radius = \"20 mm\"");
    if (is_cam(joint_.type) && joint_.profile.empty()) need("profile", "profile = \"NAME\", and it to the profiles");
    check_friction();
    check_mixed_friction();
    check_ring();
    return std::move(faults_);
  }

 private:
  [[nodiscard]] std::string path(std::string_view field = {}) const { return path_of("joints", joint_.name, field); }

  void refuse(const Special& special) {
    faults_.push_back({path(special.key),
                       say("'{1}' belongs to {2}, and '{3}' is of type {4}", special.key, special.of,
                           joint_.name.view(), word_of(joint_.type)),
                       say("leave it out, or change the type")});
  }

  void need(const char* field, const char* example) {
    faults_.push_back({path(),
                       say("joint '{1}' of type {2} needs '{3}'", joint_.name.view(), word_of(joint_.type), field),
                       say("add {1}", example)});
  }

  void check_friction() {
    if (joint_.mu == 0.0) return;
    if (joint_.type == Type::revolute && !is_set(joint_.pin_radius)) need("pin_radius", "pin_radius = \"10 mm\"");
    if (joint_.type != Type::prismatic) return;
    if (!is_set(joint_.guide_length)) need("guide_length", "guide_length = \"60 mm\"");
    if (!is_set(joint_.guide_width)) need("guide_width", "guide_width = \"30 mm\"; 0 where both edges rub on one line");
  }

  void check_mixed_friction() {
    const bool mixed = is_set(joint_.mu_s);
    if (mixed && !(joint_.mu > 0.0)) need("mu", "mu = 0.05, the coefficient of fast sliding");
    if (mixed && !is_set(joint_.v_s)) need("v_s", "v_s = \"0.1 m/s\"");
    if (!mixed && (is_set(joint_.v_s) || joint_.delta_s != 2.0)) need("mu_s", "mu_s = 0.15, the coefficient at rest");
    if (!mixed || joint_.mu_s >= joint_.mu) return;
    faults_.push_back({path("mu_s"), say("the coefficient at rest is smaller than mu, that of fast sliding"),
                       say("give at least {1}, or leave out mu_s, v_s and delta_s", format_number(joint_.mu))});
  }

  void check_ring() {
    const bool inside = joint_.type == Type::ring_gear || joint_.type == Type::rolling_inside;
    if (!inside || !is_set(joint_.radii.first) || joint_.radii.first < joint_.radii.second) return;
    faults_.push_back(
        {path("radii"),
         say("the wheel of the first link, {1}, does not fit into that of the second, {2}",
             format_quantity(in_si(joint_.radii.first), "mm"), format_quantity(in_si(joint_.radii.second), "mm")),
         say("the second link carries the ring, and has the larger radius")});
  }

  const planar::Joint& joint_;
  std::vector<FieldFault> faults_;
};

JointKind kind_of(Type type) {
  switch (type) {
    case Type::revolute:
      return JointKind::revolute;
    case Type::prismatic:
      return JointKind::prismatic;
    case Type::slot:
      return JointKind::slot;
    case Type::rigid:
      return JointKind::rigid;
    case Type::gear:
    case Type::ring_gear:
      return JointKind::gear;
    case Type::rack:
      return JointKind::rack;
    case Type::belt:
    case Type::crossed_belt:
      return JointKind::belt;
    case Type::rolling:
    case Type::rolling_inside:
      return JointKind::rolling;
    case Type::rolling_on_line:
      return JointKind::rolling_on_line;
    case Type::cam:
    case Type::cam_flat:
      return JointKind::cam;
  }
  return JointKind::revolute;
}

bool has_line_and_wheel(JointKind kind) { return kind == JointKind::rack || kind == JointKind::rolling_on_line; }

}  // namespace

std::vector<FieldFault> check_fields(const planar::Joint& joint) { return FieldCheck(joint).run(); }

mechanism::Joint joint_values(const planar::Joint& j) {
  mechanism::Joint joint;
  joint.name = j.name.view();
  joint.kind = kind_of(j.type);
  joint.direction = j.direction;
  joint.angle = j.angle;
  joint.radius_i = has_line_and_wheel(joint.kind) ? si_or_zero(j.radius) : si_or_zero(j.radii.first);
  const bool mirrored = j.type == Type::ring_gear || j.type == Type::rolling_inside || j.type == Type::crossed_belt;
  joint.radius_j = (mirrored ? -1.0 : 1.0) * si_or_zero(j.radii.second);
  joint.pressure_angle = j.pressure_angle;
  joint.tension = in_si(j.slack);
  joint.guide_length = si_or_zero(j.guide_length);
  joint.guide_width = si_or_zero(j.guide_width);
  if (j.type == Type::cam_flat) {
    joint.contact = mechanism::CamContact::flat;
    joint.angle = j.face;
  }
  const double efficiency_back = is_set(j.efficiency_back) ? j.efficiency_back : j.efficiency;
  joint.friction = {j.mu,
                    si_or_zero(j.pin_radius),
                    in_si(j.rolling_arm),
                    in_si(j.c) + in_si(j.c_turn),
                    1.0 - j.efficiency,
                    1.0 - efficiency_back};
  if (is_set(j.v_s) && j.mu > 0.0 && j.mu_s > j.mu) {
    joint.friction.rise = j.mu_s / j.mu - 1.0;
    joint.friction.stribeck_speed = in_si(j.v_s);
    joint.friction.stribeck_exponent = j.delta_s;
  }
  return joint;
}

namespace {

account::Table mixed_friction_table(const Mechanism::Input& in) {
  using account::Quantity;
  account::Table table{
      say("Mixed friction"), {say("joint"), say("mu at rest"), say("mu, fast"), say("v_s"), say("delta_s")}, {}};
  for (const planar::Joint& j : in.joints) {
    if (!is_set(j.mu_s)) continue;
    table.rows.push_back({std::string(j.name.view()), Quantity{j.mu_s, "-"}, Quantity{j.mu, "-"},
                          Quantity{in_si(j.v_s), "m/s"}, Quantity{j.delta_s, "-"}});
  }
  return table;
}

}  // namespace

std::vector<account::Table> detail_tables(const Mechanism::Input& in) {
  using account::Cell;
  using account::Quantity;
  const auto millimetres = [](const Length& length) {
    return is_set(length) && in_si(length) != 0.0 ? Cell(Quantity{in_si(length), "mm"}) : Cell(std::string("–"));
  };
  account::Table rolling{say("Wheels"),
                         {say("joint"), say("radius, first link"), say("second link"), say("pressure angle"),
                          say("slack"), say("efficiency"), say("backward")},
                         {}};
  account::Table friction{say("Friction and guides"),
                          {say("joint"), say("coefficient"), say("radius of the pin"), say("length of the guide"),
                           say("its width"), say("rolling arm"), say("viscous")},
                          {}};
  for (const planar::Joint& j : in.joints) {
    const std::string name(j.name.view());
    const bool teeth = j.type == Type::gear || j.type == Type::ring_gear || j.type == Type::rack;
    const bool belt = j.type == Type::belt || j.type == Type::crossed_belt;
    if (is_set(j.radii.first) || is_set(j.radius)) {
      rolling.rows.push_back(
          {name, millimetres(is_set(j.radius) ? j.radius : j.radii.first), millimetres(j.radii.second),
           teeth ? Cell(Quantity{j.pressure_angle, "deg"}) : Cell(std::string("–")),
           belt ? Cell(Quantity{in_si(j.slack), "N"}) : Cell(std::string("–")),
           teeth || belt ? Cell(Quantity{j.efficiency, "-"}) : Cell(std::string("–")),
           is_set(j.efficiency_back) ? Cell(Quantity{j.efficiency_back, "-"}) : Cell(std::string("–"))});
    }
    const bool sliding = in_si(j.c) != 0.0, turning = in_si(j.c_turn) != 0.0;
    if (j.mu == 0.0 && !is_set(j.guide_length) && in_si(j.rolling_arm) == 0.0 && !sliding && !turning) continue;
    friction.rows.push_back({name, j.mu == 0.0 ? Cell(std::string("–")) : Cell(Quantity{j.mu, "-"}),
                             millimetres(j.pin_radius), millimetres(j.guide_length), millimetres(j.guide_width),
                             millimetres(j.rolling_arm),
                             sliding   ? Cell(Quantity{in_si(j.c), "N*s/m"})
                             : turning ? Cell(Quantity{in_si(j.c_turn), "N*m*s/rad"})
                                       : Cell(std::string("–"))});
  }
  std::vector<account::Table> tables;
  if (!rolling.rows.empty()) tables.push_back(std::move(rolling));
  if (!friction.rows.empty()) tables.push_back(std::move(friction));
  if (auto mixed = mixed_friction_table(in); !mixed.rows.empty()) tables.push_back(std::move(mixed));
  return tables;
}

void take_from_assembly(mechanism::Model& model) {
  for (mechanism::Joint& joint : model.joints) {
    const mechanism::Placed i = placed_in(model, joint.i), j = placed_in(model, joint.j);
    if (!std::isfinite(joint.angle)) joint.angle = i.phi - j.phi;
    if (joint.kind == JointKind::cam && joint.contact == mechanism::CamContact::flat) {
      const Vec face = i.turned(mechanism::turn(joint.angle)({1.0, 0.0}));
      if (cross(face, j.point(joint.point_j) - i.point(joint.point_i)) > 0.0) joint.angle += pi;
    }
    if (!has_line_and_wheel(joint.kind)) continue;
    const Vec along = j.turned(mechanism::turn(joint.direction)({1.0, 0.0}));
    const bool right = cross(along, i.point(joint.point_i) - j.point(joint.point_j)) < 0.0;
    joint.radius_i = right ? -joint.radius_i : joint.radius_i;
  }
  mechanism::settle_phases(model);
}

}  // namespace loadpath::planar
