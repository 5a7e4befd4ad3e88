#include "calculators/mechanism/input/loads.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::Vec;

bool turns(const planar::Spring& spring) {
  return in_si(spring.k_turn) != 0.0 || in_si(spring.c_turn) != 0.0 || is_set(spring.free_angle);
}

bool pulls(const planar::Spring& spring) {
  return in_si(spring.k) != 0.0 || in_si(spring.c) != 0.0 || is_set(spring.free);
}

/// One of them may be missing: it is zero.
bool is_cartesian(const planar::Load& load) { return is_set(load.F_x) || is_set(load.F_y); }

}  // namespace

std::string path_of(const planar::Load& load, std::size_t index) {
  return load.name.empty() ? "loads[" + std::to_string(index + 1) + "]" : path_of("loads", load.name);
}

mechanism::Load load_of(const Mechanism::Input& in, const planar::Load& l) {
  mechanism::Load load;
  load.name = l.name.view();
  load.link = link_index(in, l.link);
  if (!l.at.empty()) load.point = vector_of(*find_point(in, load.link, l.at));
  if (is_set(l.F)) load.force = in_si(l.F) * Vec{std::cos(l.direction), std::sin(l.direction)};
  if (is_cartesian(l)) load.force = {si_or_zero(l.F_x), si_or_zero(l.F_y)};
  load.turns_with_link = l.axes == planar::Axes::link;
  if (is_set(l.M)) load.moment = in_si(l.M);
  return load;
}

std::pair<Name, Name> end_of(const planar::Spring& spring) {
  return {spring.points.first, spring.points.second.empty() ? spring.points.first : spring.points.second};
}

mechanism::Spring spring_of(const Mechanism::Input& in, const planar::Spring& given) {
  mechanism::Spring spring;
  spring.name = given.name.view();
  spring.i = link_index(in, given.links.first);
  spring.j = link_index(in, given.links.second);
  if (turns(given)) {
    spring.kind = mechanism::Spring::Kind::turning;
    spring.rate = in_si(given.k_turn);
    spring.free = is_set(given.free_angle) ? given.free_angle : 0.0;
    spring.damping = in_si(given.c_turn);
    return spring;
  }
  const auto [first, second] = end_of(given);
  spring.point_i = vector_of(*find_point(in, spring.i, first));
  spring.point_j = vector_of(*find_point(in, spring.j, second));
  spring.rate = in_si(given.k);
  spring.free = is_set(given.free) ? in_si(given.free) : 0.0;
  spring.damping = in_si(given.c);
  return spring;
}

std::vector<FieldFault> check_fields(const planar::Spring& spring) {
  const std::string path = path_of("springs", spring.name);
  if (turns(spring) && pulls(spring)) {
    return {{path, say("'{1}' mixes fields of a translational and a torsional spring", spring.name.view()),
             say("either k, free and c, or k_turn, free_angle and c_turn")}};
  }
  if (turns(spring)) return {};
  if (in_si(spring.k) == 0.0 && in_si(spring.c) == 0.0) {
    return {{path, say("'{1}' has neither a rate nor a damping", spring.name.view()),
             say("add k = \"5 N/mm\", k_turn = \"2 N*m/rad\", c or c_turn")}};
  }
  std::vector<FieldFault> faults;
  if (in_si(spring.k) != 0.0 && !is_set(spring.free)) {
    faults.push_back(
        {path, say("the spring '{1}' needs its free length", spring.name.view()), say("add free = \"80 mm\"")});
  }
  if (spring.points.first.empty()) {
    faults.push_back({path, say("'{1}' needs the points of its ends", spring.name.view()),
                      say("add points = [\"A\", \"B\"]: the point of the first and of the second link")});
  }
  return faults;
}

