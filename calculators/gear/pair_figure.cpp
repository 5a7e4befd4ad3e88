// The pair drawn in the transverse plane: in full, with its circles, and at the mesh, with the path of contact.
#include "calculators/gear/pair.hpp"
#include "calculators/gear/pair_bodies.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::gear {

namespace {

using figure::Drawing;
using figure::Point;

/// The generating rack in the transverse plane: heights stay, its module is longer.
Rack transverse(const Pair::Input& in, const Pair::Result& r) {
  const double share = std::cos(in.beta);
  return {r.alpha_t, in.h_fP * share, in.rho_fP * share};
}

double side_of(const Pair::Input& in) { return in.turns == Turns::ccw ? 1.0 : -1.0; }

/// Profile shift equal to the tooth thinning by the allowance, in normal modules.
double shift_of(const Pair::Input& in, Length A_s) { return in_si(A_s) / (2.0 * in_si(in.m_n) * std::tan(in.alpha_n)); }

/// By how much gear 1 is to be turned so that the flanks that drive touch: half the backlash.
double turn_to_contact(const Pair::Input& in, const Pair::Result& r) {
  const double base_helix = std::asin(std::sin(in.beta) * std::cos(in.alpha_n));
  return side_of(in) * 0.5 * in_si(r.j_bn) / std::cos(base_helix) / (0.5 * in_si(r.d_b1));
}

/// Data common to both views.
struct Mate {
  Point at;
  std::vector<Point> outline;
  bool is_ring = false;
  double rim = 0.0;  // outside of a ring as drawn; no input gives it
};

struct Scene {
  const Pair::Input& in;
  const Pair::Result& r;
  std::vector<Point> first;
  Mate mate;
  Point pitch;           // the pitch point
  Point along;           // direction of the line of action, as the contact moves where gear 1 drives: into gear 2
  double g_f, g_a, m_t;  // m

  Scene(const Pair::Input& input, const Pair::Result& result)
      : in(input), r(result), pitch{in_si(r.d_w1) / 2.0, 0.0}, g_f(in_si(r.g_f)), g_a(in_si(r.g_a)), m_t(in_si(r.m_t)) {
    Body one = first_body(in, r);
    one.turn = turn_to_contact(in, r);
    first = wheel_outline(one);
    along = {std::sin(r.alpha_wt), side_of(in) * std::cos(r.alpha_wt)};
    if (in.mesh == Mesh::rack) {
      const Point line{in_si(r.a_w), 0.0};
      const int teeth = 2 * std::clamp(static_cast<int>(one.r_a / (pi * m_t)), 2, 15);  // even: a space faces gear 1
      mate = {line, rack_outline(one.rack, m_t, in.h_aP * std::cos(in.beta), teeth, line)};
      return;
    }
    const Body two = second_body(in, r);
    mate = {two.at, in.mesh == Mesh::internal ? ring_outline(two) : wheel_outline(two), in.mesh == Mesh::internal};
    mate.rim = two.r_f + 2.0 * m_t;
  }
  /// On the line of action, from the pitch point on.
  [[nodiscard]] Point on_line(double way) const { return {pitch.x + way * along.x, pitch.y + way * along.y}; }
};

void add_bodies(const Scene& s, Drawing::View& view) {
  view.areas.push_back({s.first, Drawing::Kind::body, say("gear 1").text()});
  view.paths.push_back({s.first, Drawing::Line::outline, true});
  if (s.mate.is_ring) {
    view.areas.push_back({rim_of(s.mate.at, s.mate.rim), Drawing::Kind::body, say("gear 2").text(), s.mate.outline});
    view.circles.push_back({s.mate.at, s.mate.rim, Drawing::Line::thin});
  } else {
    view.areas.push_back({s.mate.outline, Drawing::Kind::body, say("gear 2").text()});
  }
  view.paths.push_back({s.mate.outline, Drawing::Line::outline, true});
}

void add_pitch_circles(const Scene& s, Drawing::View& view) {
  view.circles.push_back({{}, s.pitch.x, Drawing::Line::centre});
  if (s.in.mesh != Mesh::rack) {
    view.circles.push_back({s.mate.at, in_si(s.r.d_w2) / 2.0, Drawing::Line::centre});
    return;
  }
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Point p : s.mate.outline) low = std::min(low, p.y), high = std::max(high, p.y);
  view.paths.push_back({{{s.pitch.x, low}, {s.pitch.x, high}}, Drawing::Line::centre});
}

