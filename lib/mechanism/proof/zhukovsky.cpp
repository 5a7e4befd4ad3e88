#include "lib/mechanism/proof/zhukovsky.hpp"

#include "lib/mechanism/model/point_motion.hpp"

namespace loadpath::mechanism {
namespace {

class Lever {
 public:
  Lever(const Instant& instant, std::size_t driver, ZhukovskyLever& lever)
      : instant_(instant), driver_(driver), lever_(lever) {
    lever_.forces.clear();
    lever_.effort = 0.0;
  }

  void hang(const ActiveForce& active, Vec arm, Vec force, bool of_couple) {
    const Vec at = image(instant_, driver_, active.link, arm);
    const double moment = cross(at, force), size = length(force);
    lever_.forces.push_back({.kind = active.kind,
                             .index = active.index,
                             .link = active.link,
                             .of_couple = of_couple,
                             .image = at,
                             .force = force,
                             .arm = size > 0.0 ? moment / size : 0.0});
    lever_.effort -= moment;
  }

  /// At the origin of the link's frame and at the mechanism's length from there.
  void hang_pair(const ActiveForce& active) {
    const Vec along = instant_.constraints().turned(active.link)({1.0, 0.0});
    const Vec force = (active.couple / instant_.length()) * normal(along);
    hang(active, instant_.length() * along, force, true);
    hang(active, {}, -force, true);
  }

 private:
  const Instant& instant_;
  std::size_t driver_;
  ZhukovskyLever& lever_;
};

}  // namespace

Vec image(const Instant& instant, std::size_t driver, std::size_t link, Vec arm) {
  const Pose velocity = instant.virtual_velocity(driver, link);
  return (-1.0 / instant.virtual_rate(driver)) * normal(point_velocity(velocity, arm));
}

void find_lever(const Instant& instant, std::size_t driver, ZhukovskyLever& lever) {
  Lever plan(instant, driver, lever);
  for (const ActiveForce& active : instant.active()) {
    if (active.force.x != 0.0 || active.force.y != 0.0) plan.hang(active, active.arm, active.force, false);
    if (active.couple != 0.0) plan.hang_pair(active);
  }
}

}  // namespace loadpath::mechanism
