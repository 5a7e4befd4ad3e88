// Places, velocities and accelerations of links and of their points, and what inertia loads links with.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;

struct MovingLink {
  std::string name;
  std::size_t index;
};

constexpr std::array link_rows{
    row<MovingLink>("links.NAME.phi", "angle of the link's axes", deg, {.kind = Kind::direction, .detail = true},
                    [](const MovingLink& l, const Position& p) { return p.pose[l.index].phi; }),
    row<MovingLink>("links.NAME.omega", "angular velocity", rad_per_s, {.detail = true},
                    [](const MovingLink& l, const Position& p) { return p.velocity[l.index].phi; }),
    row<MovingLink>("links.NAME.epsilon", "angular acceleration", rad_per_s2, {.detail = true},
                    [](const MovingLink& l, const Position& p) { return p.acceleration[l.index].phi; })};

/// Loaded by inertia as d'Alembert's principle has it: [A10] (10.3).
struct HeavyLink {
  std::string name;
  std::size_t index;
  mechanism::Vec centre;
  double mass, inertia;

  struct Inertia {
    mechanism::Vec force;
    double moment;
  };
  [[nodiscard]] Inertia now(const Position& p) const {
    const PointMotion m = motion_of(p, static_cast<int>(index), centre);
    return {-mass * m.acceleration, -inertia * p.acceleration[index].phi};
  }
  static bool has_mass(const HeavyLink& l) { return l.mass > 0.0; }
  static bool has_inertia(const HeavyLink& l) { return l.inertia > 0.0; }
};

constexpr std::array inertia_rows{
    row<HeavyLink>(
        "links.NAME.F_i", "magnitude of the inertia force at the mass centre, m a_S", N, {.detail = true},
        [](const HeavyLink&, const HeavyLink::Inertia& i) { return mechanism::length(i.force); }, &HeavyLink::has_mass,
        "links with a mass, if inertia is included"),
    row<HeavyLink>(
        "links.NAME.F_ix", "inertia force along x, -m a_Sx", N, {.detail = true},
        [](const HeavyLink&, const HeavyLink::Inertia& i) { return i.force.x; }, &HeavyLink::has_mass,
        "links with a mass, if inertia is included"),
    row<HeavyLink>(
        "links.NAME.F_iy", "inertia force along y, -m a_Sy", N, {.detail = true},
        [](const HeavyLink&, const HeavyLink::Inertia& i) { return i.force.y; }, &HeavyLink::has_mass,
        "links with a mass, if inertia is included"),
    row<HeavyLink>(
        "links.NAME.M_i", "inertia moment about the mass centre, -J epsilon, counter-clockwise positive", N_m,
        {.detail = true}, [](const HeavyLink&, const HeavyLink::Inertia& i) { return i.moment; },
        &HeavyLink::has_inertia, "links with a moment of inertia, if inertia is included")};

struct MovingPoint {
  std::string name;
  TracedPoint traced;

  [[nodiscard]] PointMotion now(const Position& p) const { return motion_of(p, traced.link, traced.at); }
};

constexpr std::array point_rows{
    row<MovingPoint>("points.NAME.x", "position along x", mm, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.place.x; }),
    row<MovingPoint>("points.NAME.y", "position along y", mm, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.place.y; }),
    row<MovingPoint>("points.NAME.v", "speed", m_per_s, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return mechanism::length(m.velocity); }),
    row<MovingPoint>("points.NAME.v_x", "velocity along x", m_per_s, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.velocity.x; }),
    row<MovingPoint>("points.NAME.v_y", "velocity along y", m_per_s, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.velocity.y; }),
    row<MovingPoint>("points.NAME.a", "magnitude of the acceleration", m_per_s2, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return mechanism::length(m.acceleration); }),
    row<MovingPoint>("points.NAME.a_x", "acceleration along x", m_per_s2, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.acceleration.x; }),
    row<MovingPoint>("points.NAME.a_y", "acceleration along y", m_per_s2, {.detail = true},
                     [](const MovingPoint&, const PointMotion& m) { return m.acceleration.y; })};

void list_places(std::vector<ResultPattern>& patterns) {
  list_patterns(link_rows, patterns);
  list_patterns(inertia_rows, patterns);
  list_patterns(point_rows, patterns);
}

void add_places(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const mechanism::Link& link = model.links[k];
    add_outputs(MovingLink{link.name, k}, link_rows, out);
    if (leaves_out_inertia(in)) continue;
    add_outputs(HeavyLink{link.name, k, link.centre, link.mass, link.inertia}, inertia_rows, out);
  }
  for (const TracedPoint& point : traced_points(in)) add_outputs(MovingPoint{point.name, point}, point_rows, out);
}

}  // namespace

constinit const Aspect aspects::places{.list = &list_places, .add_outputs = &add_places};

}  // namespace loadpath::planar
