#include "calculators/shaft/torque_diagram.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

using Places = List<Length, most_torques + 1 + most_cylinders + 1>;

/// Ends of cylinders and places of torques, ascending; places closer than the rounding of a length count as one.
Places sections(const Torques& torques, const Cylinders& cylinders) {
  Places places;
  Length end = 0.0 * m.one;
  places.push_back(end);
  for (const Cylinder& c : cylinders) places.push_back(end += c.l);
  for (const AppliedTorque& t : torques) places.push_back(t.x);
  std::sort(places.begin(), places.end());
  const Length same = 1e-12 * end;
  places.erase(std::unique(places.begin(), places.end(), [&](Length a, Length b) { return b - a <= same; }),
               places.end());
  return places;
}

Moment moment_right_of(Length x, Length same, const Torques& torques) {
  Moment sum = 0.0 * N_m.one;
  for (const AppliedTorque& t : torques) {
    if (t.x <= x + same) sum += t.T;
  }
  return sum;
}

std::size_t cylinder_at(Length middle, const Cylinders& cylinders) {
  Length end = 0.0 * m.one;
  for (std::size_t i = 0; i < cylinders.size(); ++i) {
    if (middle < (end += cylinders[i].l)) return i;
  }
  return cylinders.size() - 1;
}

}  // namespace

Stretches stretches(const Torques& torques, const Cylinders& cylinders) {
  if (cylinders.size() == 1 && !is_set(cylinders[0].l)) {  // length unknown: one stretch, its moment all the same
    return {Stretch{0.0 * m.one, cylinders[0].l, torques.empty() ? 0.0 * N_m.one : torques.front().T, 0}};
  }
  const Places places = sections(torques, cylinders);
  const Length same = 1e-12 * places.back();
  Stretches result;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Length middle = 0.5 * (places[i] + places[i + 1]);
    result.push_back({places[i], places[i + 1] - places[i], moment_right_of(places[i], same, torques),
                      cylinder_at(middle, cylinders)});
  }
  return result;
}

}  // namespace loadpath::shaft
