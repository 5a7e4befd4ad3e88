#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct CamArm : CamProfile {
  static constexpr auto id = "cam_arm";
  static constexpr auto title = "Cam with oscillating roller or knife-edge follower";
  static constexpr auto doc =
      "The cam turns about the origin O; an arm AB turns about A on the x axis and has a roller about B, or an edge "
      "there. The law of its swing begins at the crank angle 0.";
  static constexpr auto example = R"([shear]
calculator = "mechanism.planar"
template = "cam_arm"
gravity = "0 m/s^2"
base = "30 mm"
roller = "8 mm"
pivot = "80 mm"
arm = "70 mm"
segments = [{ law = "4-5-6-7", angle = "120 deg", swing = "15 deg" }, { angle = "30 deg" }, { law = "4-5-6-7", angle = "120 deg", swing = "-15 deg" }, { angle = "90 deg" }]
crank = { speed = "120 rpm", positions = 72 }
links.arm.mass = "0.6 kg"
loads = [{ link = "arm", at = "B", F_x = "0 N", F_y = "-300 N" }]
)";

  static constexpr Fields fields{
      Field{&CamArm::base, "base", mm, "radius of the base circle of the cam itself"}.positive(),
      Field{&CamArm::roller, "roller", mm, "radius of the roller; 0: an edge"}.at_least(0),
      Field{&CamArm::pivot, "pivot", mm, "distance of the pivot A from the cam's axis"}.positive(),
      Field{&CamArm::arm, "arm", mm, "length of the arm AB"}.positive(),
      Choice{&CamArm::side, "side", "of the roller: left is above the x axis, right below it"}.may_be_missing(),
      Choice{&CamArm::sense, "sense", "direction of rotation of the cam for the order of the segments"}
          .may_be_missing(),
      ListField{&CamArm::segments, "segments", "rises, dwells and falls over a turn, by their swing"}};

  void draw(Sketch& sketch) const {
    CamProfile profile = *this;
    profile.name = "lobe";
    profile.shape = Shape::swinging;
    const Pin A{"A", {in_si(pivot), 0.0}}, B{"B", sketch.follower_at(profile, 0.0)};
    sketch.turning_cam();
    sketch.fixed(A);
    sketch.bar("arm", A, B, arm);
    sketch.revolute("A", "ground", "arm");
    sketch.cam("contact", {"arm", "cam"}, {"B", "O"}, profile, 0.0);
  }
};

template const MechanismTemplate& mechanism_template<CamArm>();

}  // namespace loadpath::planar::templates
