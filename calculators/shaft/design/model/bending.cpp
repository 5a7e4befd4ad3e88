#include "calculators/shaft/design/model/bending.hpp"

#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/gravity.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

constexpr double finest = 1e-6;  // share of the length: closer places are one
constexpr double parts = 120.0;  // parts of the length, at least: deflection and masses between the places

beam::Row<double> named_places(const Input& in, const CriticalPlaces& weakest) {
  beam::Row<double> x{0.0};
  for (const Piece& piece : in.pieces) x.push_back(x.back() + in_si(piece.l));
  for (const Support& support : in.supports) {
    x.push_back(in_si(support.x));
    x.push_back(in_si(pressure_centre(support)));
  }
  for (const Seat& seat : in.seats) x.push_back(in_si(seat.x));
  for (const Notched& notch : in.notches) {
    x.push_back(in_si(notch.x));
    if (const Length end = other_end(in, notch); is_on(in, end)) x.push_back(in_si(end));
  }
  // A position outside the shaft violates a rule, which may be reported only after a search.
  const double length = in_si(length_of(in));
  const auto is_outside = [&](double place) { return !(place >= 0.0 && place <= length); };
  x.erase(std::remove_if(x.begin(), x.end(), is_outside), x.end());
  const std::size_t named = x.size();
  for (const CriticalPlace& weak : weakest) {  // close to a named place it is that place
    const auto is_near = [&](double place) { return std::abs(place - weak.x) <= finest * in_si(length_of(in)); };
    if (std::none_of(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(named), is_near)) x.push_back(weak.x);
  }
  std::sort(x.begin(), x.end());
  return x;
}

std::optional<beam::Beam> beam_of(const Input& in, const Stations& stations, const beam::Row<Stretch>& stretches) {
  beam::Row<beam::Span> spans;
  for (const Stretch& stretch : stretches) spans.push_back(stretch.bends);
  beam::OfSupports<beam::Support> supports;
  for (const Support& support : in.supports)
    supports.push_back({stations.at(pressure_centre(support)), is_set(support.k) ? in_si(support.k) : beam::rigid});
  return beam::Beam::of(spans, supports);
}

/// The direction of an angle; a right one leaves nothing of the other plane.
struct Direction {
  double c, s;
  explicit Direction(double angle) : c(exact(std::cos(angle))), s(exact(std::sin(angle))) {}

 private:
  static double exact(double part) { return std::abs(part) < 1e-15 ? 0.0 : part; }
};

/// An unknown mass is left out, as a failure mode reports.
double mass_on(const Seat& seat) { return is_set(seat.mass) ? in_si(seat.mass) : 0.0; }

enum class Plane { X, Y };

/// What of each load lies in one of two planes.
struct InPlane {
  List<beam::Load, most_seats> loads;
  beam::Row<beam::OfEnds> weight;
  [[nodiscard]] beam::Loading loading() const { return {loads, weight}; }
};

InPlane in_plane(const Input& in, const Elastic& elastic, Plane plane, std::size_t position) {
  const Stations& stations = elastic.stations;
  const Direction down(is_set(in.g_angle) ? in.g_angle : 0.0);
  const double gravity = !is_set(in.g_angle) ? 0.0 : standard_gravity * (plane == Plane::X ? down.c : down.s);
  InPlane acts;
  for (const Seat& seat : in.seats) {
    const Direction way(seat.angle);
    const double along = plane == Plane::X ? way.c : way.s, across = plane == Plane::X ? -way.s : way.c;
    const double F_x = in_si(seat.F_x.at(position)), F_y = in_si(seat.F_y.at(position));
    const double F = in.K_A * (F_x * along + F_y * across) + mass_on(seat) * gravity;
    acts.loads.push_back({stations.at(seat.x), F, -in.K_A * in_si(seat.F_z.at(position)) * in_si(seat.x_w) * along});
  }
  for (std::size_t i = 0; is_set(in.g_angle) && i < elastic.stretches.size(); ++i) {
    acts.weight.push_back(elastic.stretches[i].weighs);
    for (double& at_end : acts.weight.back()) at_end *= gravity;
  }
  return acts;
}

