// The set in the transverse plane: sun, planets as assembled, ring, carrier, and each direction of rotation.
#include "calculators/gear/pair_bodies.hpp"
#include "calculators/gear/planetary/meshes.hpp"
#include "calculators/gear/planetary/planetary.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/figure/point.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::gear {

namespace {

using figure::at_angle;
using figure::Drawing;
using figure::Point;

/// The bodies with their teeth in mesh.
struct Set {
  Body sun, ring;
  std::vector<Body> planets;
  double carrier = 0.0;  // radius of the circle of the planets' axes
};

/// Rotation of a gear, whose tooth lies at `turn`, past the direction, in teeth.
double past(double direction, double turn, double z) { return (direction - turn) * z / (2.0 * pi); }

Set set_of(const Planetary::Input& in, const SetMeshes& m, const Planetary::Result& r) {
  Set set;
  set.carrier = in_si(m.with_sun.a_w);
  set.sun = first_body(m.sun, m.with_sun), set.sun.turn = 0.5 * pi;
  const Body planet = first_body(m.ring, m.with_ring);
  const double step = 2.0 * pi / (in.z_s + r.z_r);
  for (int k = 0; k < in.N_p; ++k) {
    Body b = planet;
    const double theta = 0.5 * pi + step * std::round(k * r.q);
    b.at = at_angle(theta, set.carrier);
    // A space of the planet faces the tooth of the sun: both move in the same direction through the pitch point.
    b.turn = theta + pi + 2.0 * pi / in.z_p * (past(theta, set.sun.turn, in.z_s) + 0.5);
    set.planets.push_back(b);
  }
  set.ring = second_body(m.ring, m.with_ring), set.ring.at = {};
  const double theta = 0.5 * pi;
  set.ring.turn = theta - 2.0 * pi / r.z_r * past(theta, set.planets.front().turn, in.z_p);
  return set;
}

void add_wheel(const Body& b, bool has_teeth, const std::string& name, Drawing::View& view) {
  if (!has_teeth) {
    view.circles.push_back({b.at, b.r_a, Drawing::Line::outline, true});
    view.circles.push_back({b.at, b.r_f, Drawing::Line::thin});
    return;
  }
  const std::vector<Point> outline = wheel_outline(b);
  view.areas.push_back({outline, Drawing::Kind::body, name});
  view.paths.push_back({outline, Drawing::Line::outline, true});
}

double rim_radius(const Body& ring) { return ring.r_f + 2.0 * ring.m_t; }

void add_ring(const Body& b, bool has_teeth, Drawing::View& view) {
  const std::vector<Point> inside = has_teeth ? ring_outline(b) : rim_of(b.at, b.r_a);
  view.areas.push_back({rim_of(b.at, rim_radius(b)), Drawing::Kind::body, say("ring").text(), inside});
  view.paths.push_back({inside, Drawing::Line::outline, true});
  view.circles.push_back({b.at, rim_radius(b), Drawing::Line::thin});
  if (!has_teeth) view.circles.push_back({b.at, b.r_f, Drawing::Line::thin});
}

void add_carrier(const Set& set, Drawing::View& view) {
  view.circles.push_back({{}, set.carrier, Drawing::Line::centre});
  for (const Body& b : set.planets) view.paths.push_back({{{}, b.at}, Drawing::Line::hidden});
}

/// Label of a member, in a corner of the picture; with an arrow if it rotates.
struct Member {
  const char* name;
  const char* symbol;
  AngularSpeed n;
  std::optional<Point> named_at;  // on the member, where there is room
  Point centre;                   // centre of the arrow
  double radius, around;
  Point corner;
  std::optional<Drawing::Value> teeth;
};

void add_member(const Member& m, double line, Drawing::View& view) {
  const std::string name = say(m.name).text();
  if (m.named_at) view.names.push_back({*m.named_at, name, std::nullopt, false});
  Point corner = m.corner;
  view.names.push_back({corner, name, m.teeth, false});
  corner.y -= line;
  if (!is_set(m.n)) return;
  if (m.n == 0.0 * rpm) {
    view.names.push_back({corner, say("at rest").text(), std::nullopt, false});
    return;
  }
  const double speed = in_si(m.n);
  view.names.push_back({corner, "", Drawing::Value{m.symbol, speed, "rpm"}, false});
  view.turns.push_back({m.centre, m.radius, speed > 0.0, m.around});
}

void add_members(const Planetary::Input& in, const Planetary::Result& r, const Set& set, Drawing::View& view) {
  const double between = 0.5 * pi + pi / static_cast<double>(in.N_p), rim = rim_radius(set.ring);
  const double x = 1.08 * rim, y = 0.9 * rim;
  const Body& planet = set.planets.front();
  const auto teeth = [](const char* symbol, double z) { return Drawing::Value{symbol, z, ""}; };
  const Member members[] = {
      {"sun", "n_s", r.n_s, Point{}, {}, 0.62 * set.sun.r_f, -0.5 * pi, {-x, y}, teeth("z_s", in.z_s)},
      {"planet", "n_p", r.n_p, planet.at, planet.at, 0.62 * planet.r_f, 0.5 * pi, {x, y}, teeth("z_p", in.z_p)},
      {"carrier", "n_c", r.n_c, at_angle(between, set.carrier), {}, set.carrier, between, {-x, -0.8 * y}, {}},
      {"ring", "n_r", r.n_r, std::nullopt, {}, 1.04 * rim, 0.0, {x, -0.8 * y}, teeth("z_r", r.z_r)}};
  for (const Member& m : members) add_member(m, 0.12 * rim, view);
}

}  // namespace

std::vector<figure::Figure> Planetary::figures(const Input& in, const Result& r) {
  constexpr double page = 380.0, finest = 3.5;  // view units: of the page, of a pitch
  const SetMeshes m = meshes_of(in);
  const bool meshed = is_set(m.with_sun.eps_alpha) && is_set(m.with_ring.eps_alpha) && has_teeth(m.sun, m.with_sun) &&
                      has_teeth(m.ring, m.with_ring);
  if (!meshed || !is_set(r.q)) return {};
  const Set set = set_of(in, m, r);
  auto drawing = std::make_shared<Drawing>();
  Drawing::View view;
  view.most_height = 400.0;
  view.is_scaled = is_set(in.m_n);
  const bool has_room = pi * set.sun.m_t * page / (2.0 * rim_radius(set.ring)) > finest;
  add_ring(set.ring, has_room, view);
  add_wheel(set.sun, has_room, say("sun").text(), view);
  for (const Body& b : set.planets) add_wheel(b, has_room, say("planet").text(), view);
  add_carrier(set, view);
  add_members(in, r, set, view);
  const std::string rim = say("the rim of the ring is drawn two modules thick").text();
  view.note = view.is_scaled ? rim : say("{1}; no module is given", rim).text();
  drawing->views = {std::move(view)};
  return {{"set", "Sun, planets, ring and carrier in the transverse plane; speeds are positive counter-clockwise",
           figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::gear
