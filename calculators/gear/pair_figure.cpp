// The pair drawn in the transverse plane, with its pitch circles, the line of action and the forces on gear 1.
#include "calculators/gear/outline.hpp"
#include "calculators/gear/pair_parts.hpp"

namespace loadpath::gear {

namespace {

using draw::Point;

/// The generating rack in the transverse plane: heights stay, its module is longer.
Rack transverse(const Pair::Input& in, const Pair::Result& r) {
  const double share = std::cos(in.beta);
  return {r.alpha_t, in.h_fP * share, in.rho_fP * share};
}

Body first_body(const Pair::Input& in, const Pair::Result& r) {
  return {transverse(in, r),   in_si(r.m_t),        in.z_1, in.x_1 * std::cos(in.beta),
          in_si(r.d_a1) / 2.0, in_si(r.d_f1) / 2.0, {},     0.0};
}

Body second_body(const Pair::Input& in, const Pair::Result& r) {
  const double distance = in_si(r.a_w);
  Body b{transverse(in, r),   in_si(r.m_t),        in.z_2, r.x_2 * std::cos(in.beta),
         in_si(r.d_a2) / 2.0, in_si(r.d_f2) / 2.0, {},     0.0};
  b.at = {in.mesh == Mesh::internal ? -distance : distance, 0.0};
  b.turn = in.mesh == Mesh::internal ? 0.0 : pi - pi / in.z_2;  // a space faces the tooth of gear 1
  return b;
}

/// From where contact begins to where it ends; gear 1 drives counter-clockwise or its mirror image.
draw::Scheme::Guide line_of_action(const Pair::Input& in, const Pair::Result& r) {
  const double pitch = in_si(r.d_w1) / 2.0, side = in.turns == Turns::ccw ? 1.0 : -1.0;
  const Point along{std::sin(r.alpha_wt), side * std::cos(r.alpha_wt)};
  const double from = -in_si(r.g_f), to = in_si(r.g_a);
  return {{pitch - from * along.x, from * along.y}, {pitch - to * along.x, to * along.y}};
}

draw::Scheme drawn(const Pair::Input& in, const Pair::Result& r) {
  draw::Scheme s;
  const double pitch = in_si(r.d_w1) / 2.0;
  const Body one = first_body(in, r);
  s.outlines.push_back({one.at, wheel_outline(one)});
  s.wheels.push_back({{}, pitch, 0.0, true});
  s.joints.push_back({"O1", {}, draw::Scheme::Pin::revolute, true});
  if (in.mesh == Mesh::rack) {
    const Point line{in_si(r.a_w), 0.0};
    s.outlines.push_back({line, rack_outline(one.rack, one.m_t, in.h_aP * std::cos(in.beta), 7, line)});
  } else {
    const Body two = second_body(in, r);
    s.outlines.push_back({two.at, in.mesh == Mesh::internal ? ring_outline(two) : wheel_outline(two)});
    s.wheels.push_back({two.at, in_si(r.d_w2) / 2.0, 0.0, true});
    s.joints.push_back({"O2", two.at, draw::Scheme::Pin::revolute, true});
  }
  s.points.push_back({"C", {pitch, 0.0}});
  s.guides.push_back(line_of_action(in, r));
  if (is_set(r.F_x1) && r.F_t > 0.0 * N) {
    s.arrows.push_back({{pitch, 0.0}, {in_si(r.F_x1), in_si(r.F_y1)}, "F_1", false});
  }
  return s;
}

}  // namespace

std::vector<draw::Figure> Pair::figures(const Input& in, const Result& r) {
  if (!is_set(r.eps_alpha) || !has_teeth(in, r)) return {};
  return {{"pair", "The pair in the transverse plane, its working circles and the path of contact", drawn(in, r)}};
}

}  // namespace loadpath::gear
