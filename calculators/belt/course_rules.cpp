#include "calculators/belt/course.hpp"
#include "calculators/belt/course_parts.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <string>

namespace loadpath::belt {

namespace {

using Input = Course::Input;
using Pulley = Course::Pulley;

std::string path_of(const Input& in, std::size_t k) {
  return in.pulleys[k].name.empty() ? "pulleys[" + std::to_string(k + 1) + "]"
                                    : "pulleys." + std::string(in.pulleys[k].name.view());
}

FieldFault length_fault(const Input& in, const Circles& circles) {
  const Shift shift = shift_of(in, circles);
  const std::string name = path_of(in, moving_one(in));
  if (shift.longest == 0.0)
    return {name, say("wherever '{1}' is along its direction, the belt does not run through these pulleys", name),
            say("list the pulleys in the order of the belt, and state the outside ones")};
  return {"L",
          say("no position of '{1}' along its direction gives a belt of {2}", name, format_quantity(in_si(in.L), "mm")),
          say("it gives belts from {1} to {2}", format_quantity(shift.shortest, "mm", 6),
              format_quantity(shift.longest, "mm", 6))};
}

}  // namespace

bool Course::runs_fast(const Input& in) {
  return !in.pulleys.empty() && in.n_1 * in.pulleys[0].d / 2.0 > 10.0 * m_per_s;
}

/// Faster than any belt but thin flat ones of synthetic fibres.
Applies Course::beyond_speed(const Input& in) {
  return shown_by(!in.pulleys.empty() && in.n_1 * in.pulleys[0].d / 2.0 > 60.0 * m_per_s);
}

/// Smaller than the smallest pulley of any ribbed or V-belt, 13 mm of section PH.
Applies Course::beyond_bending(const Input& in) {
  return shown_by(std::any_of(in.pulleys.begin(), in.pulleys.end(), [](const Pulley& p) { return p.d < 13.0 * mm; }));
}

bool Course::carries(const Input& in) { return has_powers(in) || is_set(in.S_0); }

bool Course::tensioner_fits(const Input& in) {
  const auto moving =
      std::count_if(in.pulleys.begin(), in.pulleys.end(), [](const Pulley& p) { return is_set(p.along); });
  return moving == (is_set(in.L) ? 1 : 0);
}

FieldFault Course::wrong_tensioner(const Input& in) {
  const std::size_t moving = moving_one(in);
  if (!is_set(in.L))
    return {path_of(in, moving) + ".along", say("this pulley moves, and the belt length is not given"),
            say("give L, or leave out the direction")};
  if (moving == in.pulleys.size())
    return {"L", say("the length of the belt is given, and no pulley moves"),
            say("give one pulley the direction in which it tightens the belt, as in along = \"90 deg\"")};
  return {"pulleys", say("several pulleys can move, and one length does not determine their positions"),
          say("leave out along of all but one")};
}

bool Course::powers_fit(const Input& in) { return wrong_power(in).message.empty(); }

FieldFault Course::wrong_power(const Input& in) {
  if (in.pulleys.empty()) return {};
  if (is_set(in.pulleys[0].P))
    return {path_of(in, 0) + ".P", say("the first pulley drives, and supplies what the others take"),
            say("leave out its power")};
  if (!has_powers(in) && !is_set(in.S_0)) return {};
  if (!is_set(in.n_1))
    return {"n_1", say("powers and tensions need the speed n_1"), say("give n_1, as in \"1450 rpm\"")};
  if (!is_set(in.mu) && !is_set(in.S_0))
    return {"mu", say("the tensions need the friction mu, or the tension S_0 of the slack span"), {}};
  Power sum = 0.0 * W;
  for (const Pulley& p : in.pulleys) sum += is_set(p.P) ? p.P : 0.0 * W;
  if (sum < 0.0 * W)
    return {"pulleys", say("the pulleys give more power than they take: the first one would be driven"),
            say("put the pulley that drives first")};
  return {};
}

bool Course::backs_known(const Input& in) { return open_back(in).message.empty(); }

/// The friction of all is that of the grooves, or of the running side: the back that carries power has another.
FieldFault Course::open_back(const Input& in) {
  for (std::size_t k = 0; k < in.pulleys.size(); ++k) {
    const Pulley& p = in.pulleys[k];
    const bool carries = is_set(p.P) && abs(p.P) > 0.0 * W;
    if (p.side == Side::outside && carries && is_set(in.mu) && !is_set(p.mu))
      return {path_of(in, k),
              say("the back of the belt runs on this pulley, which takes power: its friction is different"),
              say("give mu of this pulley, of a flat face without groove")};
  }
  return {};
}

bool Course::closes(const Input& in) {
  if (in.pulleys.size() < 2 || !tensioner_fits(in)) return true;  // other rules speak of these
  const Circles circles = circles_of(in);
  return is_set(in.L) ? shift_of(in, circles).way.has_value() : lay_loop(circles, turn_of(in)).flaw == Flaw::none;
}

FieldFault Course::flaw_of(const Input& in) {
  const Circles circles = circles_of(in);
  if (is_set(in.L)) return length_fault(in, circles);
  const Loop loop = lay_loop(circles, turn_of(in));
  if (lay_loop(circles, -turn_of(in)).flaw == Flaw::none)
    return {"turns", say("the pulleys are listed against the direction of the belt"),
            say("reverse the first one: turns = \"{1}\"", in.turns == Turns::ccw ? "cw" : "ccw")};
  const std::string at = path_of(in, loop.at), other = path_of(in, loop.other);
  switch (loop.flaw) {
    case Flaw::touching:
      return {at, say("'{1}' and '{2}' touch", at, other), say("move them apart, or make one smaller")};
    case Flaw::untouched:
      return {at, say("the belt does not reach '{1}'", at), say("move it against the belt, or leave it out")};
    case Flaw::through:
      return {at, say("the span behind '{1}' runs through '{2}'", at, other),
              say("list the pulleys in the order in which the belt runs")};
    default:
      return {
          "pulleys", say("the belt would cross itself"),
          say("list the pulleys in the order in which the belt runs; with the first one clockwise, turns = \"cw\"")};
  }
}

}  // namespace loadpath::belt
