// The mechanism as it is given: drives, links, points, joints, profiles, loads and springs as tables.
#include "calculators/mechanism/completion/courses.hpp"
#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/input/joints.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/quantity/format.hpp"

#include <utility>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;

std::string names_of_points(const planar::Link& link) {
  std::string all;
  for (const auto& p : link.points) all += (all.empty() ? "" : ", ") + text(p.name);
  return all;
}

Cell mass_centre_of(const planar::Link& link) {
  if (!(in_si(link.mass) > 0.0)) return std::string("–");
  return link.S.empty() ? Cell(say("origin")) : Cell(text(link.S));
}

Table link_table(const Mechanism::Input& in) {
  Table table{
      say("Links"), {say("link"), say("points"), say("mass"), say("moment of inertia"), say("mass centre")}, {}};
  for (const auto& l : in.links) {
    table.rows.push_back({text(l.name), names_of_points(l), Quantity{in_si(l.mass), "kg"},
                          Quantity{in_si(l.J), "kg*m^2"}, mass_centre_of(l)});
  }
  return table;
}

Table point_table(const Mechanism::Input& in) {
  Table table{say("Points in link coordinates"), {say("point"), say("link"), say("x"), say("y")}, {}};
  const auto add = [&](const planar::Point& p, const std::string& link) {
    const mechanism::Vec v = vector_of(p);
    table.rows.push_back({text(p.name), link, Quantity{v.x, "mm"}, Quantity{v.y, "mm"}});
  };
  for (const auto& p : in.ground) add(p, "ground");
  for (const auto& l : in.links) {
    for (const auto& p : l.points) add(p, text(l.name));
  }
  return table;
}

Table joint_table(const Mechanism::Input& in) {
  Table table{
      say("Joints"),
      {say("joint"), say("kind"), say("first link"), say("point"), say("second link"), say("point"), say("direction")},
      {}};
  for (const auto& j : in.joints) {
    const auto [first, second] = point_names(j);
    const Cell direction =
        j.type == planar::Type::revolute ? Cell(std::string("–")) : Cell(Quantity{j.direction, "deg"});
    table.rows.push_back({text(j.name), say(word_of(j.type)), text(j.links.first), text(first), text(j.links.second),
                          text(second), direction});
  }
  return table;
}

void add_sense(Message what, planar::Impending impending, Table& table) {
  if (impending == planar::Impending::either) return;
  table.rows.push_back({std::move(what), impending == planar::Impending::forward ? say("forward") : say("backward")});
}

/// "from the x axis to point A of crank": between what the crank angle is measured.
Message crank_angle_of(const Mechanism::Input& in) {
  const planar::Joint* const joint = find_named(in.joints, in.crank.joint);
  const bool first_fixed = joint->links.first.view() == "ground";
  const Name &link = first_fixed ? joint->links.second : joint->links.first,
             &base = first_fixed ? joint->links.first : joint->links.second;
  const Message from = base.view() == "ground" ? say("from the x axis") : say("from {1}'s own x axis", text(base));
  return in.crank.to.empty() ? say("{1} to {2}'s own x axis", from, text(link))
                             : say("{1} to point {2} of {3}", from, text(in.crank.to), text(link));
}

Table drive_table(const Mechanism::Input& in) {
  Table table{say("Drive"), {}, {}};
  if (!in.crank.joint.empty()) {
    table.rows.push_back({say("driven joint"), text(in.crank.joint)});
    table.rows.push_back({say("crank angle"), crank_angle_of(in)});
    for (const auto& moment : in.crank.law)
      table.rows.push_back(
          {say("crank angle at {1}", format_quantity(in_si(moment.t), "s")), Quantity{moment.angle, "deg"}});
    if (!in.crank.angle_of_t.empty()) {
      table.rows.push_back({say("crank angle at t"), std::string(in.crank.angle_of_t.view())});
      table.rows.push_back({say("for"), Quantity{in_si(in.crank.duration), "s"}});
    } else if (in.crank.law.empty()) {
      table.rows.push_back({say("angular velocity"), Quantity{in_si(in.crank.speed), "rad/s"}});
      table.rows.push_back({say("angular acceleration"), Quantity{in_si(in.crank.acceleration), "rad/s^2"}});
    }
    add_sense(say("about to turn"), in.crank.impending, table);
    const bool turn = in.crank.at.empty();
    if (!has_law(in)) table.rows.push_back({say("first crank angle"), Quantity{first_crank_angle(in.crank), "deg"}});
    table.rows.push_back(
        {say("positions"), std::to_string(turn ? static_cast<std::size_t>(in.crank.positions) : in.crank.at.size())});
  }
  for (const auto& c : in.cylinders) {
    table.rows.push_back({text(c.name), text(c.joint)});
    add_sense(say("{1} is about to move", text(c.name)), c.impending, table);
    if (!c.place_of_t.empty()) {
      table.rows.push_back({say("position of {1} at t", text(c.name)), std::string(c.place_of_t.view())});
      table.rows.push_back({say("for"), Quantity{in_si(c.duration), "s"}});
    }
    for (const auto& moment : c.law) {
      table.rows.push_back({say("position of {1} at {2}", text(c.name), format_quantity(in_si(moment.t), "s")),
                            Quantity{in_si(moment.place), "mm"}});
    }
  }
  table.rows.push_back({say("gravity"), Quantity{in_si(in.gravity), "m/s^2"}});
  if (in_si(in.gravity) != 0.0)
    table.rows.push_back({say("direction of gravity"), Quantity{in.gravity_direction, "deg"}});
  table.rows.push_back({say("inertia of the links"), leaves_out_inertia(in) ? say("left out") : say("included")});
  return table;
}

void show_drawn(const Mechanism::Input& in, std::vector<account::Block>& blocks) {
  append(std::vector{drive_table(in), link_table(in), point_table(in), joint_table(in)}, blocks);
}

void show_details(const Mechanism::Input& in, std::vector<account::Block>& blocks) {
  append(detail_tables(in), blocks);
  append(profile_tables(in), blocks);
  if (!in.loads.empty()) blocks.emplace_back(load_table(in));
  if (!in.courses.empty()) blocks.emplace_back(course_table(in));
  if (!in.springs.empty()) blocks.emplace_back(spring_table(in));
}

}  // namespace

constinit const Aspect aspects::drawn{.show_input = &show_drawn};

constinit const Aspect aspects::details{.show_input = &show_details};

}  // namespace loadpath::planar
