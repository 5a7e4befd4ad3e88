#include "calculators/shaft/design/model/misalignment.hpp"

#include "calculators/shaft/design/model/positions.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// The span with a place, and the share of it to the left of the place; less than 0 or more than 1 beyond the ends.
struct Within {
  std::size_t span = 0;
  double share = 0.0;
};
Within within(const Stations& stations, double x) {
  const auto next = std::upper_bound(stations.x.begin() + 1, stations.x.end() - 1, x);
  const auto span = static_cast<std::size_t>(next - stations.x.begin()) - 1;
  return {span, (x - stations.x[span]) / (stations.x[span + 1] - stations.x[span])};
}

/// Deflection within a span: between its ends a line, bent by the moments at them. Beyond the shaft it is straight.
double deflection_at(const beam::LoadedBeam& bent, const beam::Span& span, const Within& at) {
  const beam::Node &left = bent.nodes[at.span], &right = bent.nodes[at.span + 1];
  if (at.share < 0.0) return left.v + left.slope * at.share * span.l;
  if (at.share > 1.0) return right.v + right.slope * (at.share - 1.0) * span.l;
  const double t = at.share, M_l = bent.spans[at.span].left.M, M_r = bent.spans[at.span].right.M;
  const double by_moments = M_l * t * (1.0 - t) * (2.0 - t) + M_r * t * (1.0 - t) * (1.0 + t);
  return (1.0 - t) * left.v + t * right.v - span.l * span.bending / 6.0 * by_moments;
}

double twist_at(const Loaded& loaded, const Within& at) {
  const double t = std::clamp(at.share, 0.0, 1.0);
  return (1.0 - t) * loaded.phi[at.span] + t * loaded.phi[at.span + 1];
}

/// Torque next to the middle of the face, in the span to its left or right.
double torque_next_to(const Loaded& loaded, std::size_t node, bool on_right) {
  if (on_right) return node < loaded.T.size() ? loaded.T[node] : 0.0;
  return node > 0 ? loaded.T[node - 1] : 0.0;
}

/// Twist of one half of the face: of the shaft, or of the body of the gear up to its root circle, which is stiffer. The
/// hub of a wheel keeps its teeth from the twist of the shaft in it.
double twist_of_half(double of_shaft, double T, double half, double G, const Seat& gear) {
  if (!is_set(gear.d_f)) return of_shaft;
  const double of_body = T * half / (G * pi / 32.0 * std::pow(in_si(gear.d_f), 4.0));
  return std::abs(of_body) < std::abs(of_shaft) ? of_body : of_shaft;
}

/// Direction of the transverse force in X and Y, and its lever about the axis: the base radius. No force: none.
struct Normal {
  double x = 0.0, y = 0.0, lever = 0.0;
};
Normal normal_of(const Seat& seat, std::size_t position) {
  const double along = in_si(seat.F_x.at(position)), across = in_si(seat.F_y.at(position));
  const double F = std::hypot(along, across);
  if (!(F > 0.0)) return {};
  const double c = std::cos(seat.angle), s = std::sin(seat.angle);
  return {(along * c - across * s) / F, (along * s + across * c) / F, std::abs(across * in_si(seat.x_w)) / F};
}

}  // namespace

bool has_face(const Seat& seat) {
  const auto is_loaded = [&](std::size_t i) {
    return seat.F_x.at(i) * seat.F_x.at(i) + seat.F_y.at(i) * seat.F_y.at(i) > 0.0 * N.one * N.one;
  };
  if (seat.kind != Mounted::gear || !is_set(seat.b_r)) return false;
  for (std::size_t i = 0; i < std::max(seat.F_x.positions(), seat.F_y.positions()); ++i) {
    if (is_loaded(i)) return true;
  }
  return false;
}

Misalignment misalignment_of(const Input& in, const Elastic& elastic, const Loaded& loaded, std::size_t seat,
                             std::size_t position) {
  const Seat& gear = in.seats[seat];
  const Normal normal = normal_of(gear, position);
  const double x = in_si(gear.x), half = in_si(gear.b_r) / 2.0;
  const Within left = within(loaded.stations, x - half), middle = within(loaded.stations, x),
               right = within(loaded.stations, x + half);
  const auto yields = [&](const Within& at) {
    const beam::Span& span = elastic.stretches[at.span].bends;
    return normal.x * deflection_at(loaded.x, span, at) + normal.y * deflection_at(loaded.y, span, at);
  };
  // Away from the end where torque enters, the shaft lags: teeth that take power off move along their force, which
  // opposes the rotation, and teeth that are driven move against it.
  const double T = in_si(torque_of(in, seat, position)), way = T < 0.0 ? 1.0 : T > 0.0 ? -1.0 : 0.0;
  Misalignment m;
  m.bending = yields(right) - yields(left);
  const std::size_t node = loaded.stations.at(gear.x);
  const double phi_left = twist_at(loaded, middle) - twist_at(loaded, left),
               phi_right = twist_at(loaded, right) - twist_at(loaded, middle), G = in_si(in.G);
  const double twist = twist_of_half(phi_left, torque_next_to(loaded, node, false), half, G, gear) +
                       twist_of_half(phi_right, torque_next_to(loaded, node, true), half, G, gear);
  m.twist = way * normal.lever * twist;
  m.sag = std::abs(yields(middle) - (yields(left) + yields(right)) / 2.0);
  return m;
}

}  // namespace loadpath::shaft