/// The full width of the pair, over which its teeth are small or large.
double width_of(const Scene& s) {
  if (s.in.mesh == Mesh::internal) return 2.0 * s.mate.rim;
  if (s.in.mesh == Mesh::rack) return in_si(s.r.d_a1);
  return in_si(s.r.a_w) + 0.5 * in_si(s.r.d_a1) + 0.5 * in_si(s.r.d_a2);
}

/// Teeth so fine that they would be a black band: their tip and root circles.
void add_circles_for_teeth(const Scene& s, Drawing::View& view) {
  view.circles.push_back({{}, in_si(s.r.d_a1) / 2.0, Drawing::Line::outline, true});
  view.circles.push_back({{}, in_si(s.r.d_f1) / 2.0, Drawing::Line::thin});
  if (s.in.mesh == Mesh::rack) {
    view.paths.push_back({s.mate.outline, Drawing::Line::outline, true});
    return;
  }
  view.circles.push_back({s.mate.at, in_si(s.r.d_a2) / 2.0, Drawing::Line::outline, !s.mate.is_ring});
  view.circles.push_back({s.mate.at, in_si(s.r.d_f2) / 2.0, Drawing::Line::thin});
}

void add_turns(const Scene& s, Drawing::View& view) {
  const double r_1 = 0.5 * s.pitch.x;
  const bool ccw = s.in.turns == Turns::ccw;
  Drawing::Turn one{{}, r_1, ccw, 0.5 * pi};
  if (is_set(s.in.n_1)) one.value = Drawing::Value{"n_1", in_si(s.in.n_1), "rpm"};
  view.turns.push_back(std::move(one));
  if (s.in.mesh == Mesh::rack) return;
  Drawing::Turn two{s.mate.at, in_si(s.r.d_w2) / 4.0, s.mate.is_ring ? ccw : !ccw, s.mate.is_ring ? pi : 0.5 * pi};
  if (s.mate.is_ring) two.radius = 0.86 * in_si(s.r.d_a2) / 2.0;
  if (is_set(s.r.n_2)) two.value = Drawing::Value{"n_2", std::abs(in_si(s.r.n_2)), "rpm"};
  view.turns.push_back(std::move(two));
}

/// Forces of the flanks on gear 1, in the plane: along the pitch circles and away from gear 2.
void add_forces(const Scene& s, Drawing::View& view) {
  if (!is_set(s.r.F_x1) || !(s.r.F_tw > 0.0 * N)) return;
  view.forces.push_back({s.pitch, {0.0, in_si(s.r.F_y1)}, {"F_tw", in_si(s.r.F_tw), "N"}, false});
  view.note = say("forces on gear 1").text();
  view.forces.push_back({s.pitch, {in_si(s.r.F_x1), 0.0}, {"F_rw", in_si(s.r.F_rw), "N"}, false});
}

Drawing::View whole(const Scene& s) {
  constexpr double page = 400.0, finest = 3.5;  // view units: of the page, of a pitch
  Drawing::View view;
  view.most_height = 380.0;
  if (pi * s.m_t * page / width_of(s) > finest)
    add_bodies(s, view);
  else
    add_circles_for_teeth(s, view);
  add_pitch_circles(s, view);
  const double low = -0.5 * in_si(s.r.d_w1), a_w = in_si(s.r.a_w);
  if (s.in.mesh == Mesh::rack) {
    view.lengths.push_back({{0.0, low}, {s.mate.at.x, low}, {"a_w", a_w, "mm"}, Drawing::Side::below});
  } else {
    view.lengths.push_back({{0.0, 0.0}, s.mate.at, {"a_w", a_w, "mm"}, Drawing::Side::below});
    view.paths.push_back({{{0.0, 0.0}, s.mate.at}, Drawing::Line::centre});
  }
  const auto diameter = [&](Point at, double d, const char* symbol, Drawing::Side side) {
    view.lengths.push_back({{at.x, at.y - 0.5 * d}, {at.x, at.y + 0.5 * d}, {symbol, d, "mm"}, side});
  };
  const bool ring = s.mate.is_ring;
  diameter({}, in_si(s.r.d_w1), "d_w1", ring ? Drawing::Side::right : Drawing::Side::left);
  diameter({}, in_si(s.r.d_a1), "d_a1", ring ? Drawing::Side::right : Drawing::Side::left);
  if (s.in.mesh != Mesh::rack) {
    diameter(s.mate.at, in_si(s.r.d_w2), "d_w2", ring ? Drawing::Side::left : Drawing::Side::right);
    diameter(s.mate.at, in_si(s.r.d_a2), "d_a2", ring ? Drawing::Side::left : Drawing::Side::right);
  }
  view.names.push_back({{}, "1", Drawing::Value{"z_1", static_cast<double>(s.in.z_1), ""}});
  if (s.in.mesh != Mesh::rack)
    view.names.push_back({s.mate.at, "2", Drawing::Value{"z_2", static_cast<double>(s.in.z_2), ""}});
  add_turns(s, view);
  add_forces(s, view);
  if (ring) {
    const std::string rim = say("the rim of the ring is drawn two modules thick").text();
    view.note = view.note.empty() ? rim : view.note + "; " + rim;
  }
  return view;
}

