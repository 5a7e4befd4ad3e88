#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct CamFollower : CamProfile {
  static constexpr auto id = "cam_follower";
  static constexpr auto title = "Cam with translating roller or knife-edge follower";
  static constexpr auto doc =
      "The cam turns about the origin O; its follower slides along y and has a roller about B, or an edge there. The "
      "law of its lift begins at the crank angle 0.";
  static constexpr auto example = R"([valve]
calculator = "mechanism.planar"
template = "cam_follower"
gravity = "0 m/s^2"
base = "30 mm"
roller = "10 mm"
segments = [{ law = "cycloidal", angle = "90 deg", lift = "12 mm" }, { angle = "40 deg" }, { law = "3-4-5", angle = "110 deg", lift = "-12 mm" }, { angle = "120 deg" }]
crank = { speed = "300 rpm", positions = 72 }
links.cam.mass = "1.5 kg"
links.follower.mass = "0.8 kg"
ground.T = ["0 mm", "100 mm"]
springs.spring = { links = ["follower", "ground"], points = ["B", "T"], k = "8 N/mm", free = "75 mm" }
)";

  static constexpr Fields fields{
      Field{&CamFollower::base, "base", mm, "radius of the base circle of the cam itself"}.positive(),
      Field{&CamFollower::roller, "roller", mm, "radius of the roller; 0: an edge"}.at_least(0),
      Field{&CamFollower::offset, "offset", mm, "of the guide, to the left of the cam's axis"},
      Choice{&CamFollower::sense, "sense", "direction of rotation of the cam for the order of the segments"}
          .may_be_missing(),
      ListField{&CamFollower::segments, "segments", "rises, dwells and falls over a turn"}};

  void draw(Sketch& sketch) const {
    constexpr double up = pi / 2.0;
    CamProfile profile = *this;
    profile.name = "lobe";
    profile.shape = Shape::sliding;
    const Pin G{"G", {-in_si(offset), 0.0}}, B{"B", sketch.follower_at(profile, up)};
    sketch.turning_cam();
    sketch.fixed(G);
    sketch.block("follower", B, 0.0);
    sketch.prismatic("guide", {"follower", "ground"}, {"B", "G"}, up);
    sketch.cam("contact", {"follower", "cam"}, {"B", "O"}, profile, up);
  }
};

template const MechanismTemplate& mechanism_template<CamFollower>();

}  // namespace loadpath::planar::templates
