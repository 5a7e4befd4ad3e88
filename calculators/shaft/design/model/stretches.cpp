#include "calculators/shaft/design/model/stretches.hpp"

#include "lib/beam/varying.hpp"
#include "lib/numerics/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

double area_of(const Ring& ring) { return pi / 4.0 * in_si(ring.d * ring.d - ring.d_bore * ring.d_bore); }

double inertia_of(const Ring& ring) { return in_si(polar(ring)) / 2.0; }

/// Stiffness in shear: that of the area over Cowper's factor, of a circle about 1.13, of a thin ring about 2.
double shear_stiffness(const Input& in, const Ring& ring) {
  const double nu = in_si(in.E) / (2.0 * in_si(in.G)) - 1.0, m = in_si(ring.d_bore) / in_si(ring.d);
  const double a = (1.0 + m * m) * (1.0 + m * m);
  const double k = 6.0 * (1.0 + nu) * a / ((7.0 + 6.0 * nu) * a + (20.0 + 12.0 * nu) * m * m);
  return k * in_si(in.G) * area_of(ring);
}

Stretch of_cylinder(const Input& in, const Ring& ring, double l) {
  const double I = inertia_of(ring), per_length = in_si(in.rho) * area_of(ring);
  Stretch s;
  s.bends = beam::uniform(l, in_si(in.E) * I, shear_stiffness(in, ring));
  s.most_twist = 1.0 / (2.0 * in_si(in.G) * I);
  s.twists = s.most_twist * l;
  s.left_mass = s.right_mass = per_length * l / 2.0;
  s.left_I_d = s.right_I_d = in_si(in.rho) * I * l / 2.0;
  s.weighs = beam::even(s.bends, per_length);
  return s;
}

/// From a place of its piece on.
Stretch of_taper(const Input& in, const Piece& piece, double from, double l) {
  constexpr double finest = 0.4, most_parts = 127.0;  // along which eight points find all digits
  boost::container::static_vector<double, 128> cuts{0.0};
  const double parts = std::ceil(std::abs(growth_of(piece, from, from + l)) / finest);
  for_each_part(piece, from, from + l, std::clamp(parts, 1.0, most_parts),
                [&](double, double to) { cuts.push_back(to - from); });
  cuts.back() = l;
  const auto ring = [&](double x) { return ring_at(piece, from_si<Length>(from + x)); };
  const auto section = [&](double x) {
    const Ring here = ring(x);
    return std::array{in_si(in.E) * inertia_of(here), shear_stiffness(in, here)};
  };
  const double d = in_si(ring(0.0).d), widens = 2.0 * slope_of(piece), b = in_si(piece.d_bore);
  const double rho = in_si(in.rho) * pi / 4.0;
  const beam::Spread weight({rho * (d * d - b * b), 2.0 * rho * d * widens, rho * widens * widens});
  const auto [span, along] = beam::varying(cuts, section, weight);
  Stretch s;
  s.bends = span, s.weighs = along;
  s.twists = span.bending * in_si(in.E) / (2.0 * in_si(in.G));
  s.most_twist = 1.0 / (2.0 * in_si(in.G) * std::min(inertia_of(ring(0.0)), inertia_of(ring(l))));
  s.right_mass = weight.force(l) - weight.moment(l) / l;
  s.left_mass = weight.force(l) - s.right_mass;
  const auto turning = [&](double begin, double end) {
    double sum = 0.0;
    numerics::for_each_gauss_8(begin, end,
                               [&](double x, double part) { sum += part * in_si(in.rho) * inertia_of(ring(x)); });
    return sum;
  };
  s.left_I_d = turning(0.0, l / 2.0), s.right_I_d = turning(l / 2.0, l);
  return s;
}

}  // namespace

beam::Row<Stretch> stretches_of(const Input& in, const Stations& stations) {
  beam::Row<Stretch> all;
  List<double, most_pieces> starts;
  Length x = 0.0 * mm;
  for (const Piece& piece : in.pieces) starts.push_back(in_si(x)), x += piece.l;
  for (std::size_t s = 0; s + 1 < stations.x.size(); ++s) {
    const std::size_t i = stations.piece[s];
    const Piece& piece = in.pieces[i];
    const double from = stations.x[s], l = stations.x[s + 1] - from;
    all.push_back(is_taper(piece) ? of_taper(in, piece, from - starts[i], l)
                                  : of_cylinder(in, {piece.d, piece.d_bore}, l));
  }
  return all;
}

/// For each part of a taper the two rods with equal vibration, to the fourth order of its length: an integrator of
/// Magnus without commutators (Blanes, Moan 2006), with the sections at the two places of Gauss's rule.
void add_rods(const Input& in, double from, double to, beam::Swing::Rods& rods) {
  const std::size_t index = index_of_piece(in, from_si<Length>((from + to) / 2.0));
  const Piece& piece = in.pieces[index];
  const double G = in_si(in.G), rho = in_si(in.rho), start = in_si(start_of(in, index));
  const auto I_p = [&](double x) { return in_si(polar(ring_at(piece, from_si<Length>(x)))); };
  if (!is_taper(piece)) {
    rods.push_back({to - from, G * I_p(0.0), rho * I_p(0.0)});
    return;
  }
  constexpr double finest = 0.05, most_parts = 16.0, along_shaft = 96.0;
  const double least = std::ceil((to - from) / in_si(length_of(in)) * along_shaft);
  const double fine = std::ceil(std::abs(growth_of(piece, from - start, to - start)) / finest);
  const double aside = std::sqrt(3.0) / 6.0, near = 0.25 + aside, far = 0.25 - aside;
  for_each_part(piece, from - start, to - start, std::max(std::min(fine, most_parts), least),
                [&](double left, double right) {
                  const double l = right - left, middle = (left + right) / 2.0, a = I_p(middle - aside * l),
                               b = I_p(middle + aside * l);
                  for (const auto& [first, second] : {std::array{near, far}, std::array{far, near}}) {
                    const double soft = (first / a + second / b) * l / G, mass = (first * a + second * b) * l * rho;
                    rods.push_back({l / 2.0, l / 2.0 / soft, mass / (l / 2.0)});
                  }
                });
}

}  // namespace loadpath::shaft
