#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct LoaderArm {
  static constexpr auto id = "loader_arm";
  static constexpr auto title = "Loader arm with bucket and two cylinders";
  static constexpr auto doc =
      "The arm BH turns about the origin B, lifted by the cylinder OA; the bucket HM turns about "
      "the arm's end H, tilted by the cylinder EG between arm and bucket. A and E are given in "
      "the arm's axes (origin B, x to H), G in those of the bucket (origin H, x to the edge M). "
      "The lengths of the cylinders define its position.";
  static constexpr auto example = R"([loader]
calculator = "mechanism.planar"
template = "loader_arm"
x_O = "200 mm"
y_O = "-600 mm"
l = "2 m"
x_A = "900 mm"
y_A = "-100 mm"
s_1 = "1 m"
x_E = "600 mm"
y_E = "250 mm"
l_2 = "800 mm"
x_G = "50 mm"
y_G = "300 mm"
s_2 = "1.35 m"
positions = 20
cylinders.lift = { speed = "50 mm/s", to = "1.15 m" }
gravity = "9.81 m/s^2"
links.arm.mass = "180 kg"
links.bucket.mass = "120 kg"
loads = [{ link = "bucket", at = "M", F_x = "0 kN", F_y = "-5 kN" }]
)";

  Length x_O = unset<Length>, y_O = unset<Length>, l = unset<Length>;
  Length x_A = unset<Length>, y_A = unset<Length>, s_1 = unset<Length>;
  Length x_E = unset<Length>, y_E = unset<Length>, l_2 = unset<Length>;
  Length x_G = unset<Length>, y_G = unset<Length>, s_2 = unset<Length>;
  Assembly assembly = Assembly::open, assembly_2 = Assembly::open;
  static constexpr Fields fields{
      Field{&LoaderArm::x_O, "x_O", mm, "fixed pin O of the lift cylinder"},
      Field{&LoaderArm::y_O, "y_O", mm, "fixed pin O of the lift cylinder"},
      Field{&LoaderArm::l, "l", mm, "length of the arm BH"}.positive(),
      Field{&LoaderArm::x_A, "x_A", mm, "pin A of the lift cylinder on the arm"},
      Field{&LoaderArm::y_A, "y_A", mm, "pin A of the lift cylinder on the arm"},
      Field{&LoaderArm::s_1, "s_1", mm, "length of the lift cylinder OA in the stated position"}.positive(),
      Field{&LoaderArm::x_E, "x_E", mm, "pin E of the tilt cylinder on the arm"},
      Field{&LoaderArm::y_E, "y_E", mm, "pin E of the tilt cylinder on the arm"},
      Field{&LoaderArm::l_2, "l_2", mm, "length of the bucket HM"}.positive(),
      Field{&LoaderArm::x_G, "x_G", mm, "pin G of the tilt cylinder on the bucket"},
      Field{&LoaderArm::y_G, "y_G", mm, "pin G of the tilt cylinder on the bucket"},
      Field{&LoaderArm::s_2, "s_2", mm, "length of the tilt cylinder EG in the stated position"}.positive(),
      Choice{&LoaderArm::assembly, "assembly", "A is left of the line from B to O: open, or right of it: crossed"}
          .may_be_missing(),
      Choice{&LoaderArm::assembly_2, "assembly_2", "G is left of the line from E to H: open, or right of it: crossed"}
          .may_be_missing()};

  void draw(Sketch& sketch) const {
    const Pin O{"O", cartesian(x_O, y_O)}, B{"B", {0.0, 0.0}};
    const Vec a = cartesian(x_A, y_A), g = cartesian(x_G, y_G);  // in the axes of arm and bucket
    const Pin A{"A", sketch.meet({"arm", B.at, from_si<Length>(mechanism::length(a))}, PlacedLink{"lift", O.at, s_1},
                                 assembly)};
    const double arm = direction(B.at, A.at) - direction({}, a);
    const Pin H{"H", polar(l, arm)}, E{"E", mechanism::turn(arm)(cartesian(x_E, y_E))};
    const Pin G{"G", sketch.meet({"tilt", E.at, s_2}, PlacedLink{"bucket", H.at, from_si<Length>(mechanism::length(g))},
                                 assembly_2)};
    const Pin M{"M", H.at + polar(l_2, direction(H.at, G.at) - direction({}, g))};
    sketch.fixed(O);
    sketch.fixed(B);
    sketch.bar("arm", B, H, l);
    sketch.point("A", a);
    sketch.point("E", cartesian(x_E, y_E));
    sketch.bar("bucket", H, M, l_2);
    sketch.point("G", g);
    sketch.revolute("B", "ground", "arm");
    sketch.revolute("H", "arm", "bucket");
    draw_cylinder(sketch, {"lift", "lift_barrel", "lift_rod", "lift_bore"}, {O, "ground"}, {A, "arm"});
    draw_cylinder(sketch, {"tilt", "tilt_barrel", "tilt_rod", "tilt_bore"}, {E, "arm"}, {G, "bucket"});
  }

 private:
  struct Names {
    const char *cylinder, *barrel, *rod, *bore;
  };
  struct End {
    Pin pin;
    const char* link;
  };
  static void draw_cylinder(Sketch& sketch, const Names& name, const End& from, const End& to) {
    const double along = direction(from.pin.at, to.pin.at);
    sketch.block(name.barrel, from.pin, along);
    sketch.block(name.rod, to.pin, along);
    sketch.revolute(from.pin.name, from.link, name.barrel);
    sketch.revolute(to.pin.name, name.rod, to.link);
    sketch.prismatic(name.bore, {name.rod, name.barrel}, {to.pin.name, from.pin.name});
    sketch.cylinder(name.cylinder, name.bore);
  }
};

template const MechanismTemplate& mechanism_template<LoaderArm>();

}  // namespace loadpath::planar::templates