/// The sum of what acts at the nodes so far; what rounding leaves of it is none.
class Along {
 public:
  explicit Along(const beam::Row<double>& nodes) : nodes_(nodes) {
    for (const double one : nodes) size_ += std::abs(one);
  }
  /// From left to right.
  double behind(std::size_t node) {
    sum_ += nodes_[node];
    if (std::abs(sum_) <= rounding * size_) sum_ = 0.0;
    return sum_;
  }

 private:
  static constexpr double rounding = 1e-13;
  const beam::Row<double>& nodes_;
  double sum_ = 0.0, size_ = 0.0;
};

/// Loads to the left of every span: driving torques, and axial forces directed to the left.
void run_along(const Input& in, const Elastic& elastic, std::size_t position, Loaded& loaded) {
  const Stations& stations = loaded.stations;
  beam::Row<double> T(stations.x.size()), N(stations.x.size());
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const double F_z = in.K_A * in_si(in.seats[i].F_z.at(position));
    T[stations.at(in.seats[i].x)] += in.K_A * in_si(torque_of(in, i, position));
    N[stations.at(in.seats[i].x)] -= F_z;
    loaded.thrust += F_z;
  }
  for (const Support& support : in.supports) {
    if (support.holds == Holds::both) N[stations.at(support.x)] += loaded.thrust;
  }
  loaded.phi.assign(1, 0.0);
  Along torque(T), pull(N);
  for (std::size_t s = 0; s + 1 < stations.x.size(); ++s) {
    loaded.T.push_back(torque.behind(s));
    loaded.N.push_back(pull.behind(s));
    const Stretch& stretch = elastic.stretches[s];
    loaded.phi.push_back(loaded.phi.back() + loaded.T[s] * stretch.twists);
    const double torsion = std::abs(loaded.T[s]), twist = torsion * stretch.most_twist;
    if (twist > loaded.twist) loaded.twist = twist, loaded.twisting = torsion, loaded.flexible = stretch.most_twist;
  }
}

/// Square of a vector; hypot is exact where these are, and slower.
double square_of(double a, double b) { return a * a + b * b; }

double larger(double a, double b) { return std::abs(a) < std::abs(b) ? b : a; }

}  // namespace

std::size_t Stations::at(Length place) const {
  const double wanted = in_si(place);
  const auto next = std::lower_bound(x.begin(), x.end(), wanted);
  if (next == x.begin()) return 0;
  if (next == x.end()) return x.size() - 1;
  const auto index = static_cast<std::size_t>(next - x.begin());
  return x[index] - wanted < wanted - x[index - 1] ? index : index - 1;
}

Stations stations_of(const Input& in, const CriticalPlaces& weakest) {
  Stations stations;
  stations.weakest = weakest;
  const double length = in_si(length_of(in));
  for (const double x : named_places(in, weakest)) {
    if (stations.x.empty()) {
      stations.x.push_back(x);
      continue;
    }
    const double from = stations.x.back(), gap = x - from;
    if (gap <= finest * length) continue;
    const double count = std::ceil(gap / length * parts);
    for (double k = 1.0; k <= count; ++k) stations.x.push_back(k < count ? from + gap * k / count : x);
  }
  for (std::size_t s = 0; s + 1 < stations.x.size(); ++s)
    stations.piece.push_back(index_of_piece(in, from_si<Length>((stations.x[s] + stations.x[s + 1]) / 2.0)));
  return stations;
}

std::size_t index_of_piece(const Input& in, Length x) {
  Length end = 0.0 * mm;
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    end += in.pieces[i].l;
    if (x < end) return i;
  }
  return in.pieces.size() - 1;
}

Length length_of(const Input& in) { return start_of(in, in.pieces.size()); }

Length start_of(const Input& in, std::size_t piece) {
  Length sum = 0.0 * m.one;
  for (std::size_t i = 0; i < piece; ++i) sum += in.pieces[i].l;
  return sum;
}

Mass mass_of(const Input& in) {
  Mass sum = 0.0 * kg.one;
  for (const Piece& p : in.pieces) {
    const Length d_2 = right_diameter(p);
    sum += pi / 4.0 * ((p.d * p.d + p.d * d_2 + d_2 * d_2) / 3.0 - p.d_bore * p.d_bore) * p.l * in.rho;
  }
  return sum;
}

