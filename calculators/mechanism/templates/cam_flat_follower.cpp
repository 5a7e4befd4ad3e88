#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct CamFlatFollower : CamProfile {
  static constexpr auto id = "cam_flat_follower";
  static constexpr auto title = "Cam with translating flat-faced follower";
  static constexpr auto doc =
      "The cam turns about the origin O; its follower slides along y above it and has a flat face square to that, "
      "through B. The law of its lift begins at the crank angle 0.";
  static constexpr auto example = R"([tappet]
calculator = "mechanism.planar"
template = "cam_flat_follower"
gravity = "0 m/s^2"
base = "30 mm"
segments = [{ law = "harmonic", angle = "180 deg", lift = "10 mm" }, { law = "harmonic", angle = "180 deg", lift = "-10 mm" }]
crank = { speed = "300 rpm", positions = 72 }
links.follower.mass = "0.5 kg"
loads = [{ link = "follower", at = "B", F_x = "0 N", F_y = "-150 N" }]
)";

  static constexpr Fields fields{
      Field{&CamFlatFollower::base, "base", mm, "radius of the base circle of the cam"}.positive(),
      Choice{&CamFlatFollower::sense, "sense", "direction of rotation of the cam for the order of the segments"}
          .may_be_missing(),
      ListField{&CamFlatFollower::segments, "segments", "rises, dwells and falls over a turn"}};

  void draw(Sketch& sketch) const {
    constexpr double up = pi / 2.0;
    CamProfile profile = *this;
    profile.name = "lobe";
    profile.shape = Shape::flat;
    const Pin B{"B", sketch.follower_at(profile, up)};
    sketch.turning_cam();
    sketch.block("follower", B, 0.0);
    sketch.prismatic("guide", {"follower", "ground"}, {"B", "O"}, up);
    sketch.cam("contact", {"follower", "cam"}, {"B", "O"}, profile, up, planar::Type::cam_flat);
  }
};

template const MechanismTemplate& mechanism_template<CamFlatFollower>();

}  // namespace loadpath::planar::templates