std::vector<FieldFault> check_shares(const Mechanism::Input& in) {
  std::vector<FieldFault> faults;
  for (std::size_t k = 0; k < in.loads.size(); ++k) {
    const auto& over = in.loads[k].over;
    if (over.empty()) continue;
    if (in.crank.joint.empty())
      faults.push_back({path_of(in.loads[k], k) + ".over",
                        say("'over' depends on the crank angle, and no crank is given"),
                        say("leave it out, or drive by a crank")});
    for (std::size_t n = 1; n < over.size(); ++n) {
      if (over[n].angle > over[n - 1].angle) continue;
      faults.push_back({path_of(in.loads[k], k) + ".over", say("the crank angles of 'over' must increase"), {}});
      break;
    }
    if (over[over.size() - 1].angle - over[0].angle > 2.0 * pi * in.crank.turns * (1.0 + 1e-12))
      faults.push_back(
          {path_of(in.loads[k], k) + ".over", say("the crank angles of 'over' cover more than one cycle"), {}});
  }
  return faults;
}

double share_at(const planar::Load& load, double crank_angle, double period) {
  const auto& over = load.over;
  if (over.empty()) return 1.0;
  const double first = over[0].angle;
  const double angle = crank_angle - period * std::floor((crank_angle - first) / period);
  const auto next_one = std::upper_bound(over.begin() + 1, over.end(), angle,
                                         [](double at, const planar::Share& share) { return at < share.angle; });
  const auto k = static_cast<std::size_t>(next_one - over.begin()) - 1;
  const bool last = k + 1 == over.size();
  const double next = last ? first + period : over[k + 1].angle, next_share = last ? over[0].share : over[k + 1].share;
  const double width = next - over[k].angle;
  return width > 0.0 ? over[k].share + (next_share - over[k].share) * (angle - over[k].angle) / width : over[k].share;
}

Table load_table(const Mechanism::Input& in) {
  Table table{say("Loads"),
              {say("load"), say("link"), say("point"), say("force"), say("direction"), say("couple"), say("axes"),
               say("over the cycle")},
              {}};
  for (const auto& l : in.loads) {
    const bool cartesian = is_cartesian(l);
    const double fx = si_or_zero(l.F_x), fy = si_or_zero(l.F_y);
    const Cell none = std::string("–");
    const Cell force = is_set(l.F) ? Cell(Quantity{in_si(l.F), "N"})
                       : cartesian ? Cell(Quantity{std::hypot(fx, fy), "N"})
                                   : none;
    const Cell direction = is_set(l.F) ? Cell(Quantity{l.direction, "deg"})
                           : cartesian ? Cell(Quantity{std::atan2(fy, fx), "deg"})
                                       : none;
    table.rows.push_back({l.name.empty() ? none : Cell(text(l.name)), text(l.link),
                          l.at.empty() ? none : Cell(text(l.at)), force, direction,
                          is_set(l.M) ? Cell(Quantity{in_si(l.M), "N*m"}) : none,
                          l.axes == planar::Axes::link ? say("of the link") : say("fixed"),
                          !l.over.empty()     ? say("by {1} shares", std::to_string(l.over.size()))
                          : !l.course.empty() ? say("course {1}", l.course.view())
                                              : say("constant")});
  }
  return table;
}

Table spring_table(const Mechanism::Input& in) {
  Table table{say("Springs and dampers"),
              {say("name"), say("first link"), say("point"), say("second link"), say("point"), say("rate"),
               say("without force"), say("damping")},
              {}};
  for (const auto& spring : in.springs) {
    const bool turning = turns(spring);
    const auto [first, second] = end_of(spring);
    const Cell none = std::string("–");
    table.rows.push_back(
        {text(spring.name), text(spring.links.first), first.empty() ? none : Cell(text(first)),
         text(spring.links.second), second.empty() ? none : Cell(text(second)),
         turning ? Cell(Quantity{in_si(spring.k_turn), "N*m/rad"}) : Cell(Quantity{in_si(spring.k), "N/mm"}),
         turning ? Cell(Quantity{is_set(spring.free_angle) ? spring.free_angle : 0.0, "deg"})
                 : Cell(Quantity{is_set(spring.free) ? in_si(spring.free) : 0.0, "mm"}),
         turning ? Cell(Quantity{in_si(spring.c_turn), "N*m*s/rad"}) : Cell(Quantity{in_si(spring.c), "N*s/m"})});
  }
  return table;
}

}  // namespace loadpath::planar
