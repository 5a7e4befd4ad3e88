// Places, velocities and accelerations of links and of their points.
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
  list_patterns(point_rows, patterns);
}

void add_places(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t k = 0; k < model.links.size(); ++k) add_outputs(MovingLink{model.links[k].name, k}, link_rows, out);
  for (const TracedPoint& point : traced_points(in)) add_outputs(MovingPoint{point.name, point}, point_rows, out);
}

}  // namespace

constinit const Aspect aspects::places{.list = &list_places, .add_outputs = &add_places};

}  // namespace loadpath::planar