Drawing::View mesh(const Scene& s) {
  Drawing::View view;
  view.title = say("the mesh at the pitch point").text();
  const Point begins = s.on_line(-s.g_f), ends = s.on_line(s.g_a);
  const double low = std::min({begins.y, ends.y, 0.0}) - 0.9 * s.m_t,
               high = std::max({begins.y, ends.y, 0.0}) + 0.9 * s.m_t;
  const double left = std::min({begins.x, ends.x, s.pitch.x - 1.8 * s.m_t}) - 0.5 * s.m_t;
  const double right = std::max({begins.x, ends.x, s.pitch.x + 1.8 * s.m_t}) + 0.5 * s.m_t;
  const double spread = std::max(0.0, 0.5 * (1.4 * (high - low) - (right - left)));
  view.window = Drawing::View::Window{{left - spread, low}, {right + spread, high}};
  add_bodies(s, view);
  add_pitch_circles(s, view);
  view.circles.push_back({{}, in_si(s.r.d_a1) / 2.0, Drawing::Line::thin});
  view.circles.push_back({{}, in_si(s.r.d_b1) / 2.0, Drawing::Line::hidden});
  if (s.in.mesh != Mesh::rack) {
    view.circles.push_back({s.mate.at, in_si(s.r.d_a2) / 2.0, Drawing::Line::thin});
    view.circles.push_back({s.mate.at, in_si(s.r.d_b2) / 2.0, Drawing::Line::hidden});
  }
  const double far = 2.0 * (high - low);
  view.paths.push_back({{s.on_line(-far), s.on_line(far)}, Drawing::Line::action});
  view.paths.push_back({{{s.pitch.x, low}, {s.pitch.x, high}}, Drawing::Line::thin});
  view.paths.push_back({{begins, ends}, Drawing::Line::contact});
  const double up = side_of(s.in), reach = 0.8 * (up > 0.0 ? high : -low);
  view.angles.push_back({s.pitch, reach, up * 0.5 * pi, -up * s.r.alpha_wt, {"alpha_wt", s.r.alpha_wt, "deg"}});
  view.names = {{s.pitch, "C"}, {begins, "A"}, {ends, "E"}};
  view.names.push_back({s.on_line(0.35 * s.g_a), say("path of contact").text(),
                        Drawing::Value{"g_alpha", in_si(s.r.g_alpha), "mm"}, false});
  view.note = say("pitch circles, tip circles, base circles dashed; contact from A to E").text();
  return view;
}

}  // namespace

Body first_body(const Pair::Input& in, const PairResult& r) {
  return {transverse(in, r),   in_si(r.m_t),        in.z_1, (in.x_1 + shift_of(in, in.A_s1)) * std::cos(in.beta),
          in_si(r.d_a1) / 2.0, in_si(r.d_f1) / 2.0, {},     0.0};
}

Body second_body(const Pair::Input& in, const PairResult& r) {
  const double distance = in_si(r.a_w);
  Body b{transverse(in, r),   in_si(r.m_t),        in.z_2, (r.x_2 + shift_of(in, in.A_s2)) * std::cos(in.beta),
         in_si(r.d_a2) / 2.0, in_si(r.d_f2) / 2.0, {},     0.0};
  b.at = {in.mesh == Mesh::internal ? -distance : distance, 0.0};
  b.turn = in.mesh == Mesh::internal ? 0.0 : pi - pi / in.z_2;
  return b;
}

std::vector<Point> rim_of(Point centre, double radius) { return figure::polygon_of_circle(centre, radius, 360); }

std::vector<figure::Figure> Pair::figures(const Input& in, const Result& r) {
  if (!is_set(r.eps_alpha) || !is_set(r.j_bn) || !has_teeth(in, r)) return {};
  const Scene scene(in, r);
  auto drawing = std::make_shared<Drawing>();
  drawing->views = {whole(scene), mesh(scene)};
  return {{"pair", "The pair in the transverse plane, and its teeth in mesh", figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