InternalForces Loaded::side(std::size_t span, bool right_end) const {
  const auto& ends_x = x.spans[span];
  const auto& ends_y = y.spans[span];
  const beam::End& in_x = right_end ? ends_x.right : ends_x.left;
  const beam::End& in_y = right_end ? ends_y.right : ends_y.left;
  return {in_x.M, in_y.M, std::sqrt(square_of(in_x.V, in_y.V)), N[span], T[span]};
}

InternalForces Loaded::internal_forces(std::size_t node) const {
  if (node == 0) return side(0, false);
  if (node == T.size()) return side(node - 1, true);
  const InternalForces left = side(node - 1, true), right = side(node, false);
  const bool more_left = square_of(left.M_x, left.M_y) > square_of(right.M_x, right.M_y);
  const InternalForces& bent_more = more_left ? left : right;
  return {bent_more.M_x, bent_more.M_y, std::max(left.V, right.V), larger(left.N, right.N), larger(left.T, right.T)};
}

double Loaded::deflection(std::size_t node) const { return std::hypot(x.nodes[node].v, y.nodes[node].v); }
double Loaded::slope(std::size_t node) const { return std::hypot(x.nodes[node].slope, y.nodes[node].slope); }

bool bears(const Input& in) { return elastic_shaft(in).has_value(); }

std::optional<Elastic> elastic_shaft(const Input& in, const CriticalPlaces& weakest) {
  const Stations stations = stations_of(in, weakest);
  const beam::Row<Stretch> stretches = stretches_of(in, stations);
  const auto beam = beam_of(in, stations, stretches);
  if (!beam) return std::nullopt;
  return Elastic{stations, stretches, *beam};
}

Loaded loaded_at(const Input& in, const Elastic& elastic, std::size_t position) {
  Loaded loaded;
  loaded.stations = elastic.stations;
  const InPlane x = in_plane(in, elastic, Plane::X, position), y = in_plane(in, elastic, Plane::Y, position);
  elastic.beam.bend(x.loading(), y.loading(), loaded.x, loaded.y);
  run_along(in, elastic, position, loaded);
  return loaded;
}

double Loaded::largest_moment() const {
  double square = 0.0;
  for (std::size_t s = 0; s < T.size(); ++s) {
    for (const auto end : {&beam::Ends::left, &beam::Ends::right})
      square = std::max(square, square_of((x.spans[s].*end).M, (y.spans[s].*end).M));
  }
  return std::sqrt(square);
}

double Loaded::largest_deflection() const {
  double square = 0.0;
  for (std::size_t n = 0; n < x.nodes.size(); ++n) square = std::max(square, square_of(x.nodes[n].v, y.nodes[n].v));
  return std::sqrt(square);
}

std::size_t most_bent(const Input& in, const Elastic& elastic) {
  std::size_t most = 0;
  double largest = -1.0;
  for (std::size_t i = 0; varies(in) && i < positions_of(in); ++i) {
    const double M = loaded_at(in, elastic, i).largest_moment();
    if (numerics::exceeds(M, largest)) largest = M, most = i;
  }
  return most;
}

std::optional<Loaded> loaded_shaft(const Input& in) {
  const auto elastic = elastic_shaft(in);
  if (!elastic) return std::nullopt;
  return loaded_at(in, *elastic, most_bent(in, *elastic));
}

beam::Row<double> masses_of(const Input& in, const Elastic& elastic) {
  const Stations& stations = elastic.stations;
  beam::Row<double> masses(stations.x.size());
  for (std::size_t s = 0; s + 1 < stations.x.size(); ++s) {
    masses[s] += elastic.stretches[s].left_mass;
    masses[s + 1] += elastic.stretches[s].right_mass;
  }
  for (const Seat& seat : in.seats) masses[stations.at(seat.x)] += mass_on(seat);
  return masses;
}

beam::Frequencies critical_speeds(const Input& in, const Elastic& elastic) {
  return beam::frequencies(elastic.beam, masses_of(in, elastic));
}

}  // namespace loadpath::shaft
